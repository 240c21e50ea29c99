"""Founding paper: a run is its step, taken literally

A wire of 24 m between fixed points, 12 kN, 48 segments with bending and weight; a pantograph of two
masses, 60 m/s, one element in each step, rigid contact, friction 0.2. A run with point masses,
backward differences and updated kinematics works in increments, with sparse factors and cached
columns. Beside it stands the paper's step as it is written (`arcless.lcp.PublishedStep`): dense
matrices of line and pantograph together, and a chain of point masses written out in NumPy:

    A = M/τ² + C_d/τ + K,  p̂ = M u_{i−2}/τ² − B u_{i−1} − p,  H = CᵀA⁻¹C,  w = d0 − CᵀA⁻¹p̂

with K the tangent at the newest coordinates, and p such that K u − p is the force there. Both call
the same solver for the complementarity problem, and share nothing else.

With 150 N the wire is touched all the time; with 20 N contact is lost.

Source: Kolesnikov & Kuvshinov (about 2009), formula by formula on the page published-method.
"""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arcless.mesh import Mesh
from arcless.mesh.tables.parts import Parts
from tests.support import bare, schemes
from tests.support.evidence import Evidence
from tests.support.faults import Fault, gravity, scaled
from tests.support.literal_run import UP, Chain, LiteralRun, Pantograph
from tests.support.run_faults import pantograph_scaled, prepared_with, spoiled
from tests.support.structures import add_element

Floats = NDArray[np.float64]

CHAIN = Chain()
START, SPEED, FRICTION, STEPS = 6.0, 60.0, 0.2, 24
TAU = CHAIN.length / CHAIN.count / SPEED
POSITIONS = START + SPEED * TAU * np.arange(STEPS + 1)
# A⁻¹ of 96 unknowns with entries from 1 kN/m to 24 MN/m loses six digits of sixteen at most.
TOLERANCE = 1e-7
REASON = "96 unknowns with stiffnesses from 1 kN/m to 24 MN/m lose six digits of sixteen at most"


def pantograph(force: float) -> Pantograph:
    """The two masses of the paper's example, damped a little."""
    mass = np.diag([45.0, 16.0])
    damping = np.array([[150.0, -50.0], [-50.0, 50.0]])
    stiffness = np.array([[7e3, -6e3], [-6e3, 6e3]])
    return Pantograph(mass, damping, stiffness, np.array([0.0, 1.0]), force)


def mesh() -> Mesh:
    parts = Parts()
    rows = [
        add_element(
            parts, i, rest=CHAIN.rest_length, axial=CHAIN.axial, mass=CHAIN.mass,
            tension=CHAIN.tension,
        )
        for i in range(CHAIN.count)
    ]  # fmt: skip
    for i in rows[:-1]:
        parts.add("bends", segments=(i, i + 1), bending_stiffness=CHAIN.bending, beta=0.0)
    bare.hold(parts, (0, CHAIN.count))
    points = np.insert(CHAIN.positions, UP, 0.0, axis=1)
    return replace(bare.planar(points, parts, rows), gravity=CHAIN.gravity)


def run(force: float) -> tuple[Floats, Floats]:
    """Contact forces and gaps of a run."""
    p = pantograph(force)
    head = bare.pantograph(p.mass, p.damping, p.stiffness, strip=p.strip.tolist(), force=force)
    asked = bare.Asked(schemes.PUBLISHED, TAU, POSITIONS, updated=True, friction=FRICTION)
    found = bare.run(mesh(), head, asked)
    assert sum(found["pivot_counts"]) == STEPS, "one problem in each step"
    return np.asarray(found["force"]), np.asarray(found["gap"])


@cache
def literal(force: float) -> tuple[Floats, Floats]:
    """Contact forces and gaps of the literal steps."""
    stepped = LiteralRun(CHAIN, pantograph(force), START, TAU)
    forces, gaps, last = [], [], np.array([force])
    for x in POSITIONS[1:]:
        step = stepped.advance(float(x), FRICTION, last)
        last = step.force
        forces.append(step.force[0])
        gaps.append(step.gap[0])
    return np.array(forces), np.array(gaps)


@pytest.mark.parametrize(
    ("force", "opens"), [pytest.param(150.0, False, marks=pytest.mark.evidence), (20.0, True)]
)
def test_every_step(evidence: Evidence, force: float, opens: bool) -> None:
    forces, gaps = run(force)
    exact, exact_gaps = literal(force)
    assert ((exact == 0).any(), exact.max() > 2.0 * exact.min()) == (opens, True)
    evidence.below(
        f"{force:g} N: contact force in {STEPS} steps, largest difference over largest force",
        float(np.abs(forces - exact).max() / exact.max()),
        TOLERANCE,
        unit="1",
        reason=REASON,
    )
    if opens:
        assert ((forces > 0) == (exact > 0)).all()
        evidence.below(
            f"{force:g} N: gap in {STEPS} steps, largest difference over largest gap",
            float(np.abs(gaps - exact_gaps).max() / exact_gaps.max()),
            TOLERANCE,
            unit="1",
            reason=REASON,
        )


def without_friction(arguments: dict[str, Any]) -> None:
    arguments["friction"] = 0.0


TOUCHING = {"force": 150.0, "opens": False}
LEAVING = {"force": 20.0, "opens": True}
FAULTS = [
    Fault("kinematics about the state at rest", prepared_with(updated=lambda updated: not updated),
          test_every_step, **TOUCHING),
    Fault("another scheme",
          prepared_with(scheme=lambda _: (schemes.DEFAULT.name, list(schemes.DEFAULT.numbers))),
          test_every_step, **TOUCHING),
    Fault("a contact that yields by 1 nm/N", prepared_with(contact_stiffness=lambda _: 1e9),
          test_every_step, **LEAVING),
    Fault("EA 0.01 % high", scaled("segments", "EA", 1.0001), test_every_step, **TOUCHING),
    Fault("EI 0.1 % high", scaled("bends", "EI", 1.001), test_every_step, **TOUCHING),
    Fault("weight 0.1 % high", gravity(1.001), test_every_step, **LEAVING),
    Fault("dampers 0.1 % high", pantograph_scaled("damping", 1.001), test_every_step, **LEAVING),
    Fault("no friction", spoiled(running=without_friction), test_every_step, **TOUCHING),
]  # fmt: skip
