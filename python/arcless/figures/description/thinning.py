"""Long series → few points that draw the same picture."""

import numpy as np
from numpy.typing import NDArray


def envelope(values: NDArray[np.float64], points: int) -> NDArray[np.intp]:
    """Return the indices of the samples to draw: every bucket's lowest and highest.

    Parameters
    ----------
    values
        One series; a peak of a single sample survives, and a gap (NaN) stays one.
    points
        How many samples may remain besides gaps, at least 4. Shorter series are kept whole.

    Returns
    -------
    numpy.ndarray
        Increasing indices, first and last sample included.
    """
    count = values.size
    if count <= points:
        return np.arange(count)
    buckets = (points - 2) // 2
    size = -(-count // buckets)
    starts, missing = size * np.arange(buckets), np.isnan(values)

    def grid(missed: float) -> NDArray[np.float64]:
        padded = np.full(buckets * size, missed if missing[-1] else values[-1])
        padded[:count] = np.where(missing, missed, values)
        return padded.reshape(buckets, size)

    lowest, highest = grid(np.inf).argmin(axis=1), grid(-np.inf).argmax(axis=1)
    gaps = np.flatnonzero(missing & ~np.concatenate([[False], missing[:-1]]))
    picked = [starts + lowest, starts + highest, [0, count - 1], gaps]
    indices: NDArray[np.intp] = np.unique(np.minimum(np.concatenate(picked), count - 1))
    return indices


def every(count: int, points: int) -> NDArray[np.intp]:
    """Return at most ``points`` evenly spaced indices of ``count``, both ends included."""
    kept = np.linspace(0, max(count - 1, 0), min(count, points)).round()
    indices: NDArray[np.intp] = np.unique(kept.astype(np.intp))
    return indices
