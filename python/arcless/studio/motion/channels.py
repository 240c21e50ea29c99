"""Channels of a motion, and the frames that carry their values."""

import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

_HEAD = struct.Struct("<IId")
Singles = NDArray[np.float32]


@dataclass(frozen=True)
class Channel:
    """One channel.

    Attributes
    ----------
    name
        Such as ``wire.0.up``, ``droppers``, ``supports``, ``pantograph.0``.
    unit
        Unit of its values; empty where they have several.
    size
        Number of values of a frame at most.
    about
        What its values are.
    """

    name: str
    unit: str
    size: int
    about: dict[str, Any] = field(default_factory=dict)

    def announced(self, number: int) -> dict[str, Any]:
        """Return how a channel is announced under its number."""
        return {
            "number": number, "name": self.name, "unit": self.unit, "type": "f32",
            "shape": [self.size], "about": self.about,
        }  # fmt: skip


class Piece(NamedTuple):
    """Values of a channel at one time.

    Attributes
    ----------
    channel
        Its place among the channels of the motion, from 0.
    first
        Number of the first value: of a node in its wire, a dropper, a support.
    time_s
        Time in s.
    values
        The values, single precision.
    """

    channel: int
    first: int
    time_s: float
    values: Singles

    def frame(self, number: int) -> bytes:
        """Return the frame of the stream, under the number of its channel."""
        head = _HEAD.pack(number, self.first, self.time_s)
        return head + np.ascontiguousarray(self.values, "<f4").tobytes()


# Pieces of one time: they are sent together or not at all.
Moment = list[Piece]


class MotionSource(Protocol):
    """Motion that can be asked for, whole or still growing."""

    @property
    def channels(self) -> Sequence[Channel]:
        """The channels: wires first, pantographs last."""

    @property
    def start_s(self) -> float:
        """Time in s of the first row."""

    @property
    def end_s(self) -> float:
        """Time in s of the last row so far."""

    @property
    def estimated_end_s(self) -> float:
        """Time in s of the last row of all."""

    @property
    def final(self) -> bool:
        """True when no more rows will come."""

    @property
    def every_s(self) -> float:
        """Interval of the rows in s; 0 where it is not known."""

    @property
    def search(self) -> int | None:
        """Which attempt of a search for the static force it is, from 1; None of other motion."""

    @property
    def later(self) -> "MotionSource | None":
        """Motion that took the place of this one: of a run begun again, or one that has wires."""

    def moments(self, from_s: float, to_s: float, every_s: float) -> Iterator[Moment]:
        """Yield moments between two times in s, about so far apart; each row for 0."""


def moves_wires(source: MotionSource) -> bool:
    """Return whether wires move, and not the pantographs alone."""
    return any(channel.name.startswith("wire.") for channel in source.channels)


def pantograph_channel(number: int, name: str, masses: Sequence[str]) -> Channel:
    """Return the channel of a pantograph, counted from 0: its values have several units."""
    head = (("position", "m"), ("contact force", "N"), ("height of the wire", "m"),
            ("uplift of the wire", "m"))  # fmt: skip
    values = [{"name": word, "unit": unit} for word, unit in head]
    values += [{"name": mass, "unit": "m"} for mass in masses]
    return Channel(f"pantograph.{number}", "", len(values), {"name": name, "values": values})


def rows_between(
    times: Sequence[float] | NDArray[np.float64], from_s: float, to_s: float, every_s: float
) -> range:
    """Return the rows between two times, both included, about so far apart; each one for 0.

    With times that are equally far apart except for rounding.
    """
    first = int(np.searchsorted(times, from_s - ROUNDING_S))
    last = int(np.searchsorted(times, to_s + ROUNDING_S, side="right"))
    if last - first < 2:  # noqa: PLR2004 - no interval
        return range(first, last)
    interval = (float(times[last - 1]) - float(times[first])) / (last - 1 - first)
    stride = max(1, round(every_s / interval)) if interval > 0.0 else 1
    return range(first, last, stride)


# Rounding of times in s: far less than a step, far more than the last digit of an hour.
ROUNDING_S = 1e-7
