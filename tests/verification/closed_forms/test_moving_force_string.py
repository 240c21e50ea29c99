"""Wire of finite length under a moving force

A force F runs with the speed V along a wire of the length L, held at both ends (pinned), from rest
under the force at x₀. With κ = nπ/L and μω² = Tκ² + EIκ⁴ the deflection is the series

    w(x, t) = Σ q sin κx,   q = A sin κ(x₀ + Vt) + a cos ωt + b sin ωt,   A = (2F/μL)/(ω² − κ²V²)

a and b from q = 2F sin κx₀/(μLω²), q̇ = 0 at the start. Without bending stiffness it is the string.
Derived here by modes, as in books on moving loads (from memory: Frýba, Vibration of solids and
structures under moving loads, 1972). Fronts of waves run out from the start, where the speed
jumps, and are thrown back by the ends.

The program is asked by a run: a strip of 1e-9 kg presses with 100 N on a straight wire (60 m,
20 kN, 1.35 kg/m, EI 0 or 200 N m², elements of 0.05 m) and goes from 10 m to 55 m; rigid contact,
trapezoidal rule, 1 ms. Compared are deflections at 15, 30 and 45 m and under the strip, over the
largest. First with the series itself; what differs is the time step, which blunts the fronts. Then
with the series whose modes are stepped by the trapezoidal rule, in closed form as well (see
`tests/support/moving_force.py`); what differs then is the error of the elements and of contacts
that move from one to the next.
"""

import pytest

from tests.support import moving_force, straight
from tests.support.evidence import Evidence
from tests.support.faults import Fault, scaled
from tests.support.moving_force import furthest, series
from tests.support.python_faults import press_late

KINDS = {
    "string": straight.wire(20e3, 1.35, 0.0, 15e6),
    "contact wire": straight.wire(20e3, 1.35, 200.0, 15e6),
}
SLOW, FAST = 60.0, 110.0  # m/s: 0.49 and 0.90 of the wave speed
FRONTS = (
    "a front, a kink of up to F/T in the slope, is blunted over the way of a wave in a step:"
    " F c h/T = 6e-4 m, of 0.11 m"
)
MISSED = {
    "string": "an element that stays straight misses F h/(4T) = 6e-5 m under the force, 6e-4 of the"
    " deflection; a cubic one less than half of it",
    "contact wire": "a cubic element misses F h³/(192 EI) = 3e-7 m under the force, 3e-6 of the"
    " deflection; the series stops at 1600 modes, as much again",
}


@pytest.mark.parametrize("name", KINDS)
def test_at_half_of_the_wave_speed(evidence: Evidence, name: str) -> None:
    found = moving_force.run(KINDS[name], SLOW)
    exact, stepped = (
        series(KINDS[name], SLOW, found.time, stepped=stepped) for stepped in (False, True)
    )
    evidence.below(
        f"|w − series| / largest w, {name}, 0.49 c", furthest(found, exact), 6e-3, unit="1",
        reason=FRONTS,
    )  # fmt: skip
    evidence.below(
        f"|w − stepped series| / largest w, {name}, 0.49 c", furthest(found, stepped),
        {"string": 3e-4, "contact wire": 1e-5}[name], unit="1", reason=MISSED[name],
    )  # fmt: skip
    evidence.figure(
        name.replace(" ", "-"),
        {
            "series": (found.time, 1e3 * exact.points[:, 1]),
            "run": (found.time, 1e3 * found.points[:, 1]),
        },
        x="time in s", y="deflection in mm", title=f"Middle of the {name} as 100 N pass at 0.49 c",
    )  # fmt: skip


@pytest.mark.parametrize("name", KINDS)
def test_near_the_wave_speed(evidence: Evidence, name: str) -> None:
    found = moving_force.run(KINDS[name], FAST)
    stepped = series(KINDS[name], FAST, found.time, stepped=True)
    piled = "; it runs ahead of the force and piles up, by c/(c − V) = 10, one part of it"
    evidence.below(
        f"|w − stepped series| / largest w, {name}, 0.90 c", furthest(found, stepped),
        {"string": 3e-4, "contact wire": 5e-5}[name], unit="1",
        reason=MISSED[name] + (piled if name == "contact wire" else ""),
    )  # fmt: skip


FAULTS = [
    *(Fault(f"{column} of the wire 1 % too large", scaled("wires", column, 1.01),
            test_at_half_of_the_wave_speed, name="string")
      for column in ("tension", "mass")),
    Fault("EI 1 % too large", scaled("wires", "EI", 1.01), test_at_half_of_the_wave_speed,
          name="contact wire"),
    Fault("force half a step behind its place", press_late(moving_force),
          test_at_half_of_the_wave_speed, name="contact wire"),
]  # fmt: skip
