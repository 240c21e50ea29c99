"""Worker processes of a server: those that work, and those that wait for a task."""

import asyncio
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from functools import partial
from typing import Any

from arcless.platforms.shared_files import new_file
from arcless.studio.jobs.entry import Entry
from arcless.studio.jobs.ready import make_ready
from arcless.studio.processes.worker import Worker

# Processes that wait for a task, each of 100 MB: with fewer a run waits a second for one to start.
_SPARE = 2
# Memory in bytes above which a process is not used again: that of a long run.
_LARGE = 700_000_000
# Time in s that processes have to end by themselves when the server ends.
LEAVE_S = 0.4


class Pool:
    """Processes, and what each of them does.

    Parameters
    ----------
    heard
        Called on the event loop with what the function of an entry says.
    ended
        Called on the event loop with the end of an entry, see `Worker.do`.
    """

    def __init__(
        self,
        heard: Callable[[Entry, tuple[Any, ...]], None],
        ended: Callable[[Entry, Future[Any]], None],
    ) -> None:
        self._heard, self._ended = heard, ended
        self._at_work: dict[Worker, Entry] = {}
        self._idle: list[Worker] = []

    def prepare(self) -> None:
        """Have a process that waits."""
        self._idle = [worker for worker in self._idle if worker.runs]
        if not self._idle:
            worker = Worker()
            worker.do(make_ready)
            self._idle.append(worker)

    def busy(self, *, jobs: bool) -> int:
        """Return how many processes work on jobs, or on questions."""
        return sum((entry.job is not None) == jobs for entry in self._at_work.values())

    def assign(self, entry: Entry) -> None:
        """Have a process begin."""
        self.prepare()
        entry.worker = worker = self._idle.pop()
        self._at_work[worker] = entry
        file = None
        if entry.task.shows:
            try:
                file = new_file()
            except OSError:
                file = None  # no room for motion; the run itself may have
        entry.give_spool(file)
        on_loop = partial(_on_loop, asyncio.get_running_loop())
        end = worker.do(
            entry.task.function,
            *entry.task.arguments,
            heard=partial(on_loop, self._heard, entry),
            spool=file,
        )
        end.add_done_callback(partial(on_loop, self._free, worker, entry))

    def leave(self) -> list[Entry]:
        """Let all processes end; return what they have not finished, whose ends come soon."""
        for worker in [*self._idle, *self._at_work]:
            worker.leave(LEAVE_S)
        return list(self._at_work.values())

    def _free(self, worker: Worker, entry: Entry, end: Future[Any]) -> None:
        """Let the process of what has ended wait for its next task, unless it is large."""
        del self._at_work[worker]
        if worker.used > _LARGE or len(self._idle) >= _SPARE:
            worker.leave()
        elif worker.runs:
            self._idle.append(worker)
        self._ended(entry, end)


def _on_loop(loop: asyncio.AbstractEventLoop, act: Callable[..., None], *arguments: Any) -> None:
    with suppress(RuntimeError):  # the loop is closed: the server has ended
        loop.call_soon_threadsafe(act, *arguments)
