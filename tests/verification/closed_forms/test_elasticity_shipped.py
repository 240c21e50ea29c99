"""Elasticity of a shipped simple line

The two beams of `elasticity_with_sag` with the data of the shipped line `ac-simple-55`: pre-sag,
arms, clamps. What is compared is the influence of the elements: they round the kink below the force
over their own length, and come out stiffer by up to (√2/24) h/T, 4 µm/N with cubic elements of
1.45 m, a hundredth in the middle of a span and a fiftieth at a support. Chains of explicit steps
have points that yield as those of the wire do, and what they lack between points is added
(`crates/core/src/dynamics/rounded.rs`): no length of an element is left in them.

A rule of thumb for simple lines has e = L/(k (T_c + T_m)) in the middle of a span, k between 3.5
and 4 (mark C, from memory). An independent program for straight wires, whose droppers and supports
were not stated, gave 0.204 mm/N at a support and 0.419 in the middle of a span with a softer arm
(mark D).

The program is asked by the scenario `en50318-ac-simple-320-planar`; for the comparison with beams
eight spans of it, at a support, at two droppers, in the middle and between droppers, with cubic
elements and with the chains that it is shipped with, these also close to a support and to droppers.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from arcless.simulate import StaticsResult
from tests.support.catenary import green
from tests.support.evidence import Evidence
from tests.support.explicit import BY_MATRIX
from tests.support.faults import Fault, scaled, without
from tests.support.two_beams import TwoBeams, Wire, hung_string

AtRest = Callable[..., StaticsResult]

GRAVITY = 9.81
# The data of the line again, as the reference needs them.
SPAN, SPANS = 55.0, 8
PLACES = np.array([4.5, 10.25, 16.0, 21.75, 27.5, 33.25, 39.0, 44.75, 50.5])
PRESAG = np.array([0, 24, 41, 52, 55, 52, 41, 24, 0]) * 1e-3
LOWER, UPPER = 22e3, 16e3


def shipped_by_beams(x: Any) -> Any:
    """Return the elasticity in m/N of eight spans of the shipped line as two beams."""
    lower = Wire(LOWER, 195.0 / float(green(LOWER, 15e6)))
    upper = Wire(UPPER, 131.7 / float(green(UPPER, 11.64e6)))
    # Between the outer droppers of two spans the contact wire hangs free, over 9 m.
    apart = np.diff([-4.5, *PLACES, 59.5])
    kink = np.diff(np.diff([0.0, *PRESAG, 0.0]) / apart)
    # A dropper of 0.85 m and its clamps hang there too.
    own = (0.165 + 0.195 + 0.117 * 0.85) * GRAVITY
    carried = 1.35 * GRAVITY * 0.5 * (apart[1:] + apart[:-1]) + LOWER * kink + own
    line = TwoBeams(
        SPANS, SPAN, tuple(PLACES), lower, upper, dropper=2e5, support=5e5, arm=2673.58,
        axial=11.64e6 / (SPANS * SPAN),
        shape=hung_string(SPAN, UPPER, 1.08 * GRAVITY, tuple(PLACES), carried),
    )  # fmt: skip
    return np.array([line.lift(place) for place in x])


def shipped(elements: tuple[float, float], changes: dict[str, Any]) -> arcless.Scenario:
    contact, messenger = elements
    return arcless.load("en50318-ac-simple-320-planar").with_(
        **{
            "line.spans": [{"type": "standard", "count": SPANS}],
            "travel": {"start": 60.0, "end": 380.0},
            "analysis": {"from": 100.0, "to": 300.0},
            "solver.contact_wire_element": contact,
            "solver.messenger_wire_element": messenger,
            **changes,
        }
    )


def compare(
    evidence: Evidence, wires: str, elements: tuple[float, float],
    allowed: tuple[float, str], beside: tuple[float, ...] = (),
) -> None:  # fmt: skip
    x = 3 * SPAN + np.array([0.0, 4.5, 16.0, 27.5, 30.375, *beside])
    plain = {"solver.scheme": BY_MATRIX["solver.scheme"], "solver.residual_flexibility": False}
    scheme = plain if wires == "cubic" else {"solver.scheme": "central-difference"}
    value = equilibrium.find(shipped(elements, scheme)).elasticity(x)
    reference = shipped_by_beams(x)
    slope = (1.35 + 1.08) * GRAVITY * 0.5 * SPAN / UPPER
    kink, reason = allowed
    evidence.below(
        f"shipped line, {wires} elements of {elements[0]} m, worst of {len(x)} places",
        1e3 * np.abs(value - reference).max(), 1e3 * (kink + slope**2 * reference.max()),
        unit="mm/N", reason=reason,
    )  # fmt: skip


@pytest.mark.parametrize("elements", [(1.45, 2.9), (0.25, 0.25)])
def test_cubic_elements(evidence: Evidence, elements: tuple[float, float]) -> None:
    kink = np.sqrt(2) / 24 * elements[0] / LOWER
    reason = "the kink below the force, (√2/24) h/T (`elasticity`), and the square of the slope"
    compare(evidence, "cubic", elements, (kink, reason))


@pytest.mark.parametrize("elements", [(0.45, 0.6), (0.25, 0.25)])
def test_chains(evidence: Evidence, elements: tuple[float, float]) -> None:
    # And where chains have corners at what holds them: beside the arm and two droppers.
    beside = (0.12, 4.4, 15.85, 16.2)
    reason = "the square of the slope of the messenger wire"
    compare(evidence, "straight", elements, (0.0, reason), beside)


def test_rule_of_thumb(evidence: Evidence, at_rest: AtRest) -> None:
    found = at_rest("en50318-ac-simple-320-planar").elasticity_m_per_N
    evidence.published(
        "k of the shipped line, L/(e (T_c + T_m)) in the middle",
        SPAN / ((LOWER + UPPER) * found[len(found) // 2]), 3.5, 4.0, unit="1", mark="C",
        source="rule of thumb for simple lines, from memory",
    )  # fmt: skip


def test_scratch_model(evidence: Evidence, at_rest: AtRest) -> None:
    soft = {"line.steady_arm.vertical_stiffness": 267.36}
    found = at_rest("en50318-ac-simple-320-planar", soft).elasticity_m_per_N
    reason = "its droppers and supports were not stated: 10 % says that no factor is missing"
    for place, value, known in (
        ("at a support", found[0], 0.204),
        ("in the middle of a span", found[len(found) // 2], 0.419),
    ):
        evidence.close(
            f"shipped line with a soft arm, {place}", 1e3 * value, known, unit="mm/N",
            relative=0.1, reason=reason, mark="D",
        )  # fmt: skip


FAULTS = [
    Fault("tensions 1 % too high", scaled("wires", "tension", 1.01), test_cubic_elements,
          elements=(0.25, 0.25)),
    Fault("tensions 1 % too high", scaled("segments", "tension", 1.01), test_chains,
          elements=(0.45, 0.6)),
    Fault("chains as they are", without("fitted_bends"), test_chains, elements=(0.45, 0.6)),
    Fault("arms and supports 20 % too stiff", scaled("springs", "stiffness", 1.2),
          test_cubic_elements, elements=(1.45, 2.9)),
]  # fmt: skip
