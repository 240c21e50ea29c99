"""Main program of a worker process: it does one task after the other, as long as the server lives.

Its command line is `python -m arcless.studio.processes.worker_process DESCRIPTOR LAST_S`.
"""

import os
import queue
import signal
import sys
import threading
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.reduction import recv_handle
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError
from arcless.studio.processes.talk import Talk

# Time in s that a task has to clean up when the server is gone; then the process ends.
LAST_S = 1.0
# Time in s after which a thread that steps gets its turn. Longer, it waits for the one that writes
# what is watched; much shorter, switching costs more than it saves.
_TURN_S = 2e-4
_NO_MEMORY = "record less (`output.line_every: 50`) or shorten the line"
Call = tuple[Any, tuple[Any, ...]]


def main() -> None:
    """Serve until the server closes the connection or is gone."""
    # Ctrl-C in the terminal is the server's; it ends its workers.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sys.setswitchinterval(_TURN_S)
    connection, last_s = Connection(int(sys.argv[1])), float(sys.argv[2])
    tasks: queue.SimpleQueue[tuple[Call, Talk] | None] = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(connection, tasks, last_s), daemon=True).start()
    while (task := tasks.get()) is not None:
        _do(*task)
    os._exit(0)  # the server is gone


def _listen(
    connection: Connection, tasks: "queue.SimpleQueue[tuple[Call, Talk] | None]", last_s: float
) -> None:
    """Take tasks and orders; end the process when the server is gone."""
    talk = Talk(connection)  # of no task
    with suppress(EOFError, OSError):
        while True:
            match connection.recv():
                case ("cancel",):
                    talk.cancelled.set()
                case ("order", order):
                    talk.orders.put(order)
                case ("do", call, has_spool):
                    talk = Talk(connection, recv_handle(connection) if has_spool else None)
                    tasks.put((call, talk))
    talk.cancelled.set()
    threading.Timer(last_s, os._exit, (1,)).start()
    tasks.put(None)


def _do(call: Call, talk: Talk) -> None:
    """Do one task, and tell its end."""
    function, arguments = call
    try:
        end: tuple[str, Any] = ("done", function(talk, *arguments))
    except KeyboardInterrupt:
        end = ("cancelled", None)
    except ArclessError as error:
        end = ("failed", error)
    except Exception as error:
        end = ("failed", _failure(error))
    if talk.spool is not None:
        os.close(talk.spool)
    used = _most_memory()
    try:
        talk.send(("end", *end, used))
    except Exception as error:  # what it returns, or an error, does not pickle
        fault = f"internal fault: the answer of a worker does not pickle: {error}"
        talk.send(("end", "failed", (fault, "please report it"), used))


def _failure(error: Exception) -> tuple[str, str | None]:
    """Return what is wrong, and a hint."""
    match error:
        case MemoryError():
            return "not enough memory", _NO_MEMORY
        case OSError():
            place = f"{error.filename}: " if error.filename else ""
            return f"{place}{error.strerror or error}", None
    return f"internal fault: {type(error).__name__}: {error}", "please report it"


def _most_memory(status: Path = Path("/proc/self/status")) -> int | None:
    """Return the most memory in bytes that this process has used; None where nothing tells it.

    Without Linux's `status` that of `getrusage` counts, which on Linux is no less than what the
    server used when it started the process.
    """
    with suppress(OSError):
        found = status.read_text("ascii").partition("VmHWM:")[2].split(maxsplit=1)
        if found:
            return 1024 * int(found[0])
    try:
        import resource
    except ImportError:  # Windows
        return None
    unit = 1 if sys.platform == "darwin" else 1024  # bytes of ru_maxrss: getrusage(2) of each
    return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


if __name__ == "__main__":
    main()
