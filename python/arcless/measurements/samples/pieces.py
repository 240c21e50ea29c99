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

from arcless.measurements.samples.clock import Clock

Floats = NDArray[np.float64]
Places = NDArray[np.intp]

# A step beyond so many usual ones is a gap: a single missing sample makes one of 2. Lower, and the
# jitter of a recorder is one; higher, and a missing sample is filled.
GAP_STEPS = 1.5
# Share of a step by which steps must differ, from the shortest to the 95th of 100, for a clock to
# seem rounded: a missing sample makes none shorter. Lower, and 16 digits are rounding; higher is
# beyond `UNIFORM_SHARE`.
ROUNDED_SHARE = 0.01
# Most decimals that a clock may be rounded to: recorders write milliseconds to nanoseconds.
MOST_DECIMALS = 9
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


def resolution(reading: Floats) -> float:
    """Return the last decimal that a clock is rounded to, in its unit; 0 where it is not.

    A clock of 512 Hz in whole milliseconds has steps of 1 ms and 2 ms. Without rounding all steps
    are as good as equal, or differ in all decimals.
    """
    steps = np.diff(reading)
    low, usual, high = np.percentile(steps, [0.0, 50.0, 95.0])
    if high - low <= ROUNDED_SHARE * usual:
        return 0.0
    for decimals in range(MOST_DECIMALS + 1):
        scaled = reading * 10.0**decimals
        if np.allclose(scaled, np.round(scaled), rtol=1e-12, atol=1e-3):
            return float(10.0**-decimals)
    return 0.0


def usual_step(reading: Floats, rounded: float = 0.0) -> float:
    """Return the distance of two samples: the median, of a rounded clock the mean around it."""
    steps = np.diff(reading)
    median = float(np.percentile(steps, 50.0))
    return float(np.mean(steps[steps <= median + 1.5 * rounded])) if rounded else median


def breaks(when: Clock, good: NDArray[np.bool_], speed: Floats, rounded: float) -> Breaks:
    """Find gaps and jumps of position.

    Parameters
    ----------
    when
        Clock of the samples.
    good
        Samples that count; one that does not is no gap here.
    speed
        In m/s, for each sample.
    rounded
        Last decimal of the clock, see `resolution`: a step may seem longer by so much.
    """
    position = when.position
    gap = np.diff(when.reading) > GAP_STEPS * usual_step(when.reading, rounded) + 0.5 * rounded
    moved, forward = np.diff(position), 1.0 if position[-1] >= position[0] else -1.0
    expected = 0.5 * (speed[1:] + speed[:-1]) * np.diff(when.time)
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


def common_step(time: Floats, pieces: list[slice], rounded_s: float = 0.0) -> float:
    """Return the time step in s over all pieces, each of two samples or more.

    It is the mean; of rounded times the slope of the straight line that is nearest to all pieces,
    which the two ends of a piece cannot tilt.
    """
    if rounded_s:
        over, under = 0.0, 0.0
        for piece in pieces:
            count = np.arange(piece.stop - piece.start) - 0.5 * (piece.stop - piece.start - 1)
            over += float(count @ (time[piece] - time[piece.start]))
            under += float(count @ count)
        return over / under
    durations = [float(time[piece.stop - 1] - time[piece.start]) for piece in pieces]
    steps = sum(int(piece.stop - piece.start) - 1 for piece in pieces)
    return sum(durations) / steps


def is_uniform(time: Floats, step_s: float) -> bool:
    """Return whether times of a piece are as good as equally spaced."""
    ideal = time[0] + step_s * np.arange(time.size)
    return bool(np.max(np.abs(time - ideal)) <= UNIFORM_SHARE * step_s)


def unrounded(time: Floats, step_s: float, rounded_s: float) -> Floats | None:
    """Return equally spaced times that were rounded to those of a piece; None if there are none.

    Parameters
    ----------
    time
        Times of the piece in s.
    step_s
        Their distance before they were rounded.
    rounded_s
        Their last decimal, in s.
    """
    ideal = step_s * np.arange(time.size)
    low, high = float(np.min(time - ideal)), float(np.max(time - ideal))
    if high - low > rounded_s + UNIFORM_SHARE * step_s:
        return None
    return np.asarray(0.5 * (low + high) + ideal, np.float64)


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
