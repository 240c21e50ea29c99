"""The low-pass of contact-force measurement, applied without phase shift.

A Butterworth filter of order n run forwards and then backwards has no phase shift and the gain

    |H(f)|² = 1 / (1 + (tan(π f / f_s) / tan(π f_c / f_s))^(2n))

that is, it falls as a filter of order 2n and halves a sine at the cut-off instead of taking
3 dB off it. The order here is that of one pass, 6 (EN 50317).
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals import butterworth
from arcless.errors import ModelError, ResultFormatError

ORDER = 6
# Recorded times are i·Δt, rounded; a step that differs by more than this is a real gap.
UNIFORM_STEP_TOLERANCE = 1e-6
# Length of the odd extension at both ends, in periods of the cut-off.
EXTENSION_PERIODS = 3.0


def sample_rate_Hz(time: NDArray[np.float64]) -> float:  # noqa: N802 - the unit is part of the name
    """Return the recording rate of equally spaced times.

    Parameters
    ----------
    time
        Recorded times in s.

    Raises
    ------
    ResultFormatError
        Fewer than two times, or steps of different length.
    """
    steps = np.diff(time)
    if steps.size == 0:
        raise ResultFormatError("the record is too short to assess", got=f"{time.size} time(s)")
    mean = float(time[-1] - time[0]) / steps.size
    if np.max(np.abs(steps - mean)) > UNIFORM_STEP_TOLERANCE * mean:
        raise ResultFormatError("the recorded times are not equally spaced", where="time")
    return 1.0 / mean


def low_pass(signal: NDArray[np.float64], rate_Hz: float, cutoff_Hz: float) -> NDArray[np.float64]:
    """Filter a signal along its first axis, without phase shift.

    Parameters
    ----------
    signal
        Values at equal time steps.
    rate_Hz
        Recording rate in Hz.
    cutoff_Hz
        Frequency in Hz at which a sine is halved.

    Raises
    ------
    ModelError
        The cut-off is not between zero and half the recording rate.
    """
    if not 0.0 < cutoff_Hz < 0.5 * rate_Hz:
        raise ModelError(
            "the low-pass frequency does not fit the record",
            where="analysis.low_pass",
            got=f"{cutoff_Hz:g} Hz",
            expected=f"above 0 and below half the recording rate of {rate_Hz:g} Hz",
            hint="record contact channels more often: output.contact_every",
        )
    sections = butterworth.sections(ORDER, cutoff_Hz, rate_Hz)
    extension = min(signal.shape[0] - 1, round(EXTENSION_PERIODS * rate_Hz / cutoff_Hz))
    columns = signal.reshape(len(signal), -1).T
    filtered = [butterworth.both_ways(sections, column, extension) for column in columns]
    return np.stack(filtered, axis=-1).reshape(signal.shape)


def spectrum(
    signal: NDArray[np.float64], rate_Hz: float, window_s: float = 4.0
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return frequencies in Hz and the one-sided power spectral density (Welch, Hann).

    Windows overlap by half; each loses its mean, and their densities are averaged.

    Parameters
    ----------
    signal
        One-dimensional, at equal time steps; its mean is removed.
    rate_Hz
        Recording rate in Hz.
    window_s
        Length in s of the overlapping windows that are averaged.
    """
    length = min(signal.size, max(2, round(window_s * rate_Hz)))
    hop = length - length // 2
    window = 0.5 - 0.5 * np.cos(2.0 * np.pi * np.arange(length) / length)
    pieces = np.lib.stride_tricks.sliding_window_view(signal, length)[::hop]
    waves = np.fft.rfft((pieces - pieces.mean(axis=1, keepdims=True)) * window, axis=1)
    density = (np.abs(waves) ** 2).mean(axis=0) / (rate_Hz * np.sum(window**2))
    # One-sided: what belongs to frequencies below zero is put to those above.
    density[1 : (length + 1) // 2] *= 2.0
    frequency = np.fft.rfftfreq(length, 1.0 / rate_Hz).astype(np.float64)
    return frequency, density


def spectrum_of(
    pieces: Sequence[NDArray[np.float64]], rate_Hz: float, window_s: float = 4.0
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return frequencies in Hz and the density of a signal with gaps, as `spectrum` does.

    No window reaches over a gap. Densities are averaged by the length of their piece; pieces that
    are shorter than a window are left out, and where all are, windows are as long as the longest.

    Parameters
    ----------
    pieces
        Parts of the signal without a gap, at least one.
    rate_Hz
        Recording rate in Hz.
    window_s
        Length in s of the overlapping windows that are averaged.
    """
    longest = max(piece.size for piece in pieces)
    window_s = min(window_s, longest / rate_Hz)
    whole = [piece for piece in pieces if piece.size >= min(longest, round(window_s * rate_Hz))]
    found = [spectrum(piece, rate_Hz, window_s) for piece in whole]
    if len(found) == 1:
        return found[0]
    weights = [piece.size for piece in whole]
    return found[0][0], np.average([density for _, density in found], axis=0, weights=weights)
