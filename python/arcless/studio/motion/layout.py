"""Layout of the rows of a motion, and what of a line each number in them moves.

A row holds of each wire as many nodes as are near the pantographs, and the number of the first one.
Stitch wires and bridles are rows of a tension length there, and a wire for each support in the
geometry that a page draws: a row becomes pieces of these.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.studio.at_rest.plain_geometry import KINDS, Geometry, WireData
from arcless.studio.motion.channels import Channel, Moment, Piece, Singles, pantograph_channel

Numbers = NDArray[np.int64]
_KIND_OF = {name: kind for kind, (name, _) in KINDS.items()}


@dataclass(frozen=True)
class WirePart:
    """A wire in the rows, or several that lie one behind the other.

    Attributes
    ----------
    kind
        Kind as in a result, such as ``contact_wire``.
    nodes
        Numbers of its nodes among all of the kind, as ranges in their order.
    count
        Number of nodes in a row.
    """

    kind: str
    nodes: tuple[range, ...]
    count: int


@dataclass(frozen=True)
class RowLayout:
    """Layout of a row.

    Attributes
    ----------
    wires
        Wires, whose columns stand one behind the other.
    dropper_order
        Number of each dropper in the result, in the order along the track.
    dropper_count
        Number of droppers in a row.
    pantographs
        Name and number of masses of each pantograph.
    spatial
        Whether there is motion across the track.
    """

    wires: tuple[WirePart, ...]
    dropper_order: Numbers
    dropper_count: int
    pantographs: tuple[tuple[str, int], ...]
    spatial: bool

    @property
    def columns(self) -> int:
        """Number of nodes in a row."""
        return sum(wire.count for wire in self.wires)

    @property
    def type(self) -> np.dtype[np.void]:
        """Type of a row as it is stored in a file."""
        fields: list[Any] = [
            ("time", "<f8"), ("first", "<u4", (len(self.wires),)), ("dropper_first", "<u4"),
            ("up", "<f4", (self.columns,)), ("droppers", "<f4", (self.dropper_count,)),
        ]  # fmt: skip
        if self.spatial:
            fields.append(("across", "<f4", (self.columns,)))
        fields += [
            (f"pantograph {number}", "<f4", (HEAD + masses,))
            for number, (_, masses) in enumerate(self.pantographs)
        ]
        return np.dtype(fields)


# Position, force, height and uplift of a pantograph come before its masses.
HEAD = 4


_WAYS = (("up", "displacement upwards"), ("across", "displacement to the left"))


class LineMotion:
    """Channels of a line that moves, and the pieces of a row.

    Parameters
    ----------
    layout
        Layout of the rows.
    geometry
        The line whose nodes they move.
    """

    def __init__(self, layout: RowLayout, geometry: Geometry) -> None:
        self._layout = layout
        wires = geometry["wires"]
        self._columns = np.cumsum([0, *(part.count for part in layout.wires)])
        self._targets = list(_targets(layout.wires, geometry))
        sizes = [len(wire["x"]) for wire in wires]
        self.channels = [
            Channel(f"wire.{number}.{word}", "m", size, {"text": text})
            for word, text in _WAYS
            for number, size in enumerate(sizes)
            if word == "up" or layout.spatial
        ]  # fmt: skip
        self._across = len(wires)
        self._droppers = len(self.channels)
        self.channels.append(Channel("droppers", "N", layout.dropper_count, {"text": "tension"}))
        about = {"text": "uplift of the contact wire"}
        self.channels.append(Channel("supports", "m", len(geometry["supports"]), about))
        self.first_pantograph = len(self.channels)
        self.channels += pantograph_channels(layout.pantographs)
        self._supports = _support_nodes(geometry, self._targets)

    def pieces(self, row: Any) -> Moment:
        """Return the pieces of a row, wires first; `row` has the fields of `RowLayout.type`."""
        time_s = float(row["time"])
        moment = list(self._wire_pieces(time_s, row["first"], row["up"], 0))
        if self._layout.spatial:
            moment += self._wire_pieces(time_s, row["first"], row["across"], self._across)
        if self._layout.dropper_count:
            first = int(row["dropper_first"])
            numbers = self._layout.dropper_order[first : first + self._layout.dropper_count]
            moment += in_order(self._droppers, time_s, numbers, row["droppers"])
        moment += self._uplifts(time_s, row["first"], row["up"])
        for number in range(len(self._layout.pantographs)):
            place = self.first_pantograph + number
            moment.append(Piece(place, 0, time_s, row[f"pantograph {number}"]))
        return moment

    def _wire_pieces(
        self, time_s: float, first: Any, values: Singles, channel: int
    ) -> Iterator[Piece]:
        for part, targets in enumerate(self._targets):
            begin, column = int(first[part]), int(self._columns[part])
            end = begin + self._layout.wires[part].count
            low = int(np.searchsorted(targets.ends, begin, side="right"))
            high = int(np.searchsorted(targets.begins, end))
            for at in range(low, high):
                own = int(targets.begins[at])
                a, b = max(begin, own), min(end, int(targets.ends[at]))
                moved = values[column + a - begin : column + b - begin]
                yield Piece(channel + targets.wires[at], a - own, time_s, moved)

    def _uplifts(self, time_s: float, first: Any, up: Singles) -> Iterator[Piece]:
        """Yield the uplift at the supports whose node is in the row."""
        parts, nodes = self._supports
        counts = np.array([part.count for part in self._layout.wires])
        place = nodes - np.asarray(first, np.int64)[parts]
        numbers = np.flatnonzero((place >= 0) & (place < counts[parts]))
        values = up[self._columns[parts[numbers]] + place[numbers]]
        yield from in_order(self._droppers + 1, time_s, numbers, values)


@dataclass(frozen=True)
class _Targets:
    """Wires of the geometry that a part of the rows moves.

    Attributes
    ----------
    wires
        Their numbers.
    begins, ends
        Nodes of the part at which each begins and ends.
    """

    wires: tuple[int, ...]
    begins: Numbers
    ends: Numbers


def _targets(parts: Sequence[WirePart], geometry: Geometry) -> Iterator[_Targets]:
    by_kind: dict[str, list[tuple[int, WireData]]] = {}
    for number, wire in enumerate(geometry["wires"]):
        by_kind.setdefault(wire["kind"], []).append((number, wire))
    for part in parts:
        nodes = np.concatenate([np.arange(each.start, each.stop) for each in part.nodes])
        of_kind = by_kind.get(_KIND_OF[part.kind], [])
        begins = np.searchsorted(nodes, [wire["first"] for _, wire in of_kind])
        own = [
            (number, int(begin), len(wire["x"]))
            for (number, wire), begin in zip(of_kind, begins, strict=True)
            if begin < len(nodes) and nodes[begin] == wire["first"]
        ]
        starts = np.array([begin for _, begin, _ in own], np.int64)
        sizes = np.array([size for _, _, size in own], np.int64)
        yield _Targets(tuple(number for number, _, _ in own), starts, starts + sizes)


def _support_nodes(geometry: Geometry, targets: Sequence[_Targets]) -> tuple[Numbers, Numbers]:
    """Return the part of the rows and the node in it of the contact wire at each support."""
    place = {
        wire: (part, int(begin))
        for part, target in enumerate(targets)
        for wire, begin in zip(target.wires, target.begins, strict=True)
    }
    found = [place[support["wire"]] for support in geometry["supports"]]
    nodes = [support["node"] for support in geometry["supports"]]
    parts = np.array([part for part, _ in found], np.int64)
    begins = np.array([begin for _, begin in found], np.int64)
    return parts, begins + np.array(nodes, np.int64)


def pantograph_channels(pantographs: Sequence[tuple[str, int]]) -> list[Channel]:
    """Return the channels of pantographs, given the name and the number of masses of each."""
    return [
        pantograph_channel(number, name, [f"mass {mass + 1}" for mass in range(masses)])
        for number, (name, masses) in enumerate(pantographs)
    ]


def in_order(channel: int, time_s: float, numbers: Any, values: Any) -> Iterator[Piece]:
    """Yield pieces of values whose numbers are neighbours, which those along the track need not be.

    Where tension lengths overlap, droppers of both alternate: cut where they stand, each would be a
    message of its own.
    """
    order = np.argsort(numbers)
    numbers, values = np.asarray(numbers)[order], np.asarray(values)[order]
    cuts = [0, *np.flatnonzero(np.diff(numbers) != 1) + 1, len(numbers)]
    for begin, end in pairwise(cuts):
        if end > begin:
            yield Piece(channel, int(numbers[begin]), time_s, values[begin:end])
