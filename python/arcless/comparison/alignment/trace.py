"""A channel along the track, and its values at equal distances."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
# Samples further apart than this many usual distances have a gap between them. Smaller would take
# the jitter of an odometer for gaps, larger would draw a straight line over missing samples.
GAP = 4.0


@dataclass(frozen=True, eq=False)
class Trace:
    """A channel along the track.

    Attributes
    ----------
    position_m
        Positions in m, not falling.
    values
        Of the channel, such as the filtered contact force in N.
    valid
        Samples that count.
    shortest_m
        Shortest wave in m that the channel has: the speed over the cut-off of its low-pass.
    """

    position_m: Floats
    values: Floats
    valid: Flags
    shortest_m: float

    @property
    def length_m(self) -> float:
        """Distance in m from the first sample that counts to the last one."""
        return float(np.ptp(self.position_m[self.valid])) if self.valid.any() else 0.0

    @property
    def known_m(self) -> float:
        """Length in m of what counts, gaps left out."""
        if self.position_m.size < 2:  # noqa: PLR2004 - one sample has no length
            return 0.0
        return float(np.median(np.diff(self.position_m))) * np.count_nonzero(self.valid)

    def at(self, places: Floats) -> tuple[Floats, Flags]:
        """Return values at places in m, linear between samples, and which of them are known.

        A place in a gap, at samples that do not count, or beyond the ends is not known.
        """
        x, y = self.position_m[self.valid], self.values[self.valid]
        if x.size < 2:  # noqa: PLR2004 - there is nothing between fewer
            return np.zeros_like(places), np.zeros(places.shape, dtype=np.bool_)
        usual = float(np.median(np.diff(self.position_m)))
        right = np.clip(np.searchsorted(x, places, side="left"), 1, x.size - 1)
        known = (places >= x[0]) & (places <= x[-1])
        known &= x[right] - x[right - 1] <= GAP * usual
        return np.interp(places, x, y), known

    def on_grid(self, start_m: float, step_m: float, scale: float = 1.0) -> tuple[Floats, Flags]:
        """Return values at ``start_m + step_m · i`` of the positions stretched by a factor.

        The stretch leaves `start_m` where it is. Values that are not known are zero.
        """
        end = start_m + scale * (float(self.position_m[-1]) - start_m)
        places: Floats = start_m + step_m * np.arange(int((end - start_m) / step_m) + 1.0)
        values, known = self.at(start_m + (places - start_m) / scale)
        return np.where(known, values, 0.0), known
