"""Time step with updated kinematics, on large swings

A mass m = 2 kg hangs in the middle of two strings of a metre each (EA = 20 kN, stretched by 0.1 %)
and is pushed aside by a force `400 N sin⁴(π t/0.2 s)`, by as much as 0.4 m:

    m u'' = f(t) − 2 N u/ℓ,   ℓ = √(1 + u²) m,   N = EA (ℓ/ℓ₀ − 1)

At rest the strings carry 20 N, at the turning point 1.7 kN: a calculation about the state at rest
would miss everything. Each step with updated kinematics is linear about its start. The error of
that is of the second order in what happens in a step (derived here), so that a scheme keeps its
order: 2, or 1 for Newmark with γ > ½ and for one-sided differences.

Reference: the equation above by an explicit Runge–Kutta method of order 8 with a tolerance of 1e-13
(scipy, DOP853). The program is asked with a chain of point masses, of which one is free; largest
error over 0.5 s.
"""

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from arcless.mesh import Mesh
from arcless.mesh.tables.parts import Parts
from arcless.simulate.setup.core_data import LoadData
from tests.support import bare, schemes
from tests.support.faults import Fault, scaled
from tests.support.run_faults import prepared_with, stepped_by
from tests.support.schemes import Member
from tests.support.structures import add_element

Floats = NDArray[np.float64]

MASS, AXIAL, REST, DURATION = 2.0, 2e4, 0.999, 0.5
STEPS = (1e-3, 5e-4, 2.5e-4, 1.25e-4)
SHORTER = (1.25e-4, 6.25e-5, 3.125e-5)


def force(t: Any) -> Any:
    """Force at instants, N."""
    return 400.0 * np.sin(np.pi * np.clip(t, 0.0, 0.2) / 0.2) ** 4


@cache
def exact() -> Any:
    """Displacement in m, as a function of time in s."""

    def rates(t: float, state: Floats) -> list[float]:
        length = np.hypot(1.0, state[0])
        tension = AXIAL * (length / REST - 1.0)
        return [state[1], float(force(t) - 2.0 * tension * state[0] / length) / MASS]

    # As exact as numbers are: far below what the finest step leaves.
    return solve_ivp(
        rates, (0.0, DURATION), [0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15,
        max_step=1e-3, dense_output=True,
    ).sol  # fmt: skip


def strings() -> Mesh:
    """Two strings with the mass between them, node 2; a wall in front."""
    parts = Parts()
    pull = AXIAL * (1.0 / REST - 1.0)
    rows = [
        add_element(parts, i, rest=REST, axial=AXIAL, mass=1e-3, tension=pull) for i in range(3)
    ]
    bare.hold(parts, (0, 1, 3))
    parts.fix(2, 0)
    parts.add("masses", node=2, mass=MASS - REST * 1e-3, alpha=0.0)
    return bare.planar(np.array([[float(i), 0.0, 0.0] for i in range(4)]), parts, rows[:1])


def error(scheme: Member, h: float) -> float:
    """Largest error, m."""
    steps = round(DURATION / h)
    loads = [LoadData([(2, 1, 1.0)], force(h * np.arange(steps + 1)).tolist())]
    asked = bare.Asked(
        scheme, h, bare.stand(0.5, steps), nodes=[2], loads=loads, updated=True
    )  # fmt: skip
    found = bare.run(strings(), bare.free_mass(1.0, 10.0, np.zeros(steps + 1)), asked)
    return float(np.abs(found["uplift"] - exact()(found["line_time"])[0]).max())


@pytest.mark.parametrize("scheme", schemes.ALL, ids=lambda scheme: scheme.label)
def test_order(evidence: Any, scheme: Member) -> None:
    first = scheme not in schemes.SECOND_ORDER
    steps = SHORTER if first else STEPS
    evidence.order(
        f"{scheme.label}: displacement, m",
        steps,
        [error(scheme, h) for h in steps],
        1.0 if first else 2.0,
        tolerance=0.05 if first else 0.1,
        reason="the next term is ωh of the first, 0.01 at 0.125 ms for the 70 1/s at the turning"
        " point"
        if first
        else "the linear start of a step adds a term of third order: ωh of the second, 0.07 at 1 ms"
        " for the 70 1/s at the turning point",
        unit="h",
    )


FAULTS = [
    Fault("kinematics about the state at rest", prepared_with(updated=lambda updated: not updated),
          test_order, scheme=schemes.DEFAULT),
    Fault("EA 1 % high", scaled("segments", "EA", 1.01), test_order, scheme=schemes.DEFAULT),
    Fault("EA 10 % high", scaled("segments", "EA", 1.1), test_order, scheme=schemes.PUBLISHED),
    Fault("newmark with γ = 0.51 in place of 0.5", stepped_by(schemes.newmark(0.26, 0.51)),
          test_order, scheme=schemes.newmark(0.25, 0.5)),
]  # fmt: skip
