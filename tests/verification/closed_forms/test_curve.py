"""A wire in a curve is straight

Positions are counted from the track, so a wire that is straight in space seems bent there, with a
rise of L²/8R. It must swing as the straight wire that it is. Over one span, weightless, with the
chord L_c = 2R sin(L/2R) between its ends,

    f_n = n/(2 L_c) √(T/μ),    each one twice: to the side and up

If its apparent curvature counted for stretching as sag does, the first mode to the side would be
that of a wire that sags, with λ² = (L/R)² EA/T in the place of that of its weight.

Then two spans with a spring between them that holds the wire aside: the same line in space, as
two chords counted from a straight axis through that support, with neither curves nor loads of
curves. Frequencies, elasticity and tension must agree; here with weight, too.

The program is asked by wires of 14 MN and 1.1 kg/m under 12 kN, spans of 60 m, R = 600 m, cubic
elements and chains of point masses of 0.75 m. Explicit steps take the same curve in another way,
by pieces between points along the wire; on AC simple in the same curve, at 275 km/h, they are
held against cubic elements.
"""

from math import sin, sqrt
from typing import Any

import numpy as np
import pytest

import arcless
from tests.support.curves import AXIAL, MASS, one_span, two_spans
from tests.support.evidence import Evidence
from tests.support.faults import Fault, curve_as_a_load, scaled

TENSION, RADIUS, SPAN, COUNT = 12e3, 600.0, 60.0, 80
KINDS = ("wires", "segments")
NAMES = {"wires": "cubic elements", "segments": "point masses"}
ELEMENTS = ("solver.contact_wire_element", "solver.messenger_wire_element")
SHAPE = {"radius": RADIUS, "span": SPAN, "tension": TENSION}


@pytest.mark.parametrize("kind", KINDS)
def test_one_span(kind: str, evidence: Evidence) -> None:
    found = one_span(kind, COUNT, **SHAPE).frequencies(6)
    chord = 2.0 * RADIUS * sin(0.5 * SPAN / RADIUS)
    # The stretched wire is lighter by metre.
    speed = sqrt(TENSION * (1.0 + TENSION / AXIAL) / MASS)
    exact = np.repeat([1, 2, 3], 2) * speed / (2.0 * chord)
    assert (SPAN / RADIUS) ** 2 * AXIAL / TENSION > 10, "it would matter"
    for name, number in (
        ("first, to the side or up", 0),
        ("first, the other way", 1),
        ("third", 4),
    ):
        evidence.close(
            f"{name}, {NAMES[kind]}", float(found[number]), float(exact[number]), unit="Hz",
            # Chains of 0.75 m are late by (kℓ)²/24, 6e-4 for the third; y/R and 2 T/EA, by which
            # the law of cubic elements differs, are of the size of 1e-3.
            relative=2e-3, reason="squares of slopes, and of the elements' lengths",
        )  # fmt: skip


@pytest.mark.parametrize("weight", [0.0, 9.81])
@pytest.mark.parametrize("kind", KINDS)
def test_two_spans(kind: str, weight: float, evidence: Evidence) -> None:
    def line(from_track: bool) -> tuple[float, ...]:
        it = two_spans(kind, COUNT, **SHAPE, stiffness=20e3, from_track=from_track, gravity=weight)
        # At places of the wire; along the track there are more metres than along the chord.
        chord = (
            SPAN
            if from_track
            else 2.0 * RADIUS * sin(0.5 * SPAN / RADIUS) * np.cos(0.5 * SPAN / RADIUS)
        )
        elasticity = it.elasticity(np.array([-0.5, 0.25]) * chord)
        return (*it.frequencies(8), *(1e3 * elasticity), float(it.arrays["wire_tension"].mean()))

    track, space = line(True), line(False)
    heavy = f"{NAMES[kind]}, {'with' if weight else 'without'} weight"
    names = [*(f"frequency {n + 1}" for n in range(8)), "elasticity, middle", "quarter", "tension"]
    for number in (0, 1, 2, 8, 9, 10):
        unit = "Hz" if number < 8 else "N" if number == 10 else "mm/N"
        evidence.close(
            f"{names[number]}, {heavy}", track[number], space[number], unit=unit,
            relative=1e-3, reason="y/R and squares of slopes are left out: 0.75 m in 600 m",
        )  # fmt: skip
    np.testing.assert_allclose(track[:8], space[:8], rtol=1e-3)


def test_families(evidence: Evidence) -> None:
    scenario = arcless.load("en50318-ac-simple-275").with_(
        **{
            "line.track": {"curves": [{"from": -1e3, "to": 5e3, "radius": RADIUS, "side": "left"}]},
            "line.geometry.stagger_contact_wire": [0.0],
            "line.geometry.stagger_messenger_wire": [0.0],
            "pantographs.0.mean_force": None,
            "pantographs.0.static_force": 150.0,
        }
    )

    def numbers(**changes: Any) -> tuple[float, float]:
        found = arcless.run(scenario.with_(**changes)).assessment
        assert found.max_uplift_at_support_mm is not None
        return found.pantographs[0].contact_point_range_mm, found.max_uplift_at_support_mm

    explicit, auto = "central-difference", dict.fromkeys(ELEMENTS, "auto")
    steps = numbers(**{"solver.scheme": explicit, **auto})
    cubic = dict(zip(ELEMENTS, (0.725, 1.45), strict=True))
    flexible = {"solver.residual_flexibility": True}
    matrix = numbers(**{"solver.scheme": "generalised-alpha", **flexible, **cubic})
    for name, value, reference in zip(("range", "uplift"), steps, matrix, strict=True):
        evidence.close(
            f"{name}, AC simple, explicit steps against cubic elements", value, reference,
            unit="mm", relative=0.01, reason="on a straight line both are within 1 %, too",
        )  # fmt: skip


FAULTS = [
    *(fault
      for kind in sorted(KINDS)
      for fault in (
          Fault(f"curves as loads, wires stretch as they seem to bend, {kind}, one span",
                curve_as_a_load(), test_one_span, kind=kind),
          Fault(f"the same, two spans, {kind}", curve_as_a_load(), test_two_spans, kind=kind,
                weight=9.81),
      )),
    Fault("track turns by 2 % more than the supports stand for", scaled("turns", "angle", 1.02),
          test_two_spans, kind="wires", weight=9.81),
]  # fmt: skip
