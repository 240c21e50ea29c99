"""Spectra of records with gaps: of each stretch without one, averaged."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import spectrum

Floats = NDArray[np.float64]

# Length in s of the windows that are averaged, where a stretch is as long: it resolves 0.25 Hz.
WINDOW_S = 4.0


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
