"""A temporary file that another process is given, and that is gone when nobody has it open."""

import os
import sys
import tempfile
from multiprocessing.connection import Connection
from typing import BinaryIO, cast

# Flags of Windows, 0 elsewhere: no line ends are translated, the file goes with the last one that
# has it open, child processes do not inherit it. Without the second one the first process, which
# has the file open in this way, would keep the other one out.
_AS_FIRST_OPENED = (
    getattr(os, "O_BINARY", 0) | getattr(os, "O_TEMPORARY", 0) | getattr(os, "O_NOINHERIT", 0)
)


def new_file() -> BinaryIO:
    """Return a new file, which is gone when nobody has it open any more.

    On POSIX it has no name. On Windows it has one, by which others open it.
    """
    # Windows returns a wrapper of another type, which has the same methods.
    return cast(BinaryIO, tempfile.TemporaryFile("w+b", buffering=0, prefix="arcless-"))


def send_name(connection: Connection, file: BinaryIO) -> None:
    """Send the name of a file, for `receive_name`.

    Raises
    ------
    OSError
        Nobody is there any more.
    """
    connection.send(file.name)


def receive_name(connection: Connection) -> int:
    """Open the file of `send_name`; return its descriptor.

    Raises
    ------
    OSError
        It is gone.
    """
    return os.open(connection.recv(), os.O_RDWR | _AS_FIRST_OPENED)


if sys.platform == "win32":

    def send_file(connection: Connection, file: BinaryIO, process: int) -> None:  # noqa: ARG001
        """Send an open file to a process, see `receive_file`."""
        send_name(connection, file)

    receive_file = receive_name
else:
    from multiprocessing.reduction import recv_handle, send_handle

    def send_file(connection: Connection, file: BinaryIO, process: int) -> None:
        """Send an open file to a process, see `receive_file`."""
        send_handle(connection, file.fileno(), process)

    receive_file = recv_handle
