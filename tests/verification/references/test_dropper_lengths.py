"""AC simple: nine dropper lengths against the published ones

Lengths between the clamps of the droppers of a span of 55 m, printed in whole millimetres by the
source of the line's data (mark A). The design calculation finds them from tensions, weights and the
height of the contact wire.

Asked as `en50318-ac-simple-320-planar` at rest, span 10 of 20, with the chains of explicit steps
that it is shipped with, and with cubic elements; with elements of either halved; and with the
lengths of span 10 given as built, which must give the design back.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from arcless.simulate import StaticsResult
from arcless.validate.reference import DROPPERS
from tests.support import fresh
from tests.support.evidence import Evidence
from tests.support.explicit import BY_MATRIX
from tests.support.faults import Fault, scaled, without
from tests.support.python_faults import tension

AtRest = Callable[..., StaticsResult]


def lengths(found: StaticsResult, span: int = 10) -> np.ndarray:
    return np.array([d["length_m"] for d in found.droppers if d["span"] == span])


# What an element may still change, in m: a fifth of what the source rounds by; for cubic elements,
# which round the kinks at droppers over their length, half of the tolerance on the lengths, so that
# no mesh decides whether it is met.
WIRES: dict[str, tuple[dict[str, Any], float]] = {
    "as shipped": ({}, 1e-4),
    "cubic elements": (BY_MATRIX, 1.5e-3),
}


@pytest.mark.parametrize("wires", WIRES)
def test_nine_lengths(evidence: Evidence, at_rest: AtRest, wires: str) -> None:
    found = lengths(at_rest(DROPPERS.scenario, WIRES[wires][0]))
    published = np.array(DROPPERS.lengths)
    assert found.size == published.size == 9
    evidence.below(
        f"largest difference to a published length, {wires}",
        float(abs(found - published).max()),
        3e-3,
        unit="m",
        mark="A",
        reason="the source prints whole millimetres, does not say how its droppers were stretched "
        "(0.2 mm), nor its mesh (1 mm, below)",
    )


@pytest.mark.parametrize("wires", WIRES)
def test_mesh(evidence: Evidence, at_rest: AtRest, wires: str) -> None:
    changes, allowed = WIRES[wires]
    whole = at_rest(DROPPERS.scenario, changes)
    solver = whole.scenario.stepping
    halved = {
        f"solver.{wire}_wire_element": getattr(solver, f"{wire}_wire_element_m") / 2
        for wire in ("contact", "messenger")
    }
    coarse, fine = lengths(whole), lengths(at_rest(DROPPERS.scenario, changes | halved))
    assert coarse.size == 9
    evidence.below(
        f"largest change of a length with elements halved, {wires}",
        float(abs(coarse - fine).max()),
        allowed,
        unit="m",
        reason="a share of the tolerance on the lengths: no mesh decides whether it is met",
    )


def test_inner_spans_are_alike(evidence: Evidence, at_rest: AtRest) -> None:
    found = at_rest(DROPPERS.scenario)
    inner = [lengths(found, span) for span in range(3, 19)]
    neighbours = max(float(abs(left - right).max()) for left, right in pairwise(inner))
    assert len(inner) == 16
    evidence.below(
        "largest difference between neighbouring inner spans",
        neighbours,
        1e-10,
        unit="m",
        reason="heights and tensions are given, so spans do not feel one another: rounding of "
        "forces, 1e-5 N, over EA/L of 1e7 N/m, ten times",
    )
    evidence.below(
        "largest difference of a length to its mirror image",
        float(abs(inner[8] - inner[8][::-1]).max()),
        1e-10,
        unit="m",
        reason="a span is its own mirror image; rounding as between spans",
    )


def test_as_built(evidence: Evidence, at_rest: AtRest) -> None:
    design = at_rest(DROPPERS.scenario)
    rest = [d["unstretched_length_m"] for d in design.droppers if d["span"] == 10]
    built = at_rest(DROPPERS.scenario, {"line.span_types.standard.droppers.lengths": rest})
    heights = [
        np.array([s["contact_wire_height_m"] for s in found.supports][5:16])
        for found in (design, built)
    ]
    assert heights[0].size == 11
    evidence.below(
        "largest difference of height at eleven supports, as built from the design",
        float(abs(heights[1] - heights[0]).max()),
        2e-8,
        unit="m",
        reason="forces balance to 1e-5 N over 0.4 mm/N: 4e-9 m at a node, of several",
    )
    evidence.below(
        "largest difference of a length, as built from the design",
        float(abs(lengths(built) - lengths(design)).max()),
        2e-11,
        unit="m",
        reason="R of the tensions at rest changes stiffnesses by 1e-12 of themselves at most, in"
        " the last round: of 100 N over 100 kN/m, times some, and rounding of 600 m, 1e-13",
    )


def softer_as_built(name: str, changes: dict[str, Any] | None = None) -> StaticsResult:
    """Find a line at rest, droppers half as stiff where it is not as designed."""
    if not changes:
        return fresh.at_rest(name)
    with scaled("links", "stiffness", 0.5):
        return fresh.at_rest(name, changes)


FAULTS = [
    *(Fault("tensions 1 % too low", tension(0.99), test_nine_lengths, at_rest=fresh.at_rest,
            wires=wires)
      for wires in sorted(WIRES)),
    # Corners at droppers are too sharp.
    Fault("chains as they are", without("fitted_bends"), test_mesh, at_rest=fresh.at_rest,
          wires="as shipped", slow=True),
    Fault("one clamp twice as heavy", scaled("masses", "mass", 2.0, rows=[40]),
          test_inner_spans_are_alike, at_rest=fresh.at_rest),
    Fault("droppers half as stiff as designed", (), test_as_built, at_rest=softer_as_built),
]  # fmt: skip
