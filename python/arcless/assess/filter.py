"""The low-pass of contact-force measurement, applied without phase shift.

A Butterworth filter of order n run forwards and then backwards has no phase shift and the gain

    |H(f)|² = 1 / (1 + (tan(π f / f_s) / tan(π f_c / f_s))^(2n))

that is, it falls as a filter of order 2n and halves a sine at the cut-off instead of taking
3 dB off it. The order here is that of one pass, 6 (EN 50317).
"""

import numpy as np
from numpy.typing import NDArray

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
    from scipy.signal import butter, sosfiltfilt

    if not 0.0 < cutoff_Hz < 0.5 * rate_Hz:
        raise ModelError(
            "the low-pass frequency does not fit the record",
            where="analysis.low_pass",
            got=f"{cutoff_Hz:g} Hz",
            expected=f"above 0 and below half the recording rate of {rate_Hz:g} Hz",
            hint="record contact channels more often: output.contact_every",
        )
    sections = butter(ORDER, cutoff_Hz, fs=rate_Hz, output="sos")
    extension = min(signal.shape[0] - 1, round(EXTENSION_PERIODS * rate_Hz / cutoff_Hz))
    filtered: NDArray[np.float64] = sosfiltfilt(sections, signal, axis=0, padlen=extension)
    return filtered


def spectrum(
    signal: NDArray[np.float64], rate_Hz: float, window_s: float = 4.0
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return frequencies in Hz and the one-sided power spectral density (Welch, Hann).

    Parameters
    ----------
    signal
        One-dimensional, at equal time steps; its mean is removed.
    rate_Hz
        Recording rate in Hz.
    window_s
        Length in s of the overlapping windows that are averaged.
    """
    from scipy.signal import welch

    length = min(signal.size, max(2, round(window_s * rate_Hz)))
    frequency, density = welch(signal, fs=rate_Hz, nperseg=length, detrend="constant")
    return frequency, density
