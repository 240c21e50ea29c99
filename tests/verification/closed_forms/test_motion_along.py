"""Motion along the wire that motion across it causes

A weightless string (tension T of a counterweight at its end, pinned at 0) is lifted in the middle
by F. Nothing stretches, both halves have the slope `F/2T` and are shorter along the track by half
its square: a point x from the pinned end, before the force as after it, moves by

`u = −½ (F/2T)² x`

Derived here. Asked as one span of 60 m, 10 kN, at the start of a run with F = 20 N and updated
kinematics; with linearised kinematics a straight wire has no such motion.
"""

from typing import Any

import numpy as np

import arcless
from tests.support.evidence import Evidence
from tests.support.faults import Fault
from tests.support.python_faults import set_gravity, tension

LENGTH, TENSION, FORCE = 60.0, 10e3, 20.0
POINTS = np.array([10.0, 20.0, 40.0, 50.0])


def along(**changes: Any) -> np.ndarray:
    """Motion of four points along the track (m) as a run starts."""
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
        "output.points": POINTS.tolist(),
    }
    result = arcless.run(arcless.load("praks-180").with_(**bare | changes))
    return np.asarray(result.dataset["point_along"].values[0])


def test_slopes_draw_the_wire_towards_its_fixed_end(evidence: Evidence) -> None:
    expected = -0.5 * (FORCE / (2 * TENSION)) ** 2 * POINTS
    evidence.below(
        "largest relative error of the motion along, four points",
        float(abs(along() / expected - 1.0).max()),
        2e-3,
        unit="1",
        reason="the contact is a step away from the middle: 2 · 0.05 m / 60 m; sin instead of tan",
    )


def test_linearised_motion_has_no_such_part(evidence: Evidence) -> None:
    evidence.same(
        "motion along with linearised kinematics, against none",
        compared=POINTS.size,
        differing=int(np.count_nonzero(along(**{"solver.kinematics": "linearised"}))),
        reason="across a straight wire nothing couples to its length",
    )


FAULTS = [
    Fault("tension 1 % too high", tension(1.01), test_slopes_draw_the_wire_towards_its_fixed_end),
    Fault("weight, and so a sag", set_gravity(9.81), test_linearised_motion_has_no_such_part),
]  # fmt: skip
