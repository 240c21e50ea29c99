"""Compliant impact: a mass on a contact of 50 kN/m

A mass m under a constant force F meets a wire that nothing moves with speed V. While they touch,
the compression p follows `m p'' = F − k p`, `p(0) = 0`, `p'(0) = V`; with ω² = k/m (derived here)

    p = V/ω sin ωt + F/k (1 − cos ωt)
    leaves with V after T = 2 (π − atan(ω V m/F))/ω
    highest force F + √(F² + k m V²)

No model of a rebound is needed, and no energy is lost: a compliant contact is a model of its own,
not a penalty for a rigid one.

The program is asked with a pantograph of one mass of 7.2 kg under 120 N, the default scheme, steps
of 0.05 ms. A given force throws it off; V is measured before it lands.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support import bare, schemes
from tests.support.faults import Fault
from tests.support.run_faults import contact_scaled, pantograph_scaled, stepped_by

Floats = NDArray[np.float64]


MASS, STIFFNESS, FORCE, H = 7.2, 50e3, 120.0, 5e-5


def bounce() -> tuple[float, float, float, float]:
    """Speed before and after, m/s; duration, s; highest force, N."""
    throw = np.zeros(round(0.2 / H) + 1)
    throw[10:12] = -MASS / (2.0 * H)
    standing = bare.stand(0.0, len(throw) - 1)
    asked = bare.Asked(schemes.DEFAULT, H, standing, contact_stiffness=STIFFNESS)
    found = bare.run(bare.wall(), bare.free_mass(MASS, FORCE, throw), asked)
    # Free mass and wire touch where the preload compresses nothing.
    gap, pushed = -found["masses"] - FORCE / STIFFNESS, found["force"] > 0.0
    opened = np.flatnonzero(~pushed)
    landed = np.flatnonzero(pushed & (np.arange(len(pushed)) > opened[0]))[0]
    left = opened[opened > landed][0]
    steps = H * np.arange(20)
    arriving = np.polyfit(steps, gap[landed - 20 : landed], 2)
    leaving = np.polyfit(steps, gap[left : left + 20], 2)
    closes = (landed - 20) * H + np.roots(arriving).max()
    opens = left * H + min(np.roots(leaving), key=abs)
    return slope(arriving), slope(leaving), float(opens - closes), float(found["force"].max())


def slope(parabola: Floats) -> float:
    """Size of the slope of a parabola where it is zero."""
    return float(np.sqrt(parabola[1] ** 2 - 4.0 * parabola[0] * parabola[2]))


def test_a_bounce(evidence: Any) -> None:
    before, after, duration, highest = bounce()
    omega = np.sqrt(STIFFNESS / MASS)
    touching = 2.0 * (np.pi - np.arctan(omega * before * MASS / FORCE)) / omega
    rows = (
        ("speed after over speed before", after / before, 1.0, "1"),
        ("duration of contact", 1e3 * duration, 1e3 * touching, "ms"),
        ("highest force", highest, FORCE + np.sqrt(FORCE**2 + STIFFNESS * MASS * before**2), "N"),
    )
    for what, value, reference, unit in rows:
        evidence.close(
            what,
            value,
            float(reference),
            unit=unit,
            relative=1e-5,
            reason="second order, (ωh)²/12 = 1.4e-6 for a frequency; seven times that, for opening"
            " and closing are placed on the grid of steps",
        )


FAULTS = [
    Fault("contact 1 % stiff", contact_scaled(1.01), test_a_bounce),
    Fault("mass 1 % high", pantograph_scaled("mass", 1.01), test_a_bounce),
    Fault(f"{schemes.DAMPED.label} in place of the default scheme", stepped_by(schemes.DAMPED),
          test_a_bounce),
]  # fmt: skip
