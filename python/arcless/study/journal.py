"""The journal of a study: one line of JSON a row, appended as variants end; the truth of the table.

A line that a kill or a full disk cut short is no line: whatever cannot be read is left out, and its
variant is computed again.
"""

import fcntl
import json
import os
import time
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import Self

from arcless.errors import OutputError, StudyError
from arcless.study.rows import Row

# A power cut loses at most the rows of this time; a killed process loses none that were written.
_SYNC_EVERY_S = 1.0
# A row is a line of some hundred bytes; errors of very large groups of values may be longer.
_LONGEST_LINE = 1 << 22
# Whoever only looks whether a study is going on holds its journal for a moment.
_LOOKS, _BETWEEN_LOOKS_S = 10, 0.05


class Journal:
    """A journal that is open for appending, by one process at a time.

    Raises
    ------
    StudyError
        Another process is writing it.
    OutputError
        It cannot be written.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._synced = time.monotonic()

    def __enter__(self) -> Self:
        """Open it, and take it for this process."""
        try:
            self._file = os.open(self.path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
        except OSError as error:
            raise self._not_written(error) from error
        for _ in range(_LOOKS):
            try:
                fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                time.sleep(_BETWEEN_LOOKS_S)
            else:
                return self
        os.close(self._file)
        raise StudyError(
            "the study is being computed already",
            where=str(self.path.parent),
            expected="one process at a time",
            hint="wait for it, or stop it; `arcless study status` says how far it is",
        )

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Put all on the disk and let others have it."""
        try:
            os.fsync(self._file)
        except OSError as failed:
            if error is None:
                raise self._not_written(failed) from failed
        finally:
            os.close(self._file)

    def mend(self) -> None:
        """Drop what stands behind the last whole line: a row that was cut short."""
        size = os.lseek(self._file, 0, os.SEEK_END)
        start = max(0, size - _LONGEST_LINE)
        end = os.pread(self._file, _LONGEST_LINE, start)
        whole = start + end.rfind(b"\n") + 1
        if whole != size:
            os.ftruncate(self._file, whole)

    def append(self, row: Row) -> None:
        """Write a row; after an error the journal is as it was before."""
        line = json.dumps(row.to_dict(), ensure_ascii=False, allow_nan=False) + "\n"
        end = os.lseek(self._file, 0, os.SEEK_END)
        try:
            left = line.encode()
            while left:
                left = left[os.write(self._file, left) :]
            if time.monotonic() - self._synced > _SYNC_EVERY_S:
                os.fsync(self._file)
                self._synced = time.monotonic()
        except OSError as error:
            os.ftruncate(self._file, end)
            raise self._not_written(error) from error

    def _not_written(self, error: OSError) -> OutputError:
        hint = "make room, then `arcless study resume`: nothing that was computed is lost"
        what = "the journal of the study cannot be written"
        return OutputError.of(error, what, self.path, hint)


def rows(path: Path) -> Iterator[Row]:
    """Yield the rows of a journal in the order of the variants, of several the last one.

    One row at a time is in memory. None without a file.
    """
    if not path.exists():
        return
    places = {row.variant: place for place, row in _readable(path)}
    with path.open("rb") as file:
        for number in sorted(places):
            file.seek(places[number])
            row = _row(file.readline())
            assert row is not None  # lines that were whole stay
            yield row


def is_locked(path: Path) -> bool:
    """Return whether a process is writing a journal just now."""
    if not path.exists():
        return False
    with path.open("rb") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except OSError:
            return True
    return False


def _readable(path: Path) -> Iterator[tuple[int, Row]]:
    """Yield the place and the row of each line that can be read."""
    place = 0
    with path.open("rb") as file:
        for line in file:
            row = _row(line)
            if row is not None:
                yield place, row
            place += len(line)


def _row(line: bytes) -> Row | None:
    try:
        return Row(**json.loads(line)) if line.endswith(b"\n") else None
    except (ValueError, TypeError):
        return None
