"""Worker processes of a server: those that work, and those that wait for a task."""

import asyncio
import time
from collections.abc import Callable
from typing import Any

from arcless.studio.jobs.entry import Entry
from arcless.studio.jobs.worker import Worker
from arcless.studio.motion.spool import new_file

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
        Called with each message that a process sends of what it does.
    gone
        Called when a process is gone in the midst of something.
    """

    def __init__(
        self,
        heard: Callable[[Entry, tuple[Any, ...]], None],
        gone: Callable[[Entry, Worker], None],
    ) -> None:
        self._heard, self._gone = heard, gone
        self._at_work: dict[Worker, Entry] = {}
        self._idle: list[Worker] = []

    def prepare(self) -> None:
        """Have a process that waits."""
        if not self._idle:
            self._idle.append(Worker(self._hear, self._ended))

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
        worker.do(entry.task, None if file is None else file.fileno())

    def free(self, entry: Entry, used: int | None) -> None:
        """Let the process of what has ended wait for its next task, unless it is large.

        Parameters
        ----------
        entry
            What it has done.
        used
            Memory in bytes that it used at most; None where nothing tells it.
        """
        worker = entry.worker
        if worker is None or self._at_work.pop(worker, None) is None:
            return
        if (used or 0) > _LARGE or len(self._idle) >= _SPARE:
            worker.leave()
        else:
            self._idle.append(worker)

    async def leave(self) -> list[Entry]:
        """End all processes; return what they had not finished."""
        workers, unfinished = [*self._idle, *self._at_work], list(self._at_work.values())
        for worker in workers:
            worker.leave()
        deadline = time.monotonic() + LEAVE_S
        while time.monotonic() < deadline and any(one.runs for one in workers):
            await asyncio.sleep(0.02)
        for worker in workers:
            worker.end()
        return unfinished

    def _hear(self, worker: Worker, message: tuple[Any, ...]) -> None:
        entry = self._at_work.get(worker)
        if entry is not None:  # else it says that it is ready
            self._heard(entry, message)

    def _ended(self, worker: Worker) -> None:
        if worker in self._idle:
            self._idle.remove(worker)
        entry = self._at_work.pop(worker, None)
        if entry is not None:
            self._gone(entry, worker)
