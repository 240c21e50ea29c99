"""Offset and scale of a measurement's positions: limits of their search, and the outcome."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
# Correlation below which a place is doubted: less than half of the variance of the channel (r² of
# 0.5) is then that of the run. Lower lets wrong places pass; higher would doubt noisy records.
POOR_CORRELATION = 0.7


@dataclass(frozen=True)
class Search:
    """Limits of a search.

    Attributes
    ----------
    low_m, high_m
        Least and largest offset in m; infinite for any.
    scale_within
        How far the scale may be from 1; 0 leaves it there.
    """

    low_m: float = -math.inf
    high_m: float = math.inf
    scale_within: float = 0.0


@dataclass(frozen=True)
class Alignment:
    """Offset and scale of positions, and how sure they are.

    Attributes
    ----------
    method
        ``correlation``, ``supports``, ``given`` or ``none``.
    channel
        ``force`` or ``height``, of which the correlation is.
    origin_m
        First position of the measurement in m.
    falling
        Whether its positions fall along the run.
    offset_m
        What is added to the position at the origin, in m.
    scale
        Metres on the line for one metre of the odometer.
    correlation
        Correlation coefficient of the channels there; None where nothing was searched.
    next_offset_m, next_correlation
        The next best maximum; None where there is no other one.
    ambiguous
        Whether noise alone can make the difference between the two.
    beyond_offset_m, beyond_correlation
        A better maximum out of the search, told from the best inside, or where that is poor; None
        where there is none.
    overlap_m
        Common part in m on the line.
    """

    method: str
    origin_m: float
    falling: bool
    offset_m: float
    scale: float
    correlation: float | None = None
    next_offset_m: float | None = None
    next_correlation: float | None = None
    ambiguous: bool = False
    beyond_offset_m: float | None = None
    beyond_correlation: float | None = None
    overlap_m: tuple[float, float] | None = None
    channel: str = "force"

    def on_line(self, position_m: Floats) -> Floats:
        """Return positions of the odometer as positions on the line, in m."""
        run = np.abs(np.asarray(position_m, dtype=np.float64) - self.origin_m)
        return self.origin_m + self.offset_m + self.scale * run
