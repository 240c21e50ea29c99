"""Series → a pyramid of extremes, from which any range is drawn with as many points as wished.

Level k holds, for each bucket of 8ᵏ samples, where the lowest and the highest one is. Samples that
are shown are samples of the series: no peak is lost, and none is made up.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.floating[Any]]
Indices = NDArray[np.int32]

# Samples of one bucket in the level below. Smaller, the pyramid takes more memory (2/7 of the
# samples at 8, as indices of 4 bytes); larger, an answer goes through more buckets.
FACTOR = 8
# Buckets below which no further level is of use: fewer than a chart is wide in pixels.
LEAST_BUCKETS = 64


@dataclass(frozen=True, eq=False)
class Pyramid:
    """Extremes of a series at several levels.

    Attributes
    ----------
    values
        The series; NaN is a gap.
    levels
        Indices of the lowest and of the highest sample of each bucket, from 8 samples upwards. A
        bucket without a number has the index of its first sample, a NaN.
    gaps
        First sample of each gap.
    """

    values: Values
    levels: tuple[tuple[Indices, Indices], ...]
    gaps: Indices

    @classmethod
    def of(cls, values: Values) -> "Pyramid":
        """Build the pyramid of a series, in a time proportional to its length."""
        levels: list[tuple[Indices, Indices]] = []
        low = high = np.arange(values.size, dtype=np.int32)
        while low.size > LEAST_BUCKETS:
            low, high = extremes(values, low, high, FACTOR)
            levels.append((low, high))
        missing = np.isnan(values)
        begins = missing & ~np.concatenate([[False], missing[:-1]])
        return cls(values, tuple(levels), np.flatnonzero(begins).astype(np.int32))

    @property
    def bytes(self) -> int:
        """Memory of the levels, without the series."""
        return sum(low.nbytes + high.nbytes for low, high in self.levels)

    def buckets(self, begin: int, end: int, count: int) -> tuple[Indices, Indices]:
        """Return where the extremes of equal buckets are, over a range of samples.

        Parameters
        ----------
        begin, end
            Samples of the range, `end` not included. Buckets at its ends may reach beyond it.
        count
            Most buckets, at least 1.

        Returns
        -------
        tuple of numpy.ndarray
            Indices of the lowest and of the highest sample of each bucket. Of a range that has no
            more samples than `count` both are the samples themselves.
        """
        size, low, high = 1, None, None
        for level in self.levels:
            # The coarsest level that is fine enough: a few of its buckets make one of the answer.
            if (end - begin) < FACTOR * size * count:
                break
            size, (low, high) = size * FACTOR, level
        first, last = begin // size, -(-end // size)
        if low is None or high is None:
            low = high = np.arange(begin, end, dtype=np.int32)
        else:
            low, high = low[first:last], high[first:last]
        together = -(-low.size // count)
        return (low, high) if together <= 1 else extremes(self.values, low, high, together)

    def samples(self, begin: int, end: int, points: int) -> Indices:
        """Return the samples of a range that draw the same picture, rising; a gap stays one.

        Parameters
        ----------
        begin, end
            Samples of the range, `end` not included.
        points
            How many may remain besides gaps, at least 2; a range with no more is kept whole.
        """
        if end - begin <= points:
            return np.arange(begin, end, dtype=np.int32)
        first, last = np.searchsorted(self.gaps, (begin, end))
        picked = [*self.buckets(begin, end, points // 2), self.gaps[first:last]]
        kept: Indices = np.unique(np.concatenate(picked))
        return kept


def extremes(values: Values, low: Indices, high: Indices, together: int) -> tuple[Indices, Indices]:
    """Return where the extremes of so many neighbouring buckets are.

    Parameters
    ----------
    values
        The series.
    low, high
        Indices of the extremes of each bucket.
    together
        Buckets that become one; the last one may have fewer.
    """
    return (
        _best(low, values[low], together, np.inf, np.argmin),
        _best(high, values[high], together, -np.inf, np.argmax),
    )


def _best(where: Indices, values: Values, together: int, missed: float, which: Any) -> Indices:
    count = -(-where.size // together)
    padding = (0, count * together - where.size)
    rows = np.pad(where, padding, mode="edge").reshape(count, together)
    filled = np.where(np.isnan(values), missed, values)
    found = np.pad(filled, padding, mode="edge").reshape(count, together)
    best = which(found, axis=1)
    picked: Indices = rows[np.arange(count), best]
    return picked
