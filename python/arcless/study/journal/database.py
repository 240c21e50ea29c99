"""SQLite as the journal uses it: how a database is opened, made, and how its errors are read."""

import errno
import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from shutil import copyfile
from tempfile import TemporaryDirectory

from arcless.storage.lock import database_address

# Exceptions that a database may raise; damaged lengths ask for memory that nobody has.
ERRORS = (sqlite3.DatabaseError, MemoryError)
# Files that belong to a database.
BESIDE = ("-wal", "-shm", "-journal")
# Where no write-ahead log is, a reader holds up a writer, and the other way round, for a moment.
_PATIENCE_S = 30.0
# Refusals of the system; all else is in the file. Of reading only see `is_damage`.
_REFUSED = {
    sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED, sqlite3.SQLITE_IOERR, sqlite3.SQLITE_FULL,
    sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_PERM, sqlite3.SQLITE_PROTOCOL, sqlite3.SQLITE_NOLFS,
    sqlite3.SQLITE_INTERRUPT, sqlite3.SQLITE_AUTH,
}  # fmt: skip


def connect(path: Path, mode: str = "rwc") -> sqlite3.Connection:
    """Open a database; every statement is a transaction, texts are bytes."""
    address = database_address(path.absolute(), mode)
    base = sqlite3.connect(address, timeout=_PATIENCE_S, isolation_level=None, uri=True)
    base.text_factory = bytes
    return base


@contextmanager
def reading(path: Path) -> Iterator[sqlite3.Connection]:
    """Open a database to read it, from a copy where its folder does not let SQLite at it.

    In a folder for reading only, what a killed process left cannot be put in order there.
    """
    with closing(connect(path, "ro")) as base:
        try:
            tables(base)
        except sqlite3.OperationalError as error:
            if code(error) not in (sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_READONLY):
                raise
        else:
            yield base
            return
    with TemporaryDirectory(prefix="arcless-") as folder:
        copy = Path(folder) / path.name
        copyfile(path, copy)
        for end in ("-wal", "-journal"):
            with suppress(FileNotFoundError):
                copyfile(f"{path}{end}", f"{copy}{end}")
        with closing(connect(copy, "rw")) as base:
            yield base


def tables(base: sqlite3.Connection) -> list[tuple[bytes, bytes]]:
    """Return what a database says of its tables."""
    return base.execute("SELECT name, sql FROM sqlite_master ORDER BY name").fetchall()


def code(error: BaseException) -> int:
    """Return the primary code of an error of SQLite; 0 where it has none."""
    return int(getattr(error, "sqlite_errorcode", 0)) & 0xFF


def is_damage(error: BaseException, path: Path) -> bool:
    """Return whether an error comes from the file's content, not from a refusal of the system."""
    if code(error) == sqlite3.SQLITE_READONLY:  # as a damaged header may say
        return os.access(path, os.W_OK) and os.access(path.parent, os.W_OK)
    return code(error) not in _REFUSED


def words(error: BaseException) -> str:
    """Return an error in words that say as much as those of the system."""
    if code(error) == sqlite3.SQLITE_FULL:
        return os.strerror(errno.ENOSPC)
    return str(error)
