"""Reading and writing at a place of a file, whatever other threads do with it meanwhile."""

import os
import sys
import threading

# Windows has one position for a file that is open, and no call that leaves it alone.
_ONE_AT_A_TIME = threading.Lock()


def seek_and_read(descriptor: int, size: int, place: int) -> bytes:
    """Read at most so many bytes from a place on; moves the position of the file.

    Raises
    ------
    OSError
        The file cannot be read.
    """
    with _ONE_AT_A_TIME:
        os.lseek(descriptor, place, os.SEEK_SET)
        return os.read(descriptor, size)


def seek_and_write(descriptor: int, content: memoryview, place: int) -> int:
    """Write bytes from a place on, return how many; moves the position of the file.

    Raises
    ------
    OSError
        The file cannot be written.
    """
    with _ONE_AT_A_TIME:
        os.lseek(descriptor, place, os.SEEK_SET)
        return os.write(descriptor, content)


if sys.platform == "win32":
    read_at, write_at = seek_and_read, seek_and_write
else:
    read_at, write_at = os.pread, os.pwrite
