"""Time, position and speed of samples from what a file has of them.

    dt = |dx|/v          of a file with positions and speeds,
    dx = v dt            of one with times and speeds,

each step by the mean of the speeds at its two ends (trapezoidal rule).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError

Floats = NDArray[np.float64]

# In m/s. Below, a train as good as stands, and positions say nothing about times; higher would
# refuse a train that starts.
LEAST_SPEED = 0.01
# Speeds and positions are compared over so many seconds: over a single sample the last decimal of
# the position would decide. Of a short record it is so large a part: longer, and a jump of the
# position lies in most stretches, and moves their median.
COMPARED_S, COMPARED_PART = 10.0, 0.2
# Part by which they may differ in the median: worn wheels and slip are 1 % or so. More lets another
# unit or another train pass; less would refuse plain odometers.
SPEED_DIFFERENCE = 0.02


@dataclass(frozen=True)
class Clock:
    """When and where samples were taken.

    Attributes
    ----------
    time
        In s, rising.
    position
        In m along the track, rising or falling.
    speed
        In m/s; None where it follows from time and position.
    reading
        The column that samples were taken by, time in s or distance in m, rising.
    by
        "time" or "position", its name.
    """

    time: Floats
    position: Floats
    speed: Floats | None
    reading: Floats
    by: str


def clock(
    columns: dict[str, Floats], speed: float | None, lines: NDArray[np.int64], label: str
) -> Clock:
    """Return the clock of samples whose time, position and speed are numbers.

    Parameters
    ----------
    columns
        Those of `time`, `position`, `speed` that the file has.
    speed
        Constant speed in m/s; used where the file lacks a column of speeds, and time or position.
    lines
        Line of each sample, for messages.
    label
        The file, for messages.

    Raises
    ------
    MeasurementError
        Times or distances do not rise, there are too few columns to tell one from the other, or
        the speeds are not those of times and positions.
    """
    time, position = columns.get("time"), columns.get("position")
    if time is None and position is None:
        raise MeasurementError(
            "missing column", where=label, got="no time and no position",
            expected="time [s], position [m], or both",
        )  # fmt: skip
    speeds = columns.get("speed")
    if speeds is None and speed is not None and (time is None or position is None):
        speeds = np.full(lines.size, speed)
    if time is not None:
        _check_rises(time, "time", lines, label)
        if position is None:
            if speeds is None:
                raise _no_speed("positions", label)
            position = _summed(speeds, np.diff(time))
        elif speeds is not None:
            _check_speeds(time, position, speeds, label)
        return Clock(time, position, speeds, time, "time")
    assert position is not None
    if speeds is None:
        raise _no_speed("times", label)
    distance = position if position[-1] >= position[0] else -position
    _check_rises(distance, "position", lines, label)
    if (slow := np.flatnonzero(speeds < LEAST_SPEED)).size:
        raise MeasurementError(
            "speed of a record without times",
            where=f"{label}:{lines[slow[0]]}",
            got=f"{speeds[slow[0]]:g} m/s",
            expected=f"at least {LEAST_SPEED:g} m/s",
            hint="give a column time [s], or cut off where the train stands",
        )
    return Clock(_summed(1.0 / speeds, np.diff(distance)), position, speeds, distance, "position")


def _check_speeds(time: Floats, position: Floats, speeds: Floats, label: str) -> None:
    """Refuse speeds that are not those of times and positions: one of the columns is wrong."""
    seconds = min(COMPARED_S, COMPARED_PART * float(time[-1] - time[0]))
    apart = min(time.size - 1, max(1, round(seconds / float(np.median(np.diff(time))))))
    run = np.abs(position[apart:] - position[:-apart])
    summed = _summed(speeds, np.diff(time))
    least = LEAST_SPEED * (time[apart:] - time[:-apart])
    moving = (run > least) & (summed[apart:] - summed[:-apart] > least)
    if not moving.any():
        return
    share = float(np.median(run[moving] / (summed[apart:] - summed[:-apart])[moving]))
    if abs(share - 1.0) <= SPEED_DIFFERENCE:
        return
    own = float(np.median((run / (time[apart:] - time[:-apart]))[moving]))
    raise MeasurementError(
        "column speed against time and position",
        where=label,
        got=f"{3.6 * own / share:.4g} km/h, where time and position give {3.6 * own:.4g} km/h",
        expected=f"speeds within {100 * SPEED_DIFFERENCE:g} %",
        hint="is the unit of one of the three columns wrong? Or leave out the column that is",
    )


def _summed(rate: Floats, steps: Floats) -> Floats:
    """Return the integral of a rate over steps, from zero."""
    return np.concatenate([[0.0], np.cumsum(0.5 * (rate[1:] + rate[:-1]) * steps)])


def _no_speed(what: str, label: str) -> MeasurementError:
    return MeasurementError(
        f"no speed, so there are no {what}",
        where=label,
        expected="a column speed [km/h], or a constant speed",
        hint='give the speed, such as "250 km/h"',
    )


def _check_rises(values: Floats, name: str, lines: NDArray[np.int64], label: str) -> None:
    """Refuse a clock that goes back or stands: what was measured when would be a guess."""
    wrong = np.flatnonzero(np.diff(values) <= 0.0)
    if not wrong.size:
        return
    before, here = values[wrong[0]], values[wrong[0] + 1]
    unit = "s" if name == "time" else "m"
    stands = here == before
    hint = None
    if stands and name == "time":
        hint = "write times with more digits; samples of one time with other values are no record"
    elif name == "position":
        hint = "give a column time [s], so that the position may jump"
    raise MeasurementError(
        f"{name} {'stands' if stands else 'goes back'}",
        where=f"{label}:{lines[wrong[0] + 1]}",
        got=f"{here:.10g} {unit} after {before:.10g} {unit} in line {lines[wrong[0]]}",
        expected=f"a {name} that rises from sample to sample"
        + (", or falls all the way" if name == "position" else ""),
        hint=hint,
    )
