"""Motion of a stored run, read from its file in blocks of rows, never as a whole."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.motion_lanes import nodes_of_lane
from arcless.results import Result
from arcless.results import open as open_result
from arcless.studio.at_rest.of_run import geometry_of_run
from arcless.studio.motion.channels import (
    ROUNDING_S,
    Channel,
    Moment,
    MotionSource,
    Piece,
    rows_between,
)
from arcless.studio.motion.contact_rows import CACHE, ContactRows, Floats, texts
from arcless.studio.motion.layout import (
    LineMotion,
    RowLayout,
    WirePart,
    in_order,
    pantograph_channels,
)

# Rows that are read at once.
_BLOCK = 64
# Channels along the line of a run without motion of wires: name, variable, unit, meaning, and the
# dimension that counts them.
_ALONG = (
    ("droppers", "dropper_force", "N", "tension; 0: slack", "dropper"),
    ("supports", "support_uplift", "m", "uplift of the contact wire", "support"),
)


# Fields of a row, and the variables of a file that they are.
_FIELDS = {
    "first": "motion_first",
    "up": "motion_up",
    "across": "motion_across",
    "dropper_first": "motion_dropper_first",
    "droppers": "motion_dropper_force",
}


def recorded(file: Path) -> "Recorded":
    """Return the motion of a stored run: of its wires, if that was recorded.

    Parameters
    ----------
    file
        The result file, which is checked as `arcless.open` does.

    Raises
    ------
    ResultFormatError
        It is no result, or it is damaged.
    """
    import h5py

    result = open_result(file)
    data = h5py.File(file, "r", rdcc_nbytes=CACHE)
    return RecordedMotion(data, result) if "motion_up" in data else RecordedContacts(data)


class Recorded(ABC):
    """Rows in a file, at times that are equally far apart."""

    channels: list[Channel]
    final = True
    search: int | None = None

    def __init__(self, times: Floats) -> None:
        self.later: MotionSource | None = None
        self._times = times
        self.start_s, self.end_s = float(times[0]), float(times[-1])
        self.estimated_end_s = self.end_s
        rows = len(times) - 1
        self.every_s = (self.end_s - self.start_s) / rows if rows else 0.0

    def moments(self, from_s: float, to_s: float, every_s: float) -> Iterator[Moment]:
        """Yield moments between two times in s; see `MotionSource`."""
        rows = rows_between(self._times, from_s, to_s, every_s)
        for begin in range(0, len(rows), _BLOCK):
            yield from self._block(np.array(rows[begin : begin + _BLOCK]))

    @abstractmethod
    def _block(self, rows: NDArray[np.intp]) -> Iterator[Moment]: ...


class RecordedMotion(Recorded):
    """Motion of the wires near the pantographs, as `output.motion` records it."""

    def __init__(self, data: Mapping[str, Any], result: Result) -> None:
        super().__init__(np.asarray(data["motion_time"][:], dtype=float))
        self._data, self._contacts = data, ContactRows(data)
        self._layout = _layout(data, self._contacts)
        self._line = LineMotion(self._layout, geometry_of_run(result))
        self.channels = self._line.channels

    def _block(self, rows: NDArray[np.intp]) -> Iterator[Moment]:
        part, at = slice(int(rows[0]), int(rows[-1]) + 1), rows - rows[0]
        found = np.zeros(len(rows), self._layout.type)
        found["time"] = times = self._times[rows]
        for field, name in _FIELDS.items():
            if name in self._data:
                found[field] = np.asarray(self._data[name][part])[at]
        for number, values in enumerate(self._contacts.values(self._contacts.before(times))):
            found[f"pantograph {number}"] = values
        for row in found:
            yield self._line.pieces(row)


def _layout(data: Mapping[str, Any], contacts: ContactRows) -> RowLayout:
    names = texts(data["motion_wire"])
    has_droppers = "motion_dropper_force" in data
    return RowLayout(
        wires=tuple(
            WirePart(kind, _nodes(data, kind, int(number)), int(count))
            for (kind, number), count in zip(
                (name.split() for name in names), data["motion_count"][:], strict=True
            )
        ),
        dropper_order=np.asarray(data["motion_dropper_order"][:] if has_droppers else [], np.int64),
        dropper_count=data["motion_dropper_force"].shape[1] if has_droppers else 0,
        pantographs=contacts.pantographs,
        spatial="motion_across" in data,
    )


def _nodes(data: Mapping[str, Any], kind: str, number: int) -> tuple[range, ...]:
    """Return the numbers of the nodes in a lane of a kind, counted from 1."""
    nodes = nodes_of_lane(lambda name: data[name][:] if name in data else None, kind, number)
    cuts = [0, *np.flatnonzero(np.diff(nodes) > 1) + 1, len(nodes)]
    return tuple(range(nodes[a], nodes[b - 1] + 1) for a, b in pairwise(cuts))


class RecordedContacts(Recorded):
    """Pantographs of a run without motion of wires; with droppers and supports if recorded."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self._data, self._contacts = data, ContactRows(data)
        super().__init__(self._contacts.times)
        has_line = "line_time" in data
        self._line_times = np.asarray(data["line_time"][:] if has_line else [], dtype=float)
        # Variable, and where it is of what is near, first number of each row and order.
        self._stored: list[tuple[str, str, NDArray[np.intp] | None]] = []
        self.channels = [*self._of_line(), *pantograph_channels(self._contacts.pantographs)]

    def _of_line(self) -> Iterator[Channel]:
        for channel, name, unit, meaning, dimension in _ALONG:
            if name in self._data:
                self._stored.append((name, "", None))
            elif f"near_{name}" in self._data:
                order = np.asarray(self._data[f"{dimension}_order"][:], dtype=np.intp)
                self._stored.append((f"near_{name}", f"near_{dimension}_first", order))
            else:
                continue
            size = self._data[self._stored[-1][0]].shape[1]
            yield Channel(channel, unit, size, {"text": meaning})

    def _block(self, rows: NDArray[np.intp]) -> Iterator[Moment]:
        times = self._times[rows]
        pantographs = self._contacts.values(rows)
        lines = np.searchsorted(self._line_times, times + ROUNDING_S, side="right") - 1
        sent = -1
        for at, (time_s, line) in enumerate(zip(times.tolist(), lines.tolist(), strict=True)):
            moment: Moment = []
            if line > sent:
                sent = line
                moment += self._along(line)
            for place, values in enumerate(pantographs, start=len(self._stored)):
                moment.append(Piece(place, 0, time_s, values[at]))
            yield moment

    def _along(self, row: int) -> Iterator[Piece]:
        time_s = float(self._line_times[row])
        for place, (name, first_name, order) in enumerate(self._stored):
            values = np.asarray(self._data[name][row], dtype=np.float32)
            if order is None:
                yield Piece(place, 0, time_s, values)
                continue
            first = int(self._data[first_name][row])
            yield from in_order(place, time_s, order[first : first + len(values)], values)
