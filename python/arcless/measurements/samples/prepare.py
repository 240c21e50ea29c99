"""Columns of one pantograph → its good samples, in pieces at equal time steps."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError
from arcless.measurements.samples import inertia
from arcless.measurements.samples import left_out as kinds
from arcless.measurements.samples.clock import Clock, clock
from arcless.measurements.samples.faults import CLIPPED_SAMPLES, clipped, frozen, held
from arcless.measurements.samples.inertia import Head
from arcless.measurements.samples.left_out import LeftOut
from arcless.measurements.samples.pantograph import MeasuredPantograph
from arcless.measurements.samples.pieces import (
    breaks,
    common_step,
    is_uniform,
    pieces_of,
    resampled,
    usual_step,
)

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

CLOCKS = ("time", "position", "speed")
# Kept with the force, where the file has them; a missing value of theirs takes no sample away.
OPTIONAL = ("contact_height", "uplift")


@dataclass(frozen=True)
class Raw:
    """Columns of one pantograph, in SI; an empty cell is NaN.

    Attributes
    ----------
    name
        Its name.
    channels
        Time, position, speed, contact_force, contact_height, uplift: those that the file has.
    sensors, accelerations
        By the titles of their columns.
    lines, order
        Line of the file of each sample, and its number among all samples, from 0.
    label
        The file, for messages.
    """

    name: str
    channels: Mapping[str, Floats]
    sensors: Mapping[str, Floats]
    accelerations: Mapping[str, Floats]
    lines: NDArray[np.int64]
    order: NDArray[np.int64]
    label: str

    def rows(self, chosen: NDArray[np.intp]) -> "Raw":
        """Return some of the samples."""
        parts = (self.channels, self.sensors, self.accelerations)
        channels, sensors, accelerations = (
            {key: values[chosen] for key, values in part.items()} for part in parts
        )
        kept = self.lines[chosen], self.order[chosen]
        return Raw(self.name, channels, sensors, accelerations, *kept, self.label)

    @property
    def measured(self) -> dict[str, Floats]:
        """Columns that the force is made of, by their titles."""
        if "contact_force" in self.channels:
            return {"contact_force": self.channels["contact_force"]}
        return {**self.sensors, **self.accelerations}


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
    raw = _with_clock(raw, told)
    raw = _without_duplicates(raw, told)
    known = {key: raw.channels[key] for key in CLOCKS if key in raw.channels}
    when = clock(known, speed, raw.lines, raw.label)
    force = _force(raw, when, speed, head)
    hold = max(map(held, raw.measured.values()))
    good = _good(raw, when, force, hold, told)
    pieces = _pieces(raw, when, good, told)
    step = common_step(when.time, pieces)
    columns = {"position": when.position, "force": force}
    columns |= {} if when.speed is None else {"speed": when.speed}
    columns |= {key: raw.channels[key] for key in OPTIONAL if key in raw.channels}
    kept, places, interpolated = _joined(when, columns, pieces, step)
    if when.speed is None:
        kept["speed"] = _own_speed(kept["time"], kept["position"], places)
    return MeasuredPantograph(
        name=raw.name,
        **{key: kept[key] for key in ("time", "position", "speed", "force")},
        height=kept.get("contact_height"),
        uplift=kept.get("uplift"),
        pieces=places,
        rate_Hz=1.0 / step,
        held=hold,
        interpolated=interpolated,
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
    told += _stretches(~good, kinds.EMPTY, raw, when, "force")
    step = usual_step(when.time)
    for title, values in raw.measured.items():
        ends = clipped(values, CLIPPED_SAMPLES * hold)
        dead = frozen(values, step * hold) & ~ends
        told += _stretches(ends, kinds.CLIPPED, raw, when, title)
        told += _stretches(dead, kinds.FROZEN, raw, when, title)
        good &= ~(ends | dead)
    return good


def _with_clock(raw: Raw, told: list[LeftOut]) -> Raw:
    """Leave out samples of which time, position or speed is missing."""
    present = [raw.channels[key] for key in CLOCKS if key in raw.channels]
    if not present:
        return raw  # `clock` says what is missing
    known = np.all(np.isfinite(present), axis=0)
    if known.all():
        return raw
    told += _stretches(~known, kinds.EMPTY, raw, None, "clock")
    if np.count_nonzero(known) < 2:  # noqa: PLR2004 - two samples have a distance
        raise _nothing_left(raw, "time, position or speed is missing in every row")
    return raw.rows(np.flatnonzero(known))


def _without_duplicates(raw: Raw, told: list[LeftOut]) -> Raw:
    """Leave out samples that repeat the one before in every column, its time or place included."""
    columns = [*raw.channels.values(), *raw.sensors.values(), *raw.accelerations.values()]
    same = np.ones(raw.lines.size - 1, bool)
    for values in columns:
        before, here = values[:-1], values[1:]
        same &= (before == here) | (np.isnan(before) & np.isnan(here))
    if "time" not in raw.channels and "position" not in raw.channels:
        return raw
    again = np.concatenate([[False], same])
    told += _stretches(again, kinds.DUPLICATE, raw, None)
    return raw.rows(np.flatnonzero(~again))


def _force(raw: Raw, when: Clock, speed: float | None, head: Head | None) -> Floats:
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
    speeds = _speeds(when, speed)
    return inertia.contact_force(list(raw.sensors.values()), mean, speeds, head)


def _speeds(when: Clock, speed: float | None) -> Floats:
    """Return speeds in m/s; the median of the record where the file has none."""
    if when.speed is not None:
        return when.speed
    usual = float(np.median(np.abs(np.diff(when.position)) / np.diff(when.time)))
    return np.full(when.time.size, usual if speed is None else speed)


def _pieces(raw: Raw, when: Clock, good: Mask, told: list[LeftOut]) -> list[slice]:
    """Cut the record at gaps and jumps, and tell of them."""
    cut = breaks(when.reading, good, when.time, when.position, _speeds(when, None))
    usual = usual_step(when.reading)
    for place in cut.gaps:
        missing = round((when.reading[place + 1] - when.reading[place]) / usual) - 1
        missing -= int(raw.order[place + 1] - raw.order[place]) - 1  # told as empty cells
        if missing > 0:
            told.append(_between(kinds.GAP, raw, when, int(place), missing))
    told += [_between(kinds.JUMP, raw, when, int(place), 0) for place in cut.jumps]
    found = pieces_of(good, np.concatenate([cut.gaps, cut.jumps]))
    single = np.zeros(good.size, bool)
    for piece in found:
        single[piece] = piece.stop - piece.start == 1
    told += _stretches(single, kinds.SHORT, raw, when)
    kept = [piece for piece in found if piece.stop - piece.start > 1]
    if not kept:
        raise _nothing_left(raw, _summary(told))
    return kept


def _joined(
    when: Clock, columns: Mapping[str, Floats], pieces: list[slice], step_s: float
) -> tuple[dict[str, Floats], tuple[slice, ...], bool]:
    """Put the pieces one behind the other, at one time step.

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
    stops, interpolated = [0], False
    for piece in pieces:
        time, values = when.time[piece], [column[piece] for column in columns.values()]
        if not is_uniform(time, step_s):
            time, values = resampled(time, step_s, values)
            interpolated = True
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


