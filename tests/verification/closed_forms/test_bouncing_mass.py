"""Bouncing mass under rigid contact

A rigid contact is a condition on position, and says nothing of velocity. What a free mass does
after it hits is then a property of the scheme, derived here: it arrives with speed V, and the last
step before the impact has a gap of θ V h at its time of balance, 0 ≤ θ < 1. With the equations of
the scheme step by step, the gap zero in each step that has a force and the force zero in the first
that would pull, the mass leaves with e(θ) V:

    generalised-alpha, spectral radius 0:  e = 1 − 2 θ for θ < 1/3, else e = θ
    newmark, β = γ = 1:                    e = (1 − θ)/2 for θ < 1/3, else e = (1 + θ)/4
    one-sided differences:                 e = 0
    trapezoidal rule:                      e = 3 − 4 θ for θ < 2/3, else e = 8 θ − 5

Shorter steps change θ and not the law: e is between 1/3 and 1, 1/3 and 1/2, 0, 1/3 and 3. The last
makes energy out of nothing, up to nine times what there was; the program warns of it. Who needs a
rebound that is a property of the model takes a compliant contact (see Compliant impact).

The program is asked with a pantograph of one mass of 3 kg below a wire that nothing moves. Given
forces throw it off and back; it stands still along the track. Steps of 1 ms.
"""

from collections.abc import Callable
from math import isinf
from typing import Any

import numpy as np
import pytest

from tests.support import bare, schemes
from tests.support.faults import Fault
from tests.support.run_faults import pantograph_scaled, prepared_with
from tests.support.schemes import Member

H, MASS, STEPS = 1e-3, 3.0, 300
PHASES = np.linspace(0.0125, 0.9875, 40)
# Accelerations of the throw, which radius 0 halves in each step, are forgotten by then.
LANDING = 160
LAWS: dict[Member, Callable[[float], float]] = {
    schemes.generalised_alpha(0.0): lambda t: 1.0 - 2.0 * t if t < 1.0 / 3.0 else t,
    schemes.newmark(1.0, 1.0): lambda t: (1.0 - t) / 2.0 if t < 1.0 / 3.0 else (1.0 + t) / 4.0,
    schemes.PUBLISHED: lambda _t: 0.0,
    schemes.TRAPEZOIDAL: lambda t: 3.0 - 4.0 * t if t < 2.0 / 3.0 else 8.0 * t - 5.0,
}


def impacts(scheme: Member) -> tuple[float, float]:
    """Worst errors over all phases: of e, and of the energy lost as a part of ½ m V²."""
    errors, losses, seen = [], [], []
    for wanted in PHASES:
        force = np.zeros(STEPS + 1)
        force[10:12] = -MASS / (2.0 * H)  # away with 1 m/s; back faster, to land where it should
        force[70:72] = MASS * (1.0 + (60.0 + wanted) / (LANDING - 70.0)) / (2.0 * H)
        asked = bare.Asked(scheme, H, bare.stand(0.0, STEPS), ledger=True)
        found = bare.run(bare.wall(), bare.free_mass(MASS, 0.0, force), asked)
        gap, pushed = -found["masses"], np.flatnonzero(found["force"] > 0.0)
        hit = pushed[pushed > 100][0]
        speed = (gap[hit - 2] - gap[hit - 1]) / H
        phase = gap[hit - 1] / (speed * H)
        after = (gap[-1] - gap[-2]) / H / speed
        lost = found["energy"]["switching"] + found["energy"]["dissipated_scheme"]
        share = (lost[-1] - lost[hit - 1]) / (0.5 * MASS * speed**2)
        expected = LAWS[scheme](phase)
        seen.append(phase)
        errors.append(abs(after - expected))
        losses.append(abs(share - (1.0 - expected**2)))
    assert np.diff(np.sort(seen), prepend=0.0, append=1.0).max() < 0.1, "all phases are tried"
    return max(errors), max(losses)


@pytest.mark.parametrize("scheme", LAWS, ids=lambda scheme: scheme.label)
def test_speed_after_a_rigid_impact(evidence: Any, scheme: Member) -> None:
    speed, energy = impacts(scheme)
    evidence.below(
        f"{scheme.label}: speed after the impact, as a part of V, worst of {len(PHASES)} θ",
        speed,
        2e-13,
        unit="1",
        reason="the law is exact: rounding of places of 0.1 m, 1e-17, in some tens of steps, over"
        " V h = 1e-3 m",
    )
    evidence.below(
        f"{scheme.label}: energy lost by the ledger against (1 − e²) m V²/2, as a part of m V²/2",
        energy,
        5e-12,
        unit="1",
        reason="entries of some m V²/2, with 1e-16 each in 300 steps; with the trapezoidal rule"
        " those of the scheme and of switching alternate, ten times larger",
    )


def test_bounces_end_in_equilibrium(evidence: Any) -> None:
    """Under a constant force, with the member that bounces most."""
    steps, force = 2500, 15.0
    throw = np.zeros(steps + 1)
    throw[10:12] = -MASS / (2.0 * H)
    asked = bare.Asked(next(iter(LAWS)), H, bare.stand(0.0, steps))
    found = bare.run(bare.wall(), bare.free_mass(MASS, force, throw), asked)
    pushed, gap = found["force"] > 0.0, -found["masses"]
    flights = list(
        zip(
            np.flatnonzero(pushed[:-1] & ~pushed[1:]),
            np.flatnonzero(~pushed[:-1] & pushed[1:]),
            strict=True,
        )
    )
    falls = [
        np.polyfit(H * np.arange(last - first - 60), gap[first + 60 : last], 2)[0]
        for first, last in flights
        if last - first > 100
    ]
    assert len(flights) > 5 and len(falls) > 3
    evidence.below(
        "acceleration back in the air against F/m, worst of the long flights",
        float(np.max(np.abs(-2.0 * np.array(falls) - force / MASS))),
        5e-13,
        unit="m/s²",
        reason="the equations are exact for a constant acceleration: 1e-17 m over (0.04 s)² in the"
        " shortest flight that is fitted",
    )
    evidence.close(
        "force after the last bounce",
        float(found["force"][-1]),
        force,
        unit="N",
        absolute=1e-12,
        reason="at rest the force is the preload; one rounding of it is 2e-15",
    )


def next_parameter(asked: tuple[str, list[float]]) -> tuple[str, list[float]]:
    name, (first, *rest) = asked
    return name, [first + 1e-6, *rest]


BY_NAME = sorted(LAWS, key=lambda scheme: scheme.name)
FAULTS = [
    *(Fault(f"{scheme.label}: rigid contact yields by 1 m for 1e9 N",
            prepared_with(contact_stiffness=lambda rigid: 1e9 if isinf(rigid) else rigid),
            test_speed_after_a_rigid_impact, scheme=scheme)
      for scheme in BY_NAME),
    *(Fault(f"{scheme.label}: first parameter 1e-6 high", prepared_with(scheme=next_parameter),
            test_speed_after_a_rigid_impact, scheme=scheme)
      for scheme in BY_NAME
      if scheme.numbers),
    Fault("mass 1 % high", pantograph_scaled("mass", 1.01), test_bounces_end_in_equilibrium),
    Fault("mass 1 % high", pantograph_scaled("mass", 1.01), test_speed_after_a_rigid_impact,
          scheme=schemes.PUBLISHED),
]  # fmt: skip
