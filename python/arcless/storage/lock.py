"""Locks between processes that every system lets go of when their holder ends, however it ends.

A lock is an SQLite database without content, and an exclusive transaction on it. SQLite locks
files by what the system at hand has for it, so there is one kind of lock everywhere. The file stays
empty.
"""

import errno
import os
from contextlib import suppress
from pathlib import Path, PurePath
from typing import TYPE_CHECKING
from urllib.parse import quote

if TYPE_CHECKING:
    import sqlite3


class Lock:
    """A lock file, made where there is none; not taken yet.

    Parameters
    ----------
    path
        The file. Nothing but this class may open it: on POSIX, closing any file releases all
        locks that the process has on that file.

    Raises
    ------
    OSError
        It cannot be made.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._base: sqlite3.Connection | None = None
        with suppress(FileExistsError):
            os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))

    def take(self, wait_s: float = 0.0) -> bool:
        """Return whether it is held by this object from now on; False if somebody else holds it.

        Raises
        ------
        OSError
            The file is no lock file, is gone, or lies where there are no locks.
        """
        import sqlite3

        base = None
        try:
            base = _opened(self.path, "rw", wait_s)
            base.execute("PRAGMA journal_mode = MEMORY")  # else it has a journal next to it
            base.execute("BEGIN EXCLUSIVE")
        except sqlite3.Error as error:
            if base is not None:
                base.close()
            if _is_busy(error):
                return False
            raise OSError(errno.ENOLCK, f"no lock: {error}", str(self.path)) from error
        self._base = base
        return True

    def close(self) -> None:
        """Let go of it; the file stays."""
        if self._base is not None:
            self._base.close()
            self._base = None


def is_held(path: Path) -> bool:
    """Return whether some process, this one included, holds a lock; it may be for reading only."""
    import sqlite3

    if not path.exists():
        return False
    try:
        base = _opened(path, "ro", 0.0)
        try:
            base.execute("SELECT count(*) FROM sqlite_master")
        finally:
            base.close()
    except sqlite3.Error as error:
        return _is_busy(error)
    return False


def database_address(path: PurePath, mode: str) -> str:
    """Return the address by which SQLite opens a database in a mode (`ro`, `rw`, `rwc`).

    The folder of a server, which on Windows begins with two backslashes, has four slashes there:
    `Path.as_uri` makes the server a host, which SQLite refuses.

    Parameters
    ----------
    path
        The file, a whole path.
    mode
        Mode of SQLite.
    """
    slashed = path.as_posix()
    slash = "" if slashed.startswith("/") else "/"  # before the letter of a drive
    return f"file://{slash}{quote(os.fsencode(slashed), safe='/:')}?mode={mode}"


def _opened(path: Path, mode: str, wait_s: float) -> "sqlite3.Connection":
    import sqlite3

    address = database_address(path.absolute(), mode)
    return sqlite3.connect(
        address, timeout=wait_s, isolation_level=None, uri=True, check_same_thread=False
    )


def _is_busy(error: "sqlite3.Error") -> bool:
    import sqlite3

    return getattr(error, "sqlite_errorcode", 0) & 0xFF == sqlite3.SQLITE_BUSY
