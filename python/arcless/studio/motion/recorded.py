"""Motion of a stored run, read from its file row by row, never as a whole.

A run has always the contact channels of its pantographs; droppers and supports, of all the line or
of those near the pantographs, where its scenario records them.
"""

from collections.abc import Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.results import open as open_result
from arcless.studio.motion.channels import (
    ROUNDING_S,
    Channel,
    Moment,
    Piece,
    pantograph_channel,
    rows_between,
)

# Bytes of chunks that HDF5 keeps unpacked of each variable: those of the rows that are played.
_CACHE = 16 << 20
# Rows of contact channels that are read at once.
_BLOCK = 64
# Channels along the line: name, variable of all, unit, meaning, and the dimension that counts them.
_ALONG = (
    ("droppers", "dropper_force", "N", "tension; 0: slack", "dropper"),
    ("supports", "support_uplift", "m", "uplift of the contact wire", "support"),
)
Floats = NDArray[np.float64]


class RecordedMotion:
    """Motion in the record of a run; see `MotionSource`.

    Parameters
    ----------
    file
        The result file; opening it checks it as `arcless.open` does.

    Raises
    ------
    ResultFormatError
        It is no result, or it is damaged.
    """

    final = True

    def __init__(self, file: Path) -> None:
        import h5py

        result = open_result(file)
        self._data: Mapping[str, Any] = h5py.File(file, "r", rdcc_nbytes=_CACHE)
        self._times: Floats = np.asarray(self._data["time"][:], dtype=float)
        self._masses = _masses(self._data)
        self.channels = [*self._of_line(), *self._of_pantographs(result.recorded)]
        self.start_s, self.end_s = float(self._times[0]), float(self._times[-1])
        self.estimated_end_s = self.end_s
        rows = len(self._times) - 1
        self.every_s = (self.end_s - self.start_s) / rows if rows else 0.0

    def moments(self, from_s: float, to_s: float, every_s: float) -> Iterator[Moment]:
        """Yield moments between two times in s; see `MotionSource`."""
        rows = rows_between(self._times, from_s, to_s, every_s)
        sent = -1
        for begin in range(0, len(rows), _BLOCK):
            block = rows[begin : begin + _BLOCK]
            contact = self._contact(slice(block.start, block.stop, block.step))
            for at, row in enumerate(block):
                time_s = float(self._times[row])
                moment: Moment = []
                number = self._line_row(time_s)
                if number not in (-1, sent):
                    sent = number
                    moment += self._along(number)
                first = len(self.channels) - len(contact)
                for place, values in enumerate(contact, start=first):
                    moment.append(Piece(place, 0, time_s, values[at]))
                yield moment

    def _of_line(self) -> list[Channel]:
        """Return the channels along the line that were recorded, and note how each is stored."""
        self._stored: list[tuple[str, str | None, NDArray[np.intp] | None]] = []
        found = []
        if "line_time" not in self._data:
            self._line_times = np.zeros(0)
            return []
        self._line_times = np.asarray(self._data["line_time"][:], dtype=float)
        for channel, name, unit, meaning, dimension in _ALONG:
            near = f"near_{name}"
            if name in self._data:
                self._stored.append((name, None, None))
                size = self._data[name].shape[1]
            elif near in self._data:
                order = np.asarray(self._data[f"{dimension}_order"][:], dtype=np.intp)
                self._stored.append((near, f"near_{dimension}_first", order))
                size = self._data[near].shape[1]
            else:
                continue
            found.append(Channel(channel, unit, size, {"text": meaning}))
        return found

    def _of_pantographs(self, recorded: Any) -> list[Channel]:
        names = [str(name) for name in recorded["pantograph"].values]
        return [
            pantograph_channel(number, name, [f"mass {mass + 1}" for mass in masses])
            for number, (name, masses) in enumerate(zip(names, self._masses, strict=True))
        ]

    def _line_row(self, time_s: float) -> int:
        """Return the last row of the line at or before a time; -1 before the first one."""
        found = np.searchsorted(self._line_times, time_s + ROUNDING_S, side="right")
        return int(found) - 1

    def _along(self, row: int) -> Iterator[Piece]:
        time_s = float(self._line_times[row])
        for place, (name, first_name, order) in enumerate(self._stored):
            values = np.asarray(self._data[name][row], dtype=np.float32)
            if first_name is None or order is None:
                yield Piece(place, 0, time_s, values)
                continue
            first = int(self._data[first_name][row])
            numbers = order[first : first + len(values)]
            # Neighbours along the track need not be neighbours in the result: overlaps.
            cuts = [0, *np.flatnonzero(np.diff(numbers) != 1) + 1, len(numbers)]
            for begin, end in pairwise(cuts):
                if end > begin:
                    yield Piece(place, int(numbers[begin]), time_s, values[begin:end])

    def _contact(self, rows: slice) -> list[NDArray[np.float32]]:
        """Return the values of each pantograph in some rows."""
        data = self._data
        head = [np.asarray(data[name][rows]) for name in
                ("position", "contact_force", "contact_height")]  # fmt: skip
        moved = np.asarray(data["mass_displacement"][rows]) if any(map(len, self._masses)) else None
        found = []
        for number, masses in enumerate(self._masses):
            columns = [values[:, number] for values in head]
            columns.append(np.full(len(columns[0]), np.nan))
            if moved is not None:
                columns += list(moved[:, number, masses].T)
            found.append(np.column_stack(columns).astype(np.float32))
        return found


def _masses(data: Mapping[str, Any]) -> list[list[int]]:
    """Return the masses of each pantograph: others have fewer than the dimension has numbers."""
    count = data["contact_force"].shape[1]
    if "mass_displacement" not in data:
        return [[] for _ in range(count)]
    first = np.asarray(data["mass_displacement"][0])
    return [np.flatnonzero(np.isfinite(first[number])).tolist() for number in range(count)]
