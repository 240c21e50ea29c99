"""Columns of one pantograph → its good samples, in pieces at equal time steps."""

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError
from arcless.measurements.samples import inertia
from arcless.measurements.samples import left_out as kinds
from arcless.measurements.samples.clock import Clock, clock
from arcless.measurements.samples.faults import CLIPPED_SAMPLES, clipped, codes, frozen, held
from arcless.measurements.samples.inertia import Head
from arcless.measurements.samples.left_out import LeftOut
from arcless.measurements.samples.pantograph import MeasuredPantograph
from arcless.measurements.samples.pieces import (
    breaks,
    common_step,
    is_uniform,
    pieces_of,
    resampled,
    resolution,
    unrounded,
    usual_step,
)
from arcless.measurements.samples.raw import (
    CLOCKS,
    Raw,
    nothing_left,
    place_between,
    stretches_of,
    with_clock,
    without_duplicates,
)

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Steps of time that a piece has at least: fewer may be a single sample at equal steps. Statistics
# leave out more at the ends of pieces.
SHORTEST_STEPS = 1.5
# Kept with the force, where the file has them; a missing value of theirs takes no sample away.
OPTIONAL = ("contact_height", "uplift")


def prepared(raw: Raw, speed: float | None, head: Head | None) -> MeasuredPantograph:
    """Return what is left of a pantograph's samples when all that is wrong is left out.

    Parameters
    ----------
    raw
        Its columns.
    speed
        Constant speed in m/s for a file without one.
    head
        What is above the sensors; None makes no correction.

    Raises
    ------
    MeasurementError
        Time goes back, columns are missing that the clock or the correction needs, or no piece of
        the record is left.
    """
    told: list[LeftOut] = []
    raw = with_clock(raw, told)
    raw = without_duplicates(raw, told)
    if raw.lines.size < 2:  # noqa: PLR2004 - two samples have a distance
        raise nothing_left(raw, "one sample")
    known = {key: raw.channels[key] for key in CLOCKS if key in raw.channels}
    when = clock(known, speed, raw.lines, raw.label)
    force = _force(raw, when, head)
    hold = max(map(held, raw.measured.values()))
    good = _good(raw, when, force, hold, told)
    rounded = resolution(when.reading)
    pieces = _pieces(raw, when, good, rounded, told)
    columns = {"position": when.position, "force": force}
    columns |= {} if when.speed is None else {"speed": when.speed}
    columns |= {key: raw.channels[key] for key in OPTIONAL if key in raw.channels}
    rounded_s = rounded * _seconds_per_reading(when)
    step = common_step(when.time, pieces, rounded_s)
    kept, places, interpolated = _joined(when, columns, pieces, (step, rounded_s))
    if when.speed is None:
        kept["speed"] = _own_speed(kept["time"], kept["position"], places)
    return MeasuredPantograph(
        name=raw.name,
        **{key: kept[key] for key in ("time", "position", "speed", "force")},
        is_contact_force="contact_force" in raw.channels or head is not None,
        height=kept.get("contact_height"),
        uplift=kept.get("uplift"),
        pieces=places,
        rate_Hz=1.0 / step,
        held=hold,
        interpolated=interpolated,
        rounded_s=rounded_s,
        clock=when.by,
        first_s=float(when.time[0]),
        last_s=float(when.time[-1]),
        first_m=float(when.position[0]),
        last_m=float(when.position[-1]),
        left_out=tuple(sorted(told, key=lambda one: one.line)),
    )


def _good(raw: Raw, when: Clock, force: Floats, hold: int, told: list[LeftOut]) -> Mask:
    """Return samples that are numbers, neither clipped nor frozen, and tell of the others."""
    good = np.isfinite(force)
    step = usual_step(when.time)
    for title, values in raw.measured.items():
        told += stretches_of(np.isnan(values), kinds.EMPTY, raw, when, title)
        code = codes(values)
        told += stretches_of(code, kinds.CODE, raw, when, title)
        good &= ~code
        values = np.where(code, np.nan, values)  # noqa: PLW2901 - a code is no end of a range
        lower, upper = clipped(values, CLIPPED_SAMPLES * hold)
        ends = lower | upper
        dead = frozen(values, step * hold) & ~ends
        for end, there in ((kinds.LOWER, lower), (kinds.UPPER, upper)):
            told += (
                replace(one, end=end, rail=float(values[there][0]))
                for one in stretches_of(there, kinds.CLIPPED, raw, when, title)
            )
        told += stretches_of(dead, kinds.FROZEN, raw, when, title)
        good &= ~(ends | dead)
    return good


