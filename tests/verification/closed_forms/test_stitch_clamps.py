"""Stitched line: forces where the stitch wire is clamped to the messenger wire

At a clamp three wire ends and the weight of the clamp balance, and along the track
`T outside = T inside + T of the stitch wire`, each as asked for: 15 = 12.2 + 2.8 kN.

Balance of forces. Asked as six stitched spans of 60 m, wires as chains without bending stiffness,
straight and staggered; and with cubic elements, whose tension along the track is read in their
middle.
"""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import load
from tests.support.clamps import balance_at
from tests.support.evidence import Evidence
from tests.support.faults import Fault, gravity, scaled
from tests.support.line_types import scenario_data, stitched_data

STAGGER = {
    "geometry__stagger_contact_wire": [0.3, -0.3],
    "geometry__stagger_messenger_wire": [0.1, -0.1],
}


def at_rest(line: dict[str, Any], **changes: Any) -> Equilibrium:
    plain = {"solver__scheme": "generalised-alpha", "solver__residual_flexibility": False}
    return arcless.statics(load(scenario_data(line, **plain, **changes))).equilibrium


@pytest.mark.parametrize("kind", ["straight", "staggered"])
def test_balance(evidence: Evidence, kind: str) -> None:
    stagger = STAGGER if kind == "staggered" else {}
    limp = {f"{wire}_wire__bending_stiffness": 0.0 for wire in ("messenger", "stitch")}
    found = at_rest(stitched_data(**limp, **stagger), solver__wire_model="lumped")
    clamps = [
        clamp for stitch in found.mesh.stitches for clamp in (stitch.nodes[0], stitch.nodes[-1])
    ]
    sums, along = balance_at(found, clamps, 0.5)
    rounding = "what the statics calls rounding: 8 ε · 360 m · EA/L = 4e-6 N, for three wire ends"
    assert along.shape == (10, 3)
    evidence.below(
        f"largest sum of forces at ten clamps, {kind}", float(abs(sums).max()), 1e-5, unit="N",
        reason=rounding,
    )  # fmt: skip
    evidence.below(
        f"largest error of tension along the track, {kind}",
        float(abs(along - [2.8e3, 12.2e3, 15e3]).max()),
        1e-5,
        unit="N",
        reason=rounding,
    )


def test_tensions_of_cubic_elements(evidence: Evidence) -> None:
    found = at_rest(stitched_data())
    wires = found.mesh.parts["wires"]
    nodes = wires["nodes"]
    apart = found.positions[nodes[:, 1]] - found.positions[nodes[:, 0]]
    along = found.arrays["wire_tension"] * apart[:, 0] / np.linalg.norm(apart, axis=1)
    assert along.size > 200
    evidence.below(
        "largest error of tension along the track of an element",
        float(abs(along / wires["design_tension"] - 1.0).max()),
        1e-3,
        unit="1",
        reason="chord and middle of an element differ by the local error of elements of 2 to 3 m",
    )


FAULTS = [
    Fault("gravity 0.01 % too large", gravity(1.0001), test_balance, kind="straight"),
    Fault("tension of one segment 1 % too high",
          scaled("segments", "tension", 1.01, rows=slice(40, 41)), test_balance, kind="staggered"),
]  # fmt: skip
