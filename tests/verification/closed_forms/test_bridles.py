"""Bridles: heights and forces at the clamps below a bridle wire

A bridle (tension T_b, weight w_b, half length a) hangs between two clamps on the contact wire and
is held in its middle. Each clamp carries half of a span, itself, and half of the steady arm: force
F.

* rise of the middle above the clamps: `h = F a/T_b + w_b a²/2T_b`
* next to an anchor one side carries `w a/2` more, so the clamps differ by less than `w a/2 · a/2T`
* at a clamp, with a wire that does not bend, the pulls of the three wire ends and the weight add up
  to zero, and along the track `T outside = T inside + T_b`

Balance of forces, derived here. Asked as a line of ten spans of 40 m with bridles of 10 m and 2 kN.
"""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import load
from arcless.simulate import StaticsResult
from tests.support.clamps import balance_at
from tests.support.evidence import Evidence
from tests.support.faults import Fault, gravity, scaled
from tests.support.line_types import scenario_data
from tests.support.simple_lines import bridle_data

FINE = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}
STAGGER = {"straight": [0.0], "staggered": [0.2, -0.2]}
GRAVITY = 9.81


def at_rest(line: dict[str, Any], **changes: Any) -> StaticsResult:
    return arcless.statics(load(scenario_data(line, **changes)))


def test_heights(evidence: Evidence) -> None:
    found = at_rest(bridle_data(), **FINE)
    assert [b["support"] for b in found.bridles] == [f"support {n}" for n in range(2, 11)]
    heights = np.array([bridle["clamp_heights_m"] for bridle in found.bridles]) - 5.5
    evidence.below(
        "largest error of height at inner clamps",
        float(abs(heights[2:-2]).max()),
        1e-3,
        unit="m",
        reason="alike on both sides: off by the second order of the slope, 0.12²/2 of 0.6 m is "
        "4 mm, of which the tangent takes most; the design was accepted at 1 mm",
    )
    unlike = 0.5 * 1.1 * GRAVITY * 5.0 * 5.0 / (2 * 12e3)
    evidence.below(
        "largest difference of height next to an anchor",
        float(abs(heights[[0, -1]]).max()),
        unlike + 1e-3,
        unit="m",
        reason="w a²/4T of the two sides, and 1 mm as at the inner ones",
    )
    force = 0.5 * 1.1 * GRAVITY * 40.0 + 0.4 * GRAVITY + 0.25 * GRAVITY
    evidence.close(
        "height of the middle of a bridle",
        found.bridles[4]["hangs_at_m"],
        5.5 + force * 5.0 / 2e3 + 0.3 * GRAVITY * 25.0 / 4e3,
        unit="m",
        absolute=1e-9,
        reason="rounding: the drawing takes the same balance of forces",
    )


@pytest.mark.parametrize(
    ("field", "value", "limit"),
    [("tension", 1e3, 1e-3), ("tension", 11.5e3, 1e-4), ("length", 30.0, 15e-3)],
)
def test_unusual_bridles(evidence: Evidence, field: str, value: float, limit: float) -> None:
    found = at_rest(bridle_data(**{f"bridle__{field}": value}))
    heights = np.array([bridle["clamp_heights_m"] for bridle in found.bridles[2:-2]]) - 5.5
    assert heights.size == 10
    evidence.below(
        f"largest error of height, {field} {value:g}",
        float(abs(heights).max()),
        limit,
        unit="m",
        reason="second order of the slope of the bridle: 13 mm of a rise of 1.9 m over 15 m when "
        "it is long; the tangent takes most of it when it is short; nearly none when it is flat",
    )


@pytest.mark.parametrize("kind", STAGGER)
def test_balance_at_the_clamps(evidence: Evidence, kind: str) -> None:
    stagger = {"geometry__stagger_contact_wire": STAGGER[kind]}
    limp = bridle_data(contact_wire__bending_stiffness=0.0, **stagger)
    found = at_rest(limp, solver__wire_model="lumped").equilibrium
    clamps = [
        clamp for bridle in found.mesh.bridles for clamp in bridle.nodes[:: len(bridle.nodes) - 1]
    ]
    sums, along = balance_at(found, clamps, 0.4)
    rounding = "what the statics calls rounding: 8 ε · 400 m · EA/L = 1e-5 N, for three wire ends"
    evidence.below(
        f"largest sum of forces at 18 clamps, {kind}", float(abs(sums).max()), 1e-5, unit="N",
        reason=rounding,
    )  # fmt: skip
    evidence.below(
        f"largest error of tension along the track, {kind}",
        float(abs(along - [2e3, 10e3, 12e3]).max()),
        1e-5,
        unit="N",
        reason=rounding,
    )
    assert along.shape == (18, 3)


FAULTS = [
    Fault("gravity 1 % too large", gravity(1.01), test_heights),
    Fault("gravity 0.01 % too large", gravity(1.0001), test_balance_at_the_clamps, kind="straight"),
    Fault("tension of the last wires 1 % too low",
          scaled("wires", "tension", 0.99, rows=slice(-40, None)), test_heights),
]  # fmt: skip
