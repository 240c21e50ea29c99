"""Columns of one pantograph as they were read, and what is told of them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError
from arcless.measurements.samples import left_out as kinds
from arcless.measurements.samples.clock import Clock
from arcless.measurements.samples.left_out import LeftOut

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

CLOCKS = ("time", "position", "speed")


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


def with_clock(raw: Raw, told: list[LeftOut]) -> Raw:
    """Leave out samples of which time, position or speed is missing."""
    present = [raw.channels[key] for key in CLOCKS if key in raw.channels]
    if not present:
        return raw  # `clock` says what is missing
    known = np.all(np.isfinite(present), axis=0)
    if known.all():
        return raw
    told += stretches_of(~known, kinds.EMPTY, raw, None, "clock")
    if np.count_nonzero(known) < 2:  # noqa: PLR2004 - two samples have a distance
        raise nothing_left(raw, "time, position or speed is missing in every row")
    return raw.rows(np.flatnonzero(known))


def without_duplicates(raw: Raw, told: list[LeftOut]) -> Raw:
    """Leave out samples that repeat the one before in every column, its time or place included."""
    columns = [*raw.channels.values(), *raw.sensors.values(), *raw.accelerations.values()]
    same = np.ones(raw.lines.size - 1, bool)
    for values in columns:
        before, here = values[:-1], values[1:]
        same &= (before == here) | (np.isnan(before) & np.isnan(here))
    if "time" not in raw.channels and "position" not in raw.channels:
        return raw
    again = np.concatenate([[False], same])
    told += stretches_of(again, kinds.DUPLICATE, raw, None)
    return raw.rows(np.flatnonzero(~again))


def stretches_of(
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


def place_between(kind: str, raw: Raw, when: Clock, place: int, samples: int) -> LeftOut:
    """Return the entry of a place between two samples."""
    lines = int(raw.lines[place]), int(raw.lines[place + 1])
    return LeftOut(kind, *lines, samples, *_when(when, place, place + 1))


def _when(when: Clock | None, begin: int, end: int) -> tuple[float, float, float, float]:
    if when is None:
        return (np.nan,) * 4
    time, position = when.time, when.position
    return float(time[begin]), float(time[end]), float(position[begin]), float(position[end])


def nothing_left(raw: Raw, got: str) -> MeasurementError:
    """Return the error of a record that no sample is left of."""
    return MeasurementError(
        "no samples are left", where=f"{raw.label}: pantograph {raw.name}", got=got,
        expected="a stretch without gaps",
    )  # fmt: skip
