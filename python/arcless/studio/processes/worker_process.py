"""Main program of a worker process: it does one task after the other, as long as the server lives.

Its command line is `python -m arcless.studio.processes.worker_process LINE LAST_S`.
"""

import os
import queue
import signal
import sys
import threading
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from arcless.errors import ArclessError
from arcless.platforms.children import connect
from arcless.platforms.memory import most_memory
from arcless.platforms.shared_files import receive_file
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
    connection, last_s = connect(sys.argv[1]), float(sys.argv[2])
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
                    talk = Talk(connection, receive_file(connection) if has_spool else None)
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
    used = most_memory()
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


if __name__ == "__main__":
    main()