def _stretches(
    wrong: Mask, kind: str, raw: Raw, when: Clock | None, channel: str = ""
) -> Iterator[LeftOut]:
    """Yield one entry for each stretch of wrong samples."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], wrong, [False]]).astype(np.int8)))
    for begin, end in zip(edges[::2], edges[1::2] - 1, strict=True):
        yield LeftOut(
            kind,
            int(raw.lines[begin]),
            int(raw.lines[end]),
            int(end - begin + 1),
            *_when(when, int(begin), int(end)),
            channel,
        )


def _between(kind: str, raw: Raw, when: Clock, place: int, samples: int) -> LeftOut:
    """Return the entry of a place between two samples."""
    lines = int(raw.lines[place]), int(raw.lines[place + 1])
    return LeftOut(kind, *lines, samples, *_when(when, place, place + 1))


def _when(when: Clock | None, begin: int, end: int) -> tuple[float, float, float, float]:
    if when is None:
        return (np.nan,) * 4
    time, position = when.time, when.position
    return float(time[begin]), float(time[end]), float(position[begin]), float(position[end])


def _nothing_left(raw: Raw, got: str) -> MeasurementError:
    return MeasurementError(
        "no samples are left", where=f"{raw.label}: pantograph {raw.name}", got=got,
        expected="a stretch without gaps",
    )  # fmt: skip


def _summary(told: list[LeftOut]) -> str:
    counts: dict[str, int] = {}
    for one in told:
        counts[one.kind] = counts.get(one.kind, 0) + max(one.samples, 1)
    return ", ".join(f"{count} × {kind}" for kind, count in counts.items()) or "one sample"
