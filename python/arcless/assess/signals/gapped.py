"""Spectra of records with gaps: of each stretch without one, averaged; power in third octaves.

    σ_b² = ∫ S(f) df from f_c 10^(−1/20) to f_c 10^(1/20),    f_c = 10^(n/10) Hz

(IEC 61260-1, base ten; from memory, mark C).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import spectrum

Floats = NDArray[np.float64]

# Length in s of the windows that are averaged, where a stretch is as long: it resolves 0.25 Hz.
WINDOW_S = 4.0
# Third octaves by n: from the first that is wider than that resolution to the last below 20 Hz.
THIRD_OCTAVES = range(1, 13)


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


def spectrum_of_stretches(
    signal: Floats, rate_Hz: float, parts: Sequence[slice], window_s: float = WINDOW_S
) -> tuple[Floats, Floats]:
    """Return frequencies in Hz and the one-sided power spectral density of a record with gaps.

    Stretches shorter than a window are left out; where all are, the window is the longest one.

    Parameters
    ----------
    signal
        One-dimensional, at equal time steps in each stretch.
    rate_Hz
        Recording rate in Hz.
    parts
        The stretches; at least one of two samples or more.
    window_s
        Length in s of the overlapping windows that are averaged.
    """
    sizes = [part.stop - part.start for part in parts]
    length = min(max(sizes), max(2, round(window_s * rate_Hz)))
    hop = length - length // 2
    total, windows, frequency = 0.0, 0, np.empty(0)
    for part, size in zip(parts, sizes, strict=True):
        if size >= length:
            frequency, density = spectrum(signal[part], rate_Hz, length / rate_Hz)
            count = 1 + (size - length) // hop
            total, windows = total + count * density, windows + count
    return frequency, np.asarray(total / windows, dtype=np.float64)


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
