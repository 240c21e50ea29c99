"""Hidden files and folders of writers at work, and what killed ones left behind.

A writer holds a lock (`flock`) on its hidden file or folder. The system lets go of it when the
process ends, however it ends. So whatever carries the prefix and is not locked was left behind by a
process that was killed, and is removed by the next writer in the same folder.
"""

import fcntl
import os
import secrets
import shutil
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

PREFIX = ".arcless-unfinished-"


def new_name() -> str:
    """Return a name for a hidden file or folder that nobody else has."""
    return f"{PREFIX}{secrets.token_hex(4)}"


def create(path: Path) -> BinaryIO:
    """Create a hidden file, locked until it is closed."""
    while True:
        file = path.open("x+b")
        if _claimed(file.fileno(), path):
            return file
        file.close()


def create_folder(path: Path) -> int:
    """Create a hidden folder, locked until the returned descriptor is closed."""
    while True:
        path.mkdir(mode=0o700)
        descriptor = os.open(path, os.O_RDONLY)
        if _claimed(descriptor, path):
            return descriptor
        os.close(descriptor)


def sweep(folder: Path) -> None:
    """Remove what killed processes left in a folder; what cannot be removed stays."""
    with suppress(OSError):
        for path in folder.glob(f"{PREFIX}*"):
            _remove_if_left(path)


def _remove_if_left(path: Path) -> None:
    with suppress(OSError):  # locked, gone meanwhile, of another user, or without locks
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if path.is_dir():
                shutil.rmtree(path)
            else:
                path.unlink()
        finally:
            os.close(descriptor)


def _claimed(descriptor: int, path: Path) -> bool:
    """Lock what was just created; False if a sweeper saw it before the lock and removed it."""
    with suppress(OSError):  # a file system without locks: nobody sweeps there
        fcntl.flock(descriptor, fcntl.LOCK_EX)
    return path.exists()
