"""Stretches of a record that count, and the power of a signal in third octaves.

    σ_b² = ∫ S(f) df from f_c 10^(−1/20) to f_c 10^(1/20),    f_c = 10^(n/10) Hz

(IEC 61260-1, base ten; from memory, mark C).
"""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Third octaves by n: from the first that is wider than the resolution of windows of 4 s, 0.25 Hz,
# to the last below 20 Hz.
THIRD_OCTAVES = range(1, 13)
# Length in s of the windows of spectra that are compared, where all records have as long a stretch.
WINDOW_S = 4.0


def common_window_s(longest_s: Iterable[float]) -> float:
    """Return the length in s of windows that every record has a stretch for.

    A window smears a wave over its neighbours, the shorter the more: only spectra of one length of
    windows are alike.

    Parameters
    ----------
    longest_s
        Longest stretch of each record in s.
    """
    return min([WINDOW_S, *longest_s])


def stretches(counted: NDArray[np.bool_], pieces: Sequence[slice] = (slice(None),)) -> list[slice]:
    """Return the runs of samples that count, none of which reaches from one piece into another.

    Parameters
    ----------
    counted
        Samples that count.
    pieces
        Stretches of the record without a gap.
    """
    found = []
    for piece in pieces:
        begin, _, _ = piece.indices(counted.size)
        edges = np.flatnonzero(np.diff(np.concatenate([[False], counted[piece], [False]])))
        found += [slice(begin + int(first), begin + int(last))
                  for first, last in zip(edges[::2], edges[1::2], strict=True)]  # fmt: skip
    return found


def third_octave_Hz(number: int) -> tuple[float, float]:  # noqa: N802 - the unit is in the name
    """Return the ends in Hz of the third octave about 10^(n/10) Hz."""
    centre = 10.0 ** (number / 10.0)
    return float(centre * 10.0**-0.05), float(centre * 10.0**0.05)


def deviation_between(
    frequency: Floats, density: Floats, low_Hz: float, high_Hz: float
) -> float | None:
    """Return the standard deviation of what a signal has between two frequencies.

    Parameters
    ----------
    frequency, density
        In Hz, and the power spectral density there.
    low_Hz, high_Hz
        The two frequencies; None is returned where the density does not reach to the higher one.
    """
    if frequency.size == 0 or high_Hz > frequency[-1]:
        return None
    # The integral up to each frequency, by trapezia: its differences are those of any ends.
    steps = 0.5 * (density[1:] + density[:-1]) * np.diff(frequency)
    summed = np.concatenate([[0.0], np.cumsum(steps)])
    below, above = np.interp([low_Hz, high_Hz], frequency, summed)
    return float(np.sqrt(max(above - below, 0.0)))