def _force(raw: Raw, when: Clock, head: Head | None) -> Floats:
    where = f"{raw.label}: pantograph {raw.name}"
    if "contact_force" in raw.channels:
        if head is not None:
            raise MeasurementError(
                "mass above the sensors", where=where,
                got="a column contact_force, which is the contact force already",
                expected="columns of sensors below the strips: sensor_force_1 [N]",
            )  # fmt: skip
        return raw.channels["contact_force"]
    if head is None:
        return inertia.contact_force(list(raw.sensors.values()))
    if not raw.accelerations:
        hint = "heights are not differentiated: noise would be all that is left"
        raise MeasurementError(
            "correction of inertia", where=where, got="no acceleration of the collector head",
            expected="a column acceleration [m/s2]", hint=hint,
        )  # fmt: skip
    for title, values in raw.accelerations.items():
        inertia.check_mean(values, f"{where}: {title}")
    mean = np.mean(np.stack(list(raw.accelerations.values())), axis=0)
    speeds = _speeds(when)
    return inertia.contact_force(list(raw.sensors.values()), mean, speeds, head)


def _speeds(when: Clock) -> Floats:
    """Return speeds in m/s; the median of the record where the file has none."""
    if when.speed is not None:
        return when.speed
    usual = float(np.median(np.abs(np.diff(when.position)) / np.diff(when.time)))
    return np.full(when.time.size, usual)


def _seconds_per_reading(when: Clock) -> float:
    """Return 1/v where samples were taken by distance at one speed; 0 at several, 1 by time."""
    if when.by == "time" or when.speed is None:
        return 1.0
    return 0.0 if np.ptp(when.speed) else 1.0 / float(when.speed[0])


def _pieces(raw: Raw, when: Clock, good: Mask, rounded: float, told: list[LeftOut]) -> list[slice]:
    """Cut the record at gaps and jumps, and tell of them."""
    cut = breaks(when, good, _speeds(when), rounded)
    usual = usual_step(when.reading, rounded)
    for place in cut.gaps:
        missing = round((when.reading[place + 1] - when.reading[place]) / usual) - 1
        missing -= int(raw.order[place + 1] - raw.order[place]) - 1  # told as empty cells
        if missing > 0:
            told.append(place_between(kinds.GAP, raw, when, int(place), missing))
    told += [place_between(kinds.JUMP, raw, when, int(place), 0) for place in cut.jumps]
    found = pieces_of(good, np.concatenate([cut.gaps, cut.jumps]))
    least = SHORTEST_STEPS * usual_step(when.time)
    short = np.zeros(good.size, bool)
    for piece in found:
        short[piece] = when.time[piece.stop - 1] - when.time[piece.start] < least
    told += stretches_of(short, kinds.SHORT, raw, when)
    kept = [piece for piece in found if not short[piece.start]]
    if not kept:
        raise nothing_left(raw, _summary(told))
    return kept


def _joined(
    when: Clock, columns: Mapping[str, Floats], pieces: list[slice], steps: tuple[float, float]
) -> tuple[dict[str, Floats], tuple[slice, ...], bool]:
    """Put the pieces one behind the other, at one time step.

    Parameters
    ----------
    when, columns, pieces
        Clock, values, and places of the pieces in them.
    steps
        Time step, and last decimal of the times, in s.

    Returns
    -------
    columns
        The columns given, and `time`.
    pieces
        Where each piece now stands.
    interpolated
        True where one was not equally spaced in time.
    """
    parts: list[list[Floats]] = []
    (step_s, rounded_s), stops, interpolated = steps, [0], False
    for piece in pieces:
        time, values = when.time[piece], [column[piece] for column in columns.values()]
        if not is_uniform(time, step_s):
            ideal = unrounded(time, step_s, rounded_s)
            interpolated |= ideal is None
            time, values = resampled(time, step_s, values) if ideal is None else (ideal, values)
        parts.append([time, *values])
        stops.append(stops[-1] + time.size)
    whole = [np.concatenate(column) for column in zip(*parts, strict=True)]
    places = tuple(slice(*bounds) for bounds in pairwise(stops))
    return dict(zip(("time", *columns), whole, strict=True)), places, interpolated


def _own_speed(time: Floats, position: Floats, pieces: tuple[slice, ...]) -> Floats:
    """Return the mean speed of each piece in m/s: positions are too coarse for a shorter time."""
    speed = np.empty(time.size)
    for piece in pieces:
        path = abs(position[piece.stop - 1] - position[piece.start])
        speed[piece] = path / (time[piece.stop - 1] - time[piece.start])
    return speed


def _summary(told: list[LeftOut]) -> str:
    counts: dict[str, int] = {}
    for one in told:
        counts[one.kind] = counts.get(one.kind, 0) + max(one.samples, 1)
    return ", ".join(f"{count} × {kind}" for kind, count in counts.items()) or "one sample"
