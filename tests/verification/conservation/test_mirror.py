"""Mirrored line and reversed travel

Nature knows no left and right, and a line no first and last end:

    across:  y → −y                 force, height the same, lateral position −y
    along:   x → L − x, v → −v      everything the same, seen from the other end

Derived here from the equations, which name no side. The line has four spans of 55, 48, 52 and
45 m in space, each with its own droppers, and an uneven stagger, so that it is its own mirror
image in no direction (`tests/support/small.py`); hinged arms, one pantograph at 275 km/h with
150 N, compliant contact, no friction, generalised-alpha, 1 ms, 1309 steps; droppers go slack on
the way. Across, the stagger changes sign. Along, spans, droppers and stagger are written down
from the other end, and the pantograph runs towards the first support: a run that only positions
that fall from step to step can describe.
"""

from dataclasses import replace
from functools import cache
from typing import Any
from unittest.mock import patch

import numpy as np

from arcless.simulate.setup.trajectory import Motion
from tests.support.faults import Fault, kept, scaled
from tests.support.small import FORCE, SPANS, differing, laid_out, small

Raw = dict[str, Any]
LENGTH = sum(length for length, _ in SPANS)


@cache
def straight() -> tuple[Raw, Any]:
    """Return the run on the line as it is, and its travel."""
    job = laid_out(small())
    raw = job.step([FORCE], full=True)
    assert raw["slack_max"] > 0, "droppers go slack"
    return raw, job.travel


def test_left_and_right(evidence: Any) -> None:
    raw, _ = straight()
    mirrored = laid_out(small(across=-1.0)).step([FORCE], full=True)
    signs = {"force": 1.0, "height": 1.0, "lateral": -1.0, "link_force": 1.0, "masses": 1.0}
    counts = [differing(raw[name], sign * mirrored[name]) for name, sign in signs.items()]
    assert np.ptp(raw["lateral"]) > 0.1, "the wire lies to both sides"
    evidence.same(
        "left and right exchanged: forces, heights, lateral positions, dropper forces, masses",
        compared=sum(size for size, _ in counts),
        differing=sum(count for _, count in counts),
        reason="a change of sign is exact, and no sum changes its order",
    )


def test_first_and_last_end(evidence: Any) -> None:
    raw, travel = straight()
    job = laid_out(small(backwards=True))
    back = Motion(LENGTH - travel.positions, travel.speeds, travel.time_step)
    turned = replace(job, travel=back).step([FORCE], full=True)
    assert turned["position"][0] > turned["position"][-1], "it runs the other way"
    evidence.below(
        "line and travel reversed: largest difference of the contact force",
        float(np.max(np.abs(raw["force"] - turned["force"]))),
        4e-8,
        unit="N",
        reason="sums in another order: heights of 5 m rounded in some hundred nodes, 1e-13 m (next"
        " row), times 50 kN/m of the contact; ten times that",
    )
    evidence.below(
        "line and travel reversed: largest difference of the height of the wire",
        float(np.max(np.abs(raw["height"] - turned["height"]))),
        2e-12,
        unit="m",
        reason="Newton's method ends at 1e-13 m of the dropper lengths, where forces of 20 kN are"
        " rounding; ten times that",
    )


def half_turned(sound: Any = small, **_: Any) -> Any:
    """Turn the line round, but move its droppers by 1 mm instead."""
    moved = tuple((length, tuple(x + 1e-3 for x in at)) for length, at in SPANS)
    with patch("tests.support.small.SPANS", moved):
        return sound(backwards=True)


SOUND = kept(straight)
FAULTS = [
    Fault("stagger 0.1 mm off on one side",
          [SOUND, patch.multiple(__name__, small=lambda sound=small, **_: sound(across=-1.0005))],
          test_left_and_right),
    Fault("one dropper 1 % heavier on one side", [SOUND, scaled("links", "mass", 1.01, [0])],
          test_left_and_right),
    Fault("one dropper 1 % heavier at one end", [SOUND, scaled("links", "mass", 1.01, [0])],
          test_first_and_last_end),
    Fault("droppers 1 mm off at one end", [SOUND, patch.multiple(__name__, small=half_turned)],
          test_first_and_last_end),
]  # fmt: skip
