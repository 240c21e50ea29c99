"""Motion along the wire that motion across it causes: the closed form at rest."""

from typing import Any

import numpy as np
import pytest

import arcless

LENGTH, TENSION, FORCE = 60.0, 10e3, 20.0
POINTS = [10.0, 20.0, 40.0, 50.0]


def string(**changes: Any) -> np.ndarray:
    """Motion along the track (m) of a weightless wire pinned at 0 with a counterweight at 60 m,
    lifted in the middle, as a run starts."""
    bare = {
        "line.span_types": {"bare": {"length": LENGTH, "droppers": {"positions": []}}},
        "line.spans": [{"type": "bare", "count": 1}],
        "line.contact_wire.tension": TENSION,
        "line.contact_wire.bending_stiffness": 0.0,
        "solver.gravity": 0.0,
        "solver.time_step": "1 ms",
        "solver.wire_model": "lumped",
        "solver.scheme": "generalised-alpha",
        "contact": {"law": "compliant"},
        "pantographs.0.static_force": FORCE,
        "travel": {"start": LENGTH / 2, "end": LENGTH / 2 + 1.0},
        "analysis": {"from": LENGTH / 2, "to": LENGTH / 2 + 1.0},
        "output.points": POINTS,
    }
    result = arcless.run(arcless.load("praks-180").with_(**bare | changes))
    return np.asarray(result.dataset["point_along"].values[0])


def test_slopes_draw_the_wire_towards_its_fixed_end() -> None:
    # The tension is that of the counterweight, before and after: nothing stretches. Both halves
    # have the slope F/2T and are shorter along the track by half its square.
    slope = FORCE / (2 * TENSION)
    expected = -0.5 * slope**2 * np.array(POINTS)
    # sin instead of tan, and the contact a step away from the middle: the slope squared and
    # 2 · 0.05 m / 60 m.
    assert string() == pytest.approx(expected, rel=2e-3)


def test_linearised_motion_of_a_straight_wire_has_no_such_part() -> None:
    assert not string(**{"solver.kinematics": "linearised"}).any()
