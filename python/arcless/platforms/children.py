"""Child processes: started apart from the terminal, with a line to the one that starts them."""

import os
import socket
import subprocess
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection

_BY_STDIN = "-"  # in place of a number: the line is told on standard input


def start(
    module: str, arguments: Sequence[str], environment: Mapping[str, str]
) -> "tuple[subprocess.Popen[bytes], socket.socket]":
    """Start a module in a new interpreter; return the process and our end of the line to it.

    Ctrl-C in the terminal is not for the process. It inherits nothing but standard error and its
    end of the line, which `connect` takes from the first argument; the others follow.

    Raises
    ------
    OSError
        The system starts no process, or has no socket left.
    """
    ours, theirs = socket.socketpair()
    try:
        with theirs:
            return _started(module, arguments, theirs, environment), ours
    except BaseException:
        ours.close()
        raise


if sys.platform == "win32":

    def _started(
        module: str, arguments: Sequence[str], theirs: socket.socket, environment: Mapping[str, str]
    ) -> "subprocess.Popen[bytes]":
        process = subprocess.Popen(
            [sys.executable, "-P", "-m", module, _BY_STDIN, *arguments],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            env=environment,
            creationflags=subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW,
        )
        # A socket is not inherited as a file is: a copy is made for the process. Where that has
        # ended already, the line ends with it.
        assert process.stdin is not None
        with suppress(OSError), process.stdin:
            process.stdin.write(theirs.share(process.pid))
        return process

    def connect(argument: str) -> Connection:  # noqa: ARG001
        """Return the connection to the process that started this one, by the first argument."""
        return Connection(socket.fromshare(sys.stdin.buffer.read()).detach())
else:

    def _started(
        module: str, arguments: Sequence[str], theirs: socket.socket, environment: Mapping[str, str]
    ) -> "subprocess.Popen[bytes]":
        number = theirs.fileno()
        return subprocess.Popen(
            [sys.executable, "-P", "-m", module, str(number), *arguments],
            pass_fds=[number],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            env=environment,
            start_new_session=True,
        )

    def connect(argument: str) -> Connection:
        """Return the connection to the process that started this one, by the first argument."""
        return Connection(int(argument))


def connection_of(line: socket.socket) -> Connection:
    """Return a connection on a line, which stays open as long as either of them is."""
    return Connection(line.dup().detach())


def environment() -> dict[str, str]:
    """Return the environment of a child: modules of the same places, no busy threads."""
    found = dict(os.environ)
    found["PYTHONPATH"] = os.pathsep.join(place for place in sys.path if place)
    # A thread of OpenBLAS waits busily for products, and none here is large enough for two.
    found.setdefault("OPENBLAS_NUM_THREADS", "1")
    return found
