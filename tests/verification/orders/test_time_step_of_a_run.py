"""Time step of a run below a wire

The pantograph of EN 50318:2002 runs 9 m below a wire without weight (60 m, 20 kN, EI = 195 N·m²) on
a contact of 50 kN/m. It starts and stops smoothly, `V = 30 m/s sin²(π t/T)`, T = 0.6 s: a start at
full speed sends a front along the wire, in which every scheme is of lower order (see Bar against a
wall). Quantity: uplift of the wire at 35 m, largest error over all steps.

Theory: the order of the scheme, 2 or 1, also with a contact that moves from element to element,
for force, place and displacement are all taken at the time of balance. Steps are short enough for
the highest frequency that the run stirs up: waves of an element's length, some 600 1/s. Reference:
the default scheme and the same kinematics with steps of 1/64 ms. Cubic elements of 2.5 m, pieces of
chain of 1.25 m.
"""

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from arcless.model import load_pantograph
from arcless.simulate.setup import pantographs
from tests.support import bare, schemes, spans
from tests.support.faults import Fault, forgotten, kept
from tests.support.run_faults import contact_scaled, spoiled, stepped_by
from tests.support.schemes import Member

Floats = NDArray[np.float64]

SPEED, DURATION = 30.0, 0.6
FINEST, SHORT, SHORTER, SHORTEST = 1e-3 / 64, 5e-4, 2.5e-4, 1.25e-4
COUNTS = {"hermite": 24, "lumped": 48}


def uplift(model: str, kinematics: str, scheme: Member, h: float) -> tuple[Floats, Floats]:
    """Times in s, and uplift of the wire at 35 m in m."""
    count = COUNTS[spans.MODELS[model][0]]
    rest = spans.LENGTH / spans.STRETCH
    wire = spans.span(
        model, count, length=spans.LENGTH, rest=rest, axial=spans.AXIAL, bending=195.0,
        mass=spans.MASS,
    )  # fmt: skip
    t = h * np.arange(round(DURATION / h) + 1)
    turn = 2.0 * np.pi / DURATION
    x = 20.6 + 0.5 * SPEED * (t - np.sin(turn * t) / turn)
    head = pantographs.data(load_pantograph("en50318-2002"), 120.0)
    updated = kinematics == "updated"
    asked = bare.Asked(scheme, h, x, contact_stiffness=50e3, points=[35.0], updated=updated)
    found = bare.run(wire, head, asked)
    assert found["force"].min() > 50.0, "it touches all the time"
    return found["line_time"], found["point_uplift"]


@cache
def reference(model: str, kinematics: str) -> CubicSpline:
    return CubicSpline(*uplift(model, kinematics, schemes.DEFAULT, FINEST))


def error(model: str, kinematics: str, scheme: Member, h: float) -> float:
    """Largest error, m."""
    time, found = uplift(model, kinematics, scheme, h)
    return float(np.abs(found - reference(model, kinematics)(time)).max())


def steps(scheme: Member) -> tuple[float, ...]:
    """Three steps; members that damp much need shorter ones before their orders show."""
    if scheme in (schemes.DAMPED, schemes.PUBLISHED):
        return SHORTEST, SHORTEST / 2.0, SHORTEST / 4.0
    if scheme == schemes.generalised_alpha(0.0):
        return SHORTER, SHORTEST, SHORTEST / 2.0
    return SHORT, SHORTER, SHORTEST


CASES = [
    *(("cubic, planar", "linearised", scheme) for scheme in schemes.ALL),
    *((m, "linearised", schemes.DEFAULT) for m in spans.MODELS if m != "cubic, planar"),
    *((m, "updated", schemes.DEFAULT) for m in ("cubic, planar", "point masses, planar")),
]


@pytest.mark.parametrize(
    ("model", "kinematics", "scheme"), CASES, ids=lambda value: getattr(value, "label", value)
)
def test_order(evidence: Any, model: str, kinematics: str, scheme: Member) -> None:
    first = scheme not in schemes.SECOND_ORDER
    evidence.order(
        f"{model}, {kinematics}, {scheme.label}: uplift, m",
        steps(scheme),
        [error(model, kinematics, scheme, h) for h in steps(scheme)],
        1.0 if first else 2.0,
        tolerance=0.1 if first else 0.05,
        reason="the next term is ωh = 0.08 of the first at 0.125 ms, and falls with h"
        if first
        else "the next terms are (ωh)² = 0.1 of the first on the longest of the steps, 0.01 on the"
        " shortest",
        unit="h",
    )


def behind(arguments: dict[str, Any]) -> None:
    """Let the contact be where it was half a step ago."""
    x = np.array(arguments["positions"])
    arguments["positions"] = [x[0], *(0.5 * (x[1:] + x[:-1]))]


AFRESH = forgotten(reference)
SOUND = kept(reference, "cubic, planar", "linearised")
FAULTS = [
    *(Fault(f"{model}: contact where it was half a step ago", [AFRESH, spoiled(running=behind)],
            test_order, model=model, kinematics="linearised", scheme=schemes.DEFAULT)
      for model in ("cubic, planar", "point masses, spatial")),
    Fault("newmark with γ = 0.51 in place of 0.5",
          [AFRESH, SOUND, stepped_by(schemes.newmark(0.26, 0.51))], test_order,
          model="cubic, planar", kinematics="linearised", scheme=schemes.newmark(0.25, 0.5)),
    Fault("contact 10 % stiff, in all but the reference", [AFRESH, SOUND, contact_scaled(1.1)],
          test_order, model="cubic, planar", kinematics="linearised", scheme=schemes.DEFAULT),
]  # fmt: skip
