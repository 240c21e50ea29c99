"""The journal of a study: an SQLite database with a row for each variant; the truth of the table.

Each row is one transaction and has a seal: what a kill cut short is not there, what was damaged is
left out, and its variant is computed again. While a study is computed the database has a
write-ahead log, where its folder carries one, so that nobody who reads holds up who writes. At rest
it is a single file that can be read from any folder.
"""

import sqlite3
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing, suppress
from pathlib import Path
from types import TracebackType
from typing import Literal, Self

from arcless.errors import OutputError, StudyError
from arcless.storage.lock import Lock, is_held
from arcless.study.journal.database import ERRORS, connect, is_damage, reading, tables, words
from arcless.study.journal.filesystem import carries_wal
from arcless.study.journal.row import Row
from arcless.study.journal.salvage import PUT, Damage, make, repair, salvaged
from arcless.study.journal.sealed_rows import opened, written

# A power cut loses at most the rows of this time; a killed process loses none that were written.
_SYNC_EVERY_S = 1.0
# A process that only looks whether a study is running holds its lock for a moment.
_WAITS_S = 0.5
# Rows that are read at once: between two parts a writer without a write-ahead log may write.
_PART = 500
_LAST = (1 << 63) - 1
_SOME = "SELECT variant, row, seal FROM rows WHERE variant BETWEEN ? AND ? ORDER BY variant LIMIT ?"
Mode = Literal["write-ahead log", "rollback journal"]


class Journal:
    """A journal that is open for writing, by one process at a time.

    Parameters
    ----------
    path
        The file.
    study
        Hash of what the study asks.

    Attributes
    ----------
    damage
        What was found damaged and mended, in a sentence; None where nothing was.
    mode
        How SQLite keeps a transaction whole.

    Raises
    ------
    StudyError
        Another process is writing it, or it belongs to another study.
    OutputError
        It cannot be written.
    """

    def __init__(self, path: Path, study: str) -> None:
        self.path, self._study = path, study
        self.damage: str | None = None
        self.mode: Mode = "rollback journal"
        self._synced = time.monotonic()

    def __enter__(self) -> Self:
        """Lock the journal for this process, put it in order, and open it."""
        with ExitStack() as held:
            self._take(held)
            try:
                if self.path.exists() and self.path.stat().st_size:
                    self.damage = repair(self.path, self._study)
                make(self.path, self._study)
                self._base = held.enter_context(closing(connect(self.path, "rw")))
                self._choose_mode()
            except (OSError, *ERRORS) as error:
                raise self._not_written(error) from error
            self._held = held.pop_all()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Write all to the disk, in one file if nobody is reading, and release the lock."""
        try:
            self._base.execute("PRAGMA synchronous = FULL")
            self._base.execute("PRAGMA wal_checkpoint(PASSIVE)")
            with suppress(sqlite3.OperationalError):  # a reader: it can be read as it is, too
                self._base.execute("PRAGMA busy_timeout = 100")
                self._base.execute("PRAGMA journal_mode = DELETE")
        except ERRORS as failed:
            if error is None:
                raise self._not_written(failed) from failed
        finally:
            self._held.close()

    def append(self, row: Row) -> None:
        """Write a row; after an error the journal is as it was before."""
        text, mark = written(row, self._study)
        now = time.monotonic()
        # With a write-ahead log the disk is asked for no single row: that takes as long as a
        # short variant. A rollback journal that it was not asked for does not survive a power cut.
        sync = self.mode == "rollback journal" or now - self._synced > _SYNC_EVERY_S
        try:
            if sync:
                self._base.execute("PRAGMA synchronous = FULL")
            self._base.execute(PUT, (row.variant, text.decode(), mark.decode()))
            if sync and self.mode == "write-ahead log":
                self._base.execute("PRAGMA synchronous = NORMAL")
        except ERRORS as error:
            raise self._not_written(error) from error
        if sync:
            self._synced = now

    def _take(self, held: ExitStack) -> None:
        try:
            lock = Lock(lock_of(self.path))
        except OSError as error:
            raise self._not_written(error) from error
        held.callback(lock.close)
        try:
            taken = lock.take(_WAITS_S)
        except OSError as error:
            hint = "choose another folder with `--out`, on a file system that has locks"
            raise OutputError.of(error, "the study cannot be locked", lock.path, hint) from error
        if not taken:
            raise in_use(self.path.parent)

    def _choose_mode(self) -> None:
        self._base.execute("PRAGMA synchronous = NORMAL")
        wanted = "WAL" if carries_wal(self.path.parent) else "DELETE"
        with suppress(sqlite3.OperationalError):  # a reader: as it is, it does as well
            self._base.execute(f"PRAGMA journal_mode = {wanted}")
        ((mode,),) = self._base.execute("PRAGMA journal_mode").fetchall()
        self.mode = "write-ahead log" if mode == b"wal" else "rollback journal"

    def _not_written(self, error: BaseException) -> OutputError:
        hint = "make room, then `arcless study resume`: nothing that was computed is lost"
        what = "the journal of the study cannot be written"
        if isinstance(error, OSError):
            return OutputError.of(error, what, self.path, hint)
        return OutputError(what, where=str(self.path), got=words(error), hint=hint)


def lock_of(path: Path) -> Path:
    """Return the lock that the process holds that writes a journal."""
    return path.with_suffix(".lock")


def is_locked(path: Path) -> bool:
    """Return whether a process is writing a journal just now."""
    return is_held(lock_of(path))


def in_use(folder: Path) -> StudyError:
    """Return the error of a study that another process computes."""
    return StudyError(
        "the study is being computed already",
        where=str(folder),
        expected="one process at a time",
        hint="wait for it, or stop it; `arcless study status` says how far it is",
    )


def rows(
    path: Path, study: str, damage: Damage, *, first: int = 1, last: int = _LAST
) -> Iterator[Row]:
    """Yield the rows of a journal in the order of the variants; none without a file.

    Parameters
    ----------
    path, study
        The journal, and the hash of what the study asks.
    damage
        Is told what was left out.
    first, last
        Numbers of the variants that are wanted.

    Raises
    ------
    StudyError
        The system does not let it be read.
    """
    done = first - 1
    try:
        if path.exists():
            for number, row in _found(path, study, first, last):
                if row is None:
                    damage.rows.add(number)
                else:
                    yield row
                done = number
    except (OSError, *ERRORS) as error:
        if isinstance(error, OSError) or not is_damage(error, path):
            raise _not_read(path, words(error)) from error
        damage.file = True
        left = salvaged(path, study)
        for number in sorted(left):
            if done < number <= last:
                yield left[number]


def _found(path: Path, study: str, first: int, last: int) -> Iterator[tuple[int, Row | None]]:
    """Yield numbers and rows, None for one that does not fit its seal."""
    with reading(path) as base:
        if not tables(base):
            ((pages,),) = base.execute("PRAGMA page_count").fetchall()
            if pages > 1:
                raise sqlite3.DatabaseError("no tables on the first page")
            return
        while part := base.execute(_SOME, (first, last, _PART)).fetchall():
            for number, text, mark in part:
                if not isinstance(number, int) or number < first:
                    raise sqlite3.DatabaseError("rows out of order")
                yield number, opened(text, mark, study, number)
                first = number + 1


def _not_read(path: Path, got: str) -> StudyError:
    return StudyError(
        "the journal of the study cannot be read",
        where=str(path),
        got=got,
        expected="a readable file that no program keeps locked",
        hint="look who may read it and its folder, or try again",
    )
