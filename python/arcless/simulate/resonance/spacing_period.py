"""Period over the spacing of two pantographs of what happens to the trailing one.

All that a pantograph leaves behind on a line of equal spans looks the same to the next one at the
same place of each span. So a wave in its wake with the frequency ω and the wave number k fulfils
ω = v k + 2π n v/L, and a place is met by the trailing pantograph d/v after the leading one: each
wave turns by ω d/v. Over d the mean square of the force is then

    σ²(d) = a₀ + a₁ cos(2π f d/v) + b₁ sin(2π f d/v) + …,   f = ω/2π

as long as one wave is the strongest (the orders n = 2, 3, … are short waves and small). Of a free
wire f = v/(L (1 + v/c)): the wave that runs back takes d/(c + v) to the trailing one.
"""

from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Distances that a period needs at least, and periods from one to the next tried.
LEAST_POINTS = 8
STEP = 1.005
# Three unknowns for each period that is tried: below this many points a period the fit follows
# anything.
POINTS_A_PERIOD = 4.0


@dataclass(frozen=True)
class SpacingPeriod:
    """Cosine over the spacing that fits the square of some values best.

    Attributes
    ----------
    length
        Period in m.
    share
        Part of the variance of the squares that it explains.
    first_worst
        Smallest spacing in m at which the cosine is highest.
    """

    length: float
    share: float
    first_worst: float

    def frequency(self, speed: float) -> float:
        """Return the frequency f = v/period in Hz at a speed in m/s."""
        return speed / self.length

    def phase(self, spacing: float) -> float:
        """Return the distance in periods to the nearest crest, −½ to ½, of a spacing in m."""
        turns = (spacing - self.first_worst) / self.length
        return turns - round(turns)


def spacing_period(spacings: Floats, values: Floats) -> SpacingPeriod | None:
    """Return the period that the squares of values have over the spacing.

    Parameters
    ----------
    spacings
        In m, ascending.
    values
        Such as standard deviations in N.

    Returns
    -------
    SpacingPeriod or None
        None with fewer than `LEAST_POINTS` spacings, or values that are all equal.
    """
    squares = values**2
    spread = float(np.sum((squares - squares.mean()) ** 2))
    if len(spacings) < LEAST_POINTS or spread <= 0.0:
        return None
    reach = float(np.ptp(spacings))
    shortest = POINTS_A_PERIOD * reach / (len(spacings) - 1)
    count = int(np.log(reach / shortest) / np.log(STEP)) + 1
    fits = [fitted(spacings, squares, shortest * STEP**number) for number in range(count)]
    length, left, (_, cosine, sine) = min(fits, key=lambda one: one[1])
    crest = float(np.arctan2(sine, cosine)) / (2.0 * pi) * length
    return SpacingPeriod(length, 1.0 - left / spread, crest % length)


def fitted(spacings: Floats, squares: Floats, length: float) -> tuple[float, float, Floats]:
    """Return a period in m, the squares left over by the cosine with it, its three coefficients."""
    turns = 2.0 * pi * spacings / length
    basis = np.column_stack([np.ones_like(turns), np.cos(turns), np.sin(turns)])
    found, *_ = np.linalg.lstsq(basis, squares, rcond=None)
    return length, float(np.sum((squares - basis @ found) ** 2)), found
