"""Spool: motion of a run that is being computed, in a temporary file of two processes.

The worker process writes rows of one size, the server reads them by their number. Whatever is
watched, paused or skipped happens on the side of the reader: the run knows nothing of it.
"""

import time
from collections.abc import Callable, Iterator
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from arcless.platforms.positioned import read_at, write_at
from arcless.studio.at_rest.plain_geometry import Geometry
from arcless.studio.motion.channels import ROUNDING_S, Channel, Moment
from arcless.studio.motion.layout import LineMotion, RowLayout

# Bytes of one spool at most: a run of 50 km at default intervals has some hundred MB. With less a
# long run is not watched to its end; with more a forgotten one fills the disk.
LARGEST = 4 << 30
# Time in s between two words of where the spool ends.
_BETWEEN_S = 0.05
Grown = Callable[[int, float, bool], None]


class SpoolWriter:
    """Takes rows on the side of the worker.

    A disk that is full ends the motion and not the run: `full` says so.

    Parameters
    ----------
    descriptor
        The file.
    row_type
        Type of a row, which has a field ``time`` in s first.
    grown
        Told now and then the number of rows, the time in s of the last one, and whether no more
        come.
    """

    def __init__(self, descriptor: int, row_type: np.dtype[np.void], grown: Grown) -> None:
        self.full = False
        self._descriptor, self._type, self._grown = descriptor, row_type, grown
        self._rows, self._end_s, self._next = 0, 0.0, 0.0

    def append(self, rows: NDArray[np.void]) -> None:
        """Put rows behind those that are there."""
        if self.full or not len(rows):
            return
        if (self._rows + len(rows)) * self._type.itemsize > LARGEST:
            self.full = True
            return
        try:
            self._write(memoryview(rows.view(np.uint8)))  # type: ignore[arg-type]
        except OSError:
            self.full = True
            return
        self._rows += len(rows)
        self._end_s = float(rows["time"][-1])
        now = time.monotonic()
        if now >= self._next:
            self._next = now + _BETWEEN_S
            self._grown(self._rows, self._end_s, False)

    def finish(self) -> None:
        """Say that no more rows come."""
        self._grown(self._rows, self._end_s, True)

    def _write(self, view: memoryview) -> None:
        place = self._rows * self._type.itemsize
        while view:
            done = write_at(self._descriptor, view, place)
            view, place = view[done:], place + done


class SpooledMotion:
    """Motion in a spool, on the side of the server; see `MotionSource`.

    Parameters
    ----------
    file
        The file, which the worker fills.
    layout, geometry
        Layout of its rows, and the line whose nodes they move.
    every_s
        Interval of the rows in s.
    estimated_end_s
        Time in s of the last row of all.
    search
        Which attempt of a search for the static force it is, from 1; None: it is the run.
    """

    def __init__(
        self,
        file: BinaryIO,
        layout: RowLayout,
        geometry: Geometry,
        *,
        every_s: float,
        estimated_end_s: float,
        search: int | None = None,
    ) -> None:
        self.search = search
        self.geometry, self.every_s, self.estimated_end_s = geometry, every_s, estimated_end_s
        self.end_s, self.final = 0.0, False
        self.later: SpooledMotion | None = None
        self._line, self._type = LineMotion(layout, geometry), layout.type
        self._file, self._rows = file, 0

    @property
    def channels(self) -> list[Channel]:
        """Channels: wires first, pantographs last."""
        return self._line.channels

    @property
    def start_s(self) -> float:
        """Time in s of the first row; 0 before it is there."""
        return self._time(0) if self._rows else 0.0

    @property
    def size(self) -> int:
        """Bytes on the disk."""
        return self._rows * self._type.itemsize

    def grow(self, rows: int, end_s: float, *, final: bool) -> None:
        """Take over how far the worker is."""
        self.end_s, self._rows, self.final = end_s, rows, final

    def replace(self, later: "SpooledMotion") -> None:
        """Make room for another motion in the same file."""
        self._rows, self.final, self.later = 0, True, later

    def close(self) -> None:
        """Give the file back to the disk; what is still asked for finds nothing."""
        self._rows, self.final = 0, True
        self._file.close()

    def moments(self, from_s: float, to_s: float, every_s: float) -> Iterator[Moment]:
        """Yield moments between two times in s; see `MotionSource`."""
        first = self._row_at(from_s - ROUNDING_S)
        last = self._row_at(to_s + ROUNDING_S)
        stride = max(1, round(every_s / self.every_s))
        for number in range(first, last, stride):
            if number >= self._rows:
                return
            yield self._line.pieces(self._read(number)[0])

    def _row_at(self, time_s: float) -> int:
        """Return the first row that is not before a time; rows are equally far apart."""
        low, high = 0, self._rows
        guess = int((time_s - self.start_s) / self.every_s)
        for near in (guess, guess + 1, guess + 2):
            if 0 < near < high and self._time(near - 1) < time_s <= self._time(near):
                return near
        while low < high:  # before the first row, behind the last one
            middle = (low + high) // 2
            low, high = (middle + 1, high) if self._time(middle) < time_s else (low, middle)
        return low

    def _time(self, number: int) -> float:
        return float(np.frombuffer(self._pread(8, number), "<f8")[0])

    def _read(self, number: int) -> NDArray[np.void]:
        return np.frombuffer(self._pread(self._type.itemsize, number), self._type)

    def _pread(self, size: int, number: int) -> bytes:
        return read_at(self._file.fileno(), size, number * self._type.itemsize)
