"""Long series → few points that draw the same picture."""

import numpy as np
from numpy.typing import NDArray


def envelope(values: NDArray[np.float64], points: int) -> NDArray[np.intp]:
    """Return the indices of the samples to draw: every bucket's lowest and highest.

    Parameters
    ----------
    values
        One series; a peak of a single sample survives.
    points
        How many samples may remain, at least 4. Shorter series are kept whole.

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
    padded = np.full(buckets * size, values[-1])
    padded[:count] = values
    grid = padded.reshape(buckets, size)
    starts = size * np.arange(buckets)
    picked = [starts + grid.argmin(axis=1), starts + grid.argmax(axis=1), [0, count - 1]]
    indices: NDArray[np.intp] = np.unique(np.minimum(np.concatenate(picked), count - 1))
    return indices


def every(count: int, points: int) -> NDArray[np.intp]:
    """Return at most ``points`` evenly spaced indices of ``count``, both ends included."""
    kept = np.linspace(0, max(count - 1, 0), min(count, points)).round()
    indices: NDArray[np.intp] = np.unique(kept.astype(np.intp))
    return indices
