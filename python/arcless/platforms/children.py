"""Child processes: started apart from the terminal, with a line to the one that starts them."""

import os
import socket
import subprocess
import sys
from collections.abc import Mapping, Sequence
from multiprocessing.connection import Connection


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
    command = [sys.executable, "-P", "-m", module, str(theirs.fileno()), *arguments]
    try:
        with theirs:
            return _started(command, theirs, environment), ours
    except BaseException:
        ours.close()
        raise


if sys.platform == "win32":

    def _started(
        command: list[str], theirs: socket.socket, environment: Mapping[str, str]
    ) -> "subprocess.Popen[bytes]":
        theirs.set_inheritable(True)
        start = subprocess.STARTUPINFO()
        # Only what is named here is inherited, though other threads start processes meanwhile.
        start.lpAttributeList = {"handle_list": [theirs.fileno()]}
        return subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            env=environment,
            startupinfo=start,
            creationflags=subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW,
        )
else:

    def _started(
        command: list[str], theirs: socket.socket, environment: Mapping[str, str]
    ) -> "subprocess.Popen[bytes]":
        return subprocess.Popen(
            command,
            pass_fds=[theirs.fileno()],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            env=environment,
            start_new_session=True,
        )


def connection_of(line: socket.socket) -> Connection:
    """Return a connection on a line, which stays open as long as either of them is."""
    return Connection(line.dup().detach())


def connect(argument: str) -> Connection:
    """Return the connection to the process that started this one, by the first argument."""
    return Connection(int(argument))


def environment() -> dict[str, str]:
    """Return the environment of a child: modules of the same places, no busy threads."""
    found = dict(os.environ)
    found["PYTHONPATH"] = os.pathsep.join(place for place in sys.path if place)
    # A thread of OpenBLAS waits busily for products, and none here is large enough for two.
    found.setdefault("OPENBLAS_NUM_THREADS", "1")
    return found
