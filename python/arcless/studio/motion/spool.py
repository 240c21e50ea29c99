"""Spool: motion of a run that is being computed, in a temporary file without a name.

The worker process writes rows of one size, the server reads them by their number. Whatever is
watched, paused or skipped happens on the side of the reader: the run knows nothing of it.
"""

import os
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from arcless.studio.motion.channels import ROUNDING_S, Channel, Moment, Piece

# Bytes of one spool at most: a run of 50 km at default intervals has some hundred MB. With less a
# long run is not watched to its end; with more a forgotten one fills the disk.
LARGEST = 4 << 30
# Time in s between two words of where the spool ends.
_BETWEEN_S = 0.05
Grown = Callable[[int, float, bool], None]


def row_type(channels: Sequence[Channel]) -> np.dtype[np.void]:
    """Return the type of a row: time, then number of the first value, count and values of each."""
    fields: list[tuple[str, str] | tuple[str, str, tuple[int]]] = [("time", "<f8")]
    for channel in channels:
        fields += [(f"{channel.name} first", "<u4"), (f"{channel.name} count", "<u4"),
                   (channel.name, "<f4", (channel.size,))]  # fmt: skip
    return np.dtype(fields)


def new_file() -> BinaryIO:
    """Return a new file without a name, which is gone when nobody has it open any more."""
    return tempfile.TemporaryFile("w+b", buffering=0, prefix="arcless-studio-")


class SpoolWriter:
    """Takes rows on the side of the worker.

    A disk that is full ends the motion and not the run: `full` says so.

    Parameters
    ----------
    descriptor
        The file.
    channels
        The channels.
    grown
        Told now and then the number of rows, the time in s of the last one, and whether more come.
    """

    def __init__(self, descriptor: int, channels: Sequence[Channel], grown: Grown) -> None:
        self.type = row_type(channels)
        self.full = False
        self._descriptor, self._grown = descriptor, grown
        self._rows, self._end_s, self._next = 0, 0.0, 0.0

    def rows(self, count: int) -> NDArray[np.void]:
        """Return so many empty rows to fill: all values are 0."""
        return np.zeros(count, self.type)

    def append(self, rows: NDArray[np.void]) -> None:
        """Put rows behind those that are there."""
        if self.full or not len(rows):
            return
        if (self._rows + len(rows)) * self.type.itemsize > LARGEST:
            self.full = True
            return
        try:
            self._write(rows.tobytes())
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

    def _write(self, content: bytes) -> None:
        view, place = memoryview(content), self._rows * self.type.itemsize
        while view:
            done = os.pwrite(self._descriptor, view, place)
            view, place = view[done:], place + done


class SpooledMotion:
    """Motion in a spool, on the side of the server; see `MotionSource`.

    Parameters
    ----------
    file
        The file, which the worker fills.
    channels
        The channels.
    every_s
        Interval of the rows in s.
    estimated_end_s
        Time in s of the last row of all.
    """

    def __init__(
        self, file: BinaryIO, channels: Sequence[Channel], every_s: float, estimated_end_s: float
    ) -> None:
        self.channels, self.every_s, self.estimated_end_s = channels, every_s, estimated_end_s
        self.end_s, self.final = 0.0, False
        self._file, self._type, self._rows = file, row_type(channels), 0

    @property
    def start_s(self) -> float:
        """Time in s of the first row."""
        return self._time(0) if self._rows else 0.0

    @property
    def size(self) -> int:
        """Bytes on the disk."""
        return self._rows * self._type.itemsize

    def grow(self, rows: int, end_s: float, *, final: bool) -> None:
        """Take over how far the worker is."""
        self.end_s, self._rows, self.final = end_s, rows, final

    def close(self) -> None:
        """Give the file back to the disk; what was still asked for ends."""
        self._rows, self.final = 0, True
        self._file.close()

    def moments(self, from_s: float, to_s: float, every_s: float) -> Iterator[Moment]:
        """Yield moments between two times in s; see `MotionSource`."""
        first = self._row_at(from_s - ROUNDING_S)
        last = self._row_at(to_s + ROUNDING_S)
        stride = max(1, round(every_s / self.every_s)) if self.every_s > 0.0 else 1
        for number in range(first, last, stride):
            if number >= self._rows:
                return
            yield self._moment(number)

    def _moment(self, number: int) -> Moment:
        row = np.frombuffer(self._read(number, self._type.itemsize), self._type)[0]
        moment: Moment = []
        for place, channel in enumerate(self.channels):
            count = int(row[f"{channel.name} count"])
            if count:
                values = row[channel.name][:count]
                moment.append(Piece(place, int(row[f"{channel.name} first"]), row["time"], values))
        return moment

    def _row_at(self, time_s: float) -> int:
        """Return the first row that is not before a time, guessed from the interval."""
        low, high = 0, self._rows
        if self.every_s > 0.0 and high:
            guess = min(max(int((time_s - self.start_s) / self.every_s), 0), high)
            low = guess - 1 if guess and self._time(guess - 1) < time_s else 0
            high = guess + 2 if guess + 2 <= high and self._time(guess + 1) >= time_s else high
        while low < high:
            middle = (low + high) // 2
            if self._time(middle) < time_s:
                low = middle + 1
            else:
                high = middle
        return low

    def _time(self, number: int) -> float:
        return float(np.frombuffer(self._read(number, 8), "<f8")[0])

    def _read(self, number: int, size: int) -> bytes:
        return os.pread(self._file.fileno(), size, number * self._type.itemsize)
