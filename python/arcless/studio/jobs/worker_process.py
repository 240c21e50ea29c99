"""Main program of a worker process: it does one task after the other, as long as the server lives.

    python -m arcless.studio.jobs.worker_process DESCRIPTOR

It imports what a run needs before anybody asks, so that a run begins at once.
"""

import gc
import os
import queue
import signal
import sys
import threading
from contextlib import suppress
from importlib import import_module
from multiprocessing.connection import Connection
from multiprocessing.reduction import recv_handle
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError
from arcless.studio.jobs.talk import Talk

# Time in s that a task has to clean up when the server is gone; then the process ends.
_LAST_S = 1.0
# Time in s after which a thread that steps gets its turn. Longer, it waits for the one that writes
# what is watched; much shorter, switching costs more than it saves.
_TURN_S = 2e-4
_AHEAD = ("arcless.simulate", "arcless.assess", "arcless.validate", "h5py",
          "arcless.results.run_folder.files", "arcless.studio.runs.run")  # fmt: skip
_NO_MEMORY = {
    "text": "not enough memory; hint: record less (`output.line_every: 50`) or shorten the line",
    "what": "not enough memory",
    "hint": "record less (`output.line_every: 50`) or shorten the line",
}


def main() -> None:
    """Serve until the server closes the connection or is gone."""
    # Ctrl-C in the terminal is the server's; it ends its workers.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sys.setswitchinterval(_TURN_S)
    connection = Connection(int(sys.argv[1]))
    tasks: queue.SimpleQueue[tuple[Any, Talk]] = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(connection, tasks), daemon=True).start()
    from arcless.report import template

    for name in _AHEAD:
        import_module(name)
    template.import_ahead()
    gc.freeze()  # nothing of what was imported will ever be garbage
    with suppress(OSError):  # the server has just gone, which `_listen` is told
        connection.send(("ready",))
    while True:
        _do(*tasks.get())


def _listen(connection: Connection, tasks: "queue.SimpleQueue[tuple[Any, Talk]]") -> None:
    """Take tasks and orders to cancel; end the process when the server is gone."""
    talk: Talk | None = None
    try:
        while True:
            message = connection.recv()
            if message[0] == "cancel":
                if talk is not None:
                    talk.cancelled.set()
                continue
            _, call, has_spool = message
            spool = recv_handle(connection) if has_spool else None
            talk = Talk(connection, spool)
            tasks.put((call, talk))
    except (EOFError, OSError):
        if talk is not None:
            talk.cancelled.set()
        threading.Timer(_LAST_S, os._exit, (1,)).start()
        tasks.put((None, Talk(connection)))


def _do(call: Any, talk: Talk) -> None:
    """Do one task, and tell its end."""
    if call is None:
        os._exit(0)  # the server is gone
    try:
        function, arguments = call
        end: tuple[str, Any] = ("done", function(talk, *arguments))
    except KeyboardInterrupt:
        end = ("cancelled", None)
    except MemoryError:
        end = ("failed", _NO_MEMORY)
    except ArclessError as error:
        end = ("failed", error)
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        end = ("failed", {"text": f"{place}{error.strerror or error}"})
    except Exception as error:
        told = f"internal fault: {type(error).__name__}: {error}; hint: please report it"
        end = ("failed", {"text": told})
    if talk.spool is not None:
        os.close(talk.spool)
    try:
        _tell(talk, end, _most_memory())
    except OSError:
        os._exit(1)


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


def _tell(talk: Talk, end: tuple[str, Any], used: int | None) -> None:
    try:
        talk.send((*end, used))
    except OSError:
        raise
    except Exception as error:  # what it returns, or an error, does not pickle
        told = f"internal fault: the answer of a worker does not pickle: {error}"
        talk.send(("failed", {"text": told}, used))


if __name__ == "__main__":
    main()
