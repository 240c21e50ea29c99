"""A worker process, as the server sees it."""

import asyncio
import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.reduction import send_handle
from typing import Any

from arcless.studio.jobs.job import Task

_MODULE = "arcless.studio.processes.worker_process"
# Signals by which a process ends that nobody of us sent, in words.
_KILLED: dict[int, tuple[str, str | None]] = {
    signal.SIGKILL: ("it was killed, by a user or because the memory of the machine was used up",
                     "record less or shorten the line where memory is short"),
    signal.SIGTERM: ("it was terminated", None),
    signal.SIGSEGV: ("it crashed (segmentation fault)", "please report it"),
    signal.SIGABRT: ("it aborted itself", "please report it"),
    signal.SIGBUS: ("it could not reach its memory or a file", "is a disk full?"),
}  # fmt: skip


class Worker:
    """A process that waits for tasks, or does one.

    Parameters
    ----------
    heard
        Called on the event loop with each message of the process.
    ended
        Called on the event loop when the process is gone.
    """

    def __init__(
        self, heard: Callable[["Worker", tuple[Any, ...]], None], ended: Callable[["Worker"], None]
    ) -> None:
        self._loop = asyncio.get_running_loop()
        self._heard, self._ended = heard, ended
        ours, theirs = socket.socketpair()
        with theirs:
            self.process = subprocess.Popen(
                [sys.executable, "-P", "-m", _MODULE, str(theirs.fileno())],
                pass_fds=[theirs.fileno()],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                env=_environment(),
                start_new_session=True,  # Ctrl-C in the terminal is for the server alone
            )
        self._connection = Connection(ours.detach())
        self._sending = threading.Lock()
        self._leaving = False
        threading.Thread(target=self._listen, daemon=True).start()

    def do(self, task: Task, spool: int | None) -> None:
        """Have a task done; `spool` is the descriptor of the file that takes its motion."""
        call = (task.function, task.arguments)
        try:
            with self._sending:
                self._connection.send(("do", call, spool is not None))
                if spool is not None:
                    send_handle(self._connection, spool, self.process.pid)
        except OSError:
            pass  # it is gone, which `ended` will say

    def cancel(self) -> None:
        """Ask it to end its task."""
        try:
            with self._sending:
                self._connection.send(("cancel",))
        except OSError:
            pass

    def kill(self) -> None:
        """End it now; `ended` is called soon."""
        self.process.kill()

    @property
    def runs(self) -> bool:
        """True while the process is there."""
        return self.process.poll() is None

    def end(self) -> None:
        """End it now, and wait until it is gone."""
        self.process.kill()
        self.process.wait()

    def leave(self) -> None:
        """Let it end by itself, within a second, as when the server is gone."""
        if not self._leaving:
            self._leaving = True
            try:
                # The listening thread wakes up and closes; closing under it would not wake it.
                with socket.socket(fileno=os.dup(self._connection.fileno())) as line:
                    line.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass

    def why(self) -> dict[str, Any]:
        """Return why the process ended, as a complaint."""
        code = self.process.returncode
        told = (f"it ended with code {code}", "please report it")
        what, hint = told if code >= 0 else _KILLED.get(-code, (f"signal {-code}", None))
        text = f"the process that computed this is gone: {what}"
        if hint is None:
            return {"text": text, "what": text}
        return {"text": f"{text}; hint: {hint}", "what": text, "hint": hint}

    def _listen(self) -> None:
        try:
            while True:
                self._call(self._heard, self, self._connection.recv())
        except Exception:  # nobody there any more, or nothing that can be read
            self.process.kill() if not self._leaving else None
        self.process.wait()
        with self._sending:
            self._connection.close()
        self._call(self._ended, self)

    def _call(self, function: Callable[..., None], *arguments: Any) -> None:
        with suppress(RuntimeError):  # the loop is closed: the server has ended
            self._loop.call_soon_threadsafe(function, *arguments)


def _environment() -> dict[str, str]:
    """Return the environment of a worker: modules of the same places, no busy threads."""
    found = dict(os.environ)
    found["PYTHONPATH"] = os.pathsep.join(place for place in sys.path if place)
    # A thread of OpenBLAS waits busily for products, and none here is large enough for two.
    found.setdefault("OPENBLAS_NUM_THREADS", "1")
    return found
