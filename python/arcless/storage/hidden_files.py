"""Hidden files and folders of writers at work, and what killed ones left behind.

A writer holds a lock (`lock`) in a file next to its hidden file or folder, made before that and
removed after it. The system lets go of the lock when the process ends, however it ends. So whatever
carries the prefix and is not locked was left behind by a process that was killed, and is removed by
the next writer in the same folder.
"""

import secrets
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from arcless.storage.lock import Lock

PREFIX = ".arcless-unfinished-"
_LOCK = ".lock"
# A sweeper holds a lock while it removes a name: some milliseconds.
_PATIENCE_S = 10.0
# The lock of who writes the files of a folder together, and the wait for it. Too short, and a
# sweeper is taken for a writer; too long, and who is refused waits for the refusal.
_WRITER = f"{PREFIX}writer"
_WRITER_PATIENCE_S = 0.5


class Claim:
    """A name for a hidden file or folder that belongs to this process while it is taken.

    Nothing is made before `take`.
    """

    def __init__(self, path: Path) -> None:
        self._path = path.with_name(path.name + _LOCK)
        self._lock: Lock | None = None

    def take(self) -> None:
        """Take the name; where that is interrupted, nothing of it stays.

        Raises
        ------
        OSError
            Nothing can be written there.
        """
        try:
            while True:
                self._lock = Lock(self._path)
                with suppress(OSError):  # a file system without locks: nobody sweeps there
                    self._lock.take(_PATIENCE_S)
                if self._path.exists():
                    return
                self._lock.close()  # a sweeper saw it before it was taken, and removed it
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Give the name back; what has it is gone, or goes with the next sweep."""
        if self._lock is not None:
            _remove_file(self._lock)
        else:  # interrupted when the file stood there, and nothing knew it
            with suppress(OSError):
                self._path.unlink(missing_ok=True)


def new_name() -> str:
    """Return a name for a hidden file or folder that nobody else has."""
    return f"{PREFIX}{secrets.token_hex(4)}"


@contextmanager
def claimed(path: Path) -> Iterator[None]:
    """Claim the name of a hidden file while it is written."""
    claim = Claim(path)
    try:
        claim.take()
        yield
    finally:
        claim.close()


def create_folder(path: Path) -> Claim:
    """Create a hidden folder, which belongs to this process until the claim is closed."""
    claim = Claim(path)
    try:
        claim.take()
        path.mkdir(mode=0o700)
        return claim
    except BaseException:
        with suppress(OSError):
            path.rmdir()
        claim.close()
        raise


@contextmanager
def temporary_folder() -> Iterator[Path]:
    """Make a folder among the temporary files.

    If this process is killed, `sweep_temporary` of a later one removes it.
    """
    path = Path(tempfile.gettempdir()) / new_name()
    claim = create_folder(path)
    try:
        yield path
    finally:
        shutil.rmtree(path, ignore_errors=True)
        claim.close()


def sweep_temporary() -> None:
    """Remove temporary folders that killed processes left."""
    sweep(Path(tempfile.gettempdir()))


def claim_folder(folder: Path) -> Lock | None:
    """Return the lock of the one writer of a folder's files; None while somebody else has it.

    `release` gives it back. On a file system without locks everybody is the one writer.

    Raises
    ------
    OSError
        Nothing can be written there.
    """
    path = folder / f"{_WRITER}{_LOCK}"
    is_new, lock = not path.exists(), None
    try:
        while True:
            lock = Lock(path)
            with suppress(OSError):
                if not lock.take(_WRITER_PATIENCE_S):
                    return None
            if path.exists():
                return lock
            lock.close()  # the writer before removed it after it was found
            is_new = True
    except BaseException:
        if lock is not None:
            lock.close()
        if is_new:
            with suppress(OSError):
                path.unlink(missing_ok=True)
        raise


def release(lock: Lock) -> None:
    """Give back what `claim_folder` gave."""
    _remove_file(lock)


def sweep(folder: Path) -> None:
    """Remove what killed processes left in a folder; what cannot be removed stays."""
    with suppress(OSError):
        for name in {path.name.removesuffix(_LOCK) for path in folder.glob(f"{PREFIX}*")}:
            _remove_if_left(folder / name)


def _remove_if_left(path: Path) -> None:
    beside = path.with_name(path.name + _LOCK)
    if path.is_symlink() or beside.is_symlink():  # none of ours
        return
    with suppress(OSError):  # of another user, or without locks
        lock = Lock(beside)  # made again where the name was given back already
        if lock.take():
            try:
                if path.is_dir():
                    shutil.rmtree(path)
                else:
                    path.unlink(missing_ok=True)
            finally:
                _remove_file(lock)


def _remove_file(lock: Lock) -> None:
    """Remove a lock file while it is held: once let go of, its name may be another one's."""
    try:
        lock.path.unlink(missing_ok=True)
    except OSError:  # a system that removes no file in use
        lock.close()
        with suppress(OSError):
            lock.path.unlink(missing_ok=True)
    else:
        lock.close()
