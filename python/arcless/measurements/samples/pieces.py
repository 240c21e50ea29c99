"""Good samples → pieces without a gap, each at equal time steps.

Where the times of a piece are not equally spaced, its values are interpolated between neighbouring
samples, never across a gap. A sine of frequency f then loses on average

    1 − sinc²(f Δt),    sinc x = sin(πx)/(πx)

of its amplitude (the spectrum of the triangle that linear interpolation lays over each sample:
Oppenheim & Schafer, Discrete-Time Signal Processing, section 4.6.1).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Places = NDArray[np.intp]

# A step beyond so many usual ones is a gap: a single missing sample makes one of 2. Lower, and the
# jitter of a recorder is one; higher, and a missing sample is filled.
GAP_STEPS = 1.5
# A position that moves by more than this (m) beyond what the speed says has jumped. Odometers count
# whole metres; corrections at balises are larger.
JUMP_M = 2.0
# Times that differ by less than this share of a step from equally spaced ones are taken as such:
# at 20 Hz and 200 samples a second it is an error of 0.6 % of a wave's amplitude at most.
UNIFORM_SHARE = 0.01


@dataclass(frozen=True)
class Breaks:
    """Places between samples, each the number of the sample before it.

    Attributes
    ----------
    gaps
        Where samples are missing.
    jumps
        Where the position jumps, and no sample is missing.
    """

    gaps: Places
    jumps: Places


def usual_step(reading: Floats) -> float:
    """Return the median distance of two samples."""
    median: np.float64 = np.median(np.diff(reading))
    return float(median)


def breaks(
    reading: Floats, good: NDArray[np.bool_], time: Floats, position: Floats, speed: Floats
) -> Breaks:
    """Find gaps and jumps of position.

    Parameters
    ----------
    reading
        Clock of the samples, time in s or distance in m.
    good
        Samples that count; one that does not is no gap here.
    time, position, speed
        In s, m and m/s.
    """
    gap = np.diff(reading) > GAP_STEPS * usual_step(reading)
    moved, forward = np.diff(position), 1.0 if position[-1] >= position[0] else -1.0
    expected = 0.5 * (speed[1:] + speed[:-1]) * np.diff(time)
    jump = (np.abs(forward * moved - expected) > JUMP_M) & ~gap & good[1:] & good[:-1]
    return Breaks(np.flatnonzero(gap), np.flatnonzero(jump))


def pieces_of(good: NDArray[np.bool_], cuts: Places) -> list[slice]:
    """Return stretches of good samples that no cut divides; a cut stands behind its sample."""
    ends = np.zeros(good.size, bool)
    ends[cuts] = True
    begins_here = good & np.concatenate([[True], ~good[:-1] | ends[:-1]])
    ends_here = good & np.concatenate([~good[1:] | ends[:-1], [True]])
    pairs = zip(np.flatnonzero(begins_here), np.flatnonzero(ends_here) + 1, strict=True)
    return [slice(int(begin), int(end)) for begin, end in pairs]


def common_step(time: Floats, pieces: list[slice]) -> float:
    """Return the mean time step in s over all pieces, each of two samples or more."""
    durations = [float(time[piece.stop - 1] - time[piece.start]) for piece in pieces]
    steps = sum(int(piece.stop - piece.start) - 1 for piece in pieces)
    return sum(durations) / steps


def is_uniform(time: Floats, step_s: float) -> bool:
    """Return whether times of a piece are as good as equally spaced."""
    ideal = time[0] + step_s * np.arange(time.size)
    return bool(np.max(np.abs(time - ideal)) <= UNIFORM_SHARE * step_s)


def resampled(time: Floats, step_s: float, columns: list[Floats]) -> tuple[Floats, list[Floats]]:
    """Return equally spaced times from the first one, and values interpolated to them.

    A value next to a missing one (NaN) is missing.
    """
    count = int((time[-1] - time[0]) / step_s * (1.0 + 1e-12)) + 1
    times = time[0] + step_s * np.arange(count)
    return times, [np.interp(times, time, column) for column in columns]


def interpolation_loss(frequency_Hz: float, step_s: float) -> float:
    """Return the share that linear interpolation takes off a sine, on average."""
    return 1.0 - float(np.sinc(frequency_Hz * step_s) ** 2)
