"""Jobs of a server: as many at once as there are processors, the rest waits its turn."""

import asyncio
import itertools
import os
import secrets
import time
from collections import deque
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO

from arcless.errors import ArclessError
from arcless.storage import hidden_files
from arcless.studio.answers.answers import Refused, complaint
from arcless.studio.jobs.job import Job, Kind, Task
from arcless.studio.jobs.worker import Worker
from arcless.studio.motion.spool import SpooledMotion, new_file

# Jobs that are kept in the list when they have ended, and those that may wait. More would make
# the list long; less forgets what the user has not seen yet.
KEPT, MOST_WAITING = 100, 1000
# Time in s between two messages of one job.
_BETWEEN_S = 0.05
# Time in s that a job has to end by itself when it is cancelled; then its process is killed. A
# line at rest of some km is found in native code that nobody can interrupt.
CANCEL_S = 0.7
# Time in s that all have when the server ends.
LEAVE_S = 0.4
# Memory in bytes above which a process is not used again: a long run's.
_LARGE = 700_000_000
# Processes that wait for a task, each of 100 MB: with fewer a run waits a second for one to start.
_SPARE = 2
# Processes for questions that are answered at once, besides those of jobs.
_FOR_QUESTIONS = 2

Tell = Callable[[dict[str, Any]], None]


class Entry:
    """A job or a question, with all that belongs to it."""

    def __init__(self, task: Task, job: Job | None) -> None:
        self.task, self.job = task, job
        self.end: asyncio.Future[Any] = asyncio.get_running_loop().create_future()
        self.worker: Worker | None = None
        self.file: BinaryIO | None = None
        self.motion: SpooledMotion | None = None
        self.geometry: Any = None
        self.opened = asyncio.Event()  # motion is there, or will never be
        self.wanted = True
        self.told_at, self.is_told = 0.0, True


class Jobs:
    """All jobs of a server. Everything is called on the event loop.

    Parameters
    ----------
    tell
        Takes messages for all pages.
    most
        Jobs at once; the number of processors without.
    """

    def __init__(self, tell: Tell, most: int | None = None) -> None:
        self._tell = tell
        self._most = most or len(os.sched_getaffinity(0))
        self._entries: dict[str, Entry] = {}
        self._waiting: deque[Entry] = deque()
        self._questions: deque[Entry] = deque()
        self._at_work: dict[Worker, Entry] = {}
        self._idle: list[Worker] = []
        self._ended = False
        self._number = itertools.count(1)
        self._server = secrets.token_hex(3)  # jobs of an older server are other ones

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Have a process ready until the server ends; leave none behind."""
        self._idle.append(self._new_worker())
        try:
            yield
        finally:
            await self._leave()

    def start(self, kind: Kind, title: str, task: Task, *, path: str | None = None) -> Job:
        """Begin a job, or let it wait until a processor is free.

        Parameters
        ----------
        kind, title
            Kind, and words for the user.
        task
            What is done.
        path
            Where its result will be, below the folder: another job there is refused.

        Raises
        ------
        Refused
            Too many jobs wait, or another one writes there.
        """
        if len(self._waiting) >= MOST_WAITING:
            raise Refused(429, f"{MOST_WAITING} jobs wait already")
        for entry in self._entries.values():
            other = entry.job
            if path is not None and other and other.path == path and not other.has_ended:
                raise Refused(409, f"{path} is being computed already", job=other.to_dict())
        job = Job(f"{self._server}-{next(self._number)}", kind, title, path=path)
        entry = Entry(task, job)
        entry.end.add_done_callback(_look)
        self._entries[job.id] = entry
        self._waiting.append(entry)
        self._forget()
        self._begin()
        self._changed(entry, now=True)
        return job

    async def compute(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Return what a function returns, computed in a worker process; not listed as a job.

        Called as functions of jobs are, with a `Talk` first. Who stops waiting cancels it.

        Raises
        ------
        ArclessError
            That of the function.
        Refused
            The process failed.
        """
        entry = Entry(Task(function, arguments), None)
        self._questions.append(entry)
        self._begin()
        try:
            return await asyncio.shield(entry.end)
        except asyncio.CancelledError:
            entry.end.add_done_callback(_look)
            self._cancel(entry)
            raise

    def listing(self) -> list[dict[str, Any]]:
        """Return all jobs as plain values, the oldest first."""
        return [entry.job.to_dict() for entry in self._entries.values() if entry.job]

    def entry(self, name: str) -> Entry:
        """Return a job with its motion.

        Raises
        ------
        Refused
            There is none of this name.
        """
        found = self._entries.get(name)
        if found is None:
            raise Refused(404, "there is no such job; the server may have been started again")
        return found

    def cancel(self, name: str) -> dict[str, Any]:
        """End a job within a second; one that has ended stays as it is."""
        entry = self.entry(name)
        self._cancel(entry)
        assert entry.job is not None
        return entry.job.to_dict()

    def motions(self) -> dict[str, SpooledMotion]:
        """Return the motions that jobs have spooled, by the names of the jobs."""
        return {name: one.motion for name, one in self._entries.items() if one.motion}

    def forget_motion(self, name: str) -> None:
        """Give the disk of a job's motion back."""
        entry = self.entry(name)
        if entry.motion is not None:
            entry.motion.close()
            entry.motion = None

    # Who works.

    def _new_worker(self) -> Worker:
        return Worker(self._heard, self._gone)

    def _begin(self) -> None:
        """Begin what may begin."""
        if self._ended:
            return
        while self._waiting and self._count(jobs=True) < self._most:
            self._assign(self._waiting.popleft())
        while self._questions and self._count(jobs=False) < _FOR_QUESTIONS:
            self._assign(self._questions.popleft())
        if not self._idle:
            self._idle.append(self._new_worker())

    def _count(self, *, jobs: bool) -> int:
        return sum((entry.job is not None) == jobs for entry in self._at_work.values())

    def _assign(self, entry: Entry) -> None:
        worker = self._idle.pop() if self._idle else self._new_worker()
        entry.worker = worker
        self._at_work[worker] = entry
        try:
            entry.file = new_file() if entry.task.shows else None
        except OSError:  # no room for motion: the run itself may have
            entry.file = None
        if entry.file is None:
            entry.opened.set()
        worker.do(entry.task, None if entry.file is None else entry.file.fileno())
        if entry.job is not None:
            entry.job.state = "running"
            self._changed(entry, now=True)

    def _heard(self, worker: Worker, message: tuple[Any, ...]) -> None:
        entry = self._at_work.get(worker)
        if entry is None:  # it is ready
            return
        match message:
            case ("progress", float(fraction), str(doing)) if entry.job:
                entry.job.fraction, entry.job.doing = fraction, doing
                self._changed(entry)
            case ("note", str(text)) if entry.job:
                entry.job.notes.append(text)
                self._changed(entry)
            case ("said", said) if entry.task.hear is not None:
                entry.task.hear(said)
            case ("motion", channels, every_s, end_s, geometry) if entry.file is not None:
                entry.geometry = geometry
                entry.motion = SpooledMotion(entry.file, channels, every_s, end_s)
                entry.opened.set()
            case ("edge", rows, end_s, final) if entry.motion is not None:
                entry.motion.grow(rows, end_s, final=final)
            case ("done" | "failed" | "cancelled" as how, value, used):
                self._finish(entry, how, value)
                self._free(worker, used)

    def _free(self, worker: Worker, used: int) -> None:
        """Let a worker wait for its next task; a large one, or a third one, is not kept."""
        del self._at_work[worker]
        waits = bool(self._waiting or self._questions)
        if used > _LARGE or (len(self._idle) >= _SPARE and not waits) or self._ended:
            worker.leave()
        else:
            self._idle.append(worker)
        self._begin()

    def _gone(self, worker: Worker) -> None:
        if worker in self._idle:
            self._idle.remove(worker)
        entry = self._at_work.pop(worker, None)
        if entry is not None:
            self._tidy(entry.task.folder)
            how = "failed" if entry.wanted else "cancelled"
            self._finish(entry, how, worker.why() if entry.wanted else None)
        if worker.process.returncode == 0 or entry is not None:
            self._begin()  # one that dies while it starts would die again and again

    # How it ends.

    def _cancel(self, entry: Entry) -> None:
        if entry.end.done():
            return
        entry.wanted = False
        for queue in (self._waiting, self._questions):
            if entry in queue:
                queue.remove(entry)
                self._finish(entry, "cancelled", None)
                return
        worker = entry.worker
        if worker is None:
            return
        worker.cancel()
        loop = asyncio.get_running_loop()
        loop.call_later(CANCEL_S, lambda: None if entry.end.done() else worker.kill())

    def _finish(self, entry: Entry, how: str, value: Any) -> None:
        if entry.end.done():
            return
        error = value
        if how == "failed":
            error = {"text": str(value)} if not isinstance(value, dict) else value
            error = complaint(value) if isinstance(value, ArclessError) else error
        if entry.motion is not None:
            entry.motion.final = True
        elif entry.file is not None:
            entry.file.close()
        entry.opened.set()
        if entry.job is not None:
            self._finish_job(entry, entry.job, how, value, error)
        match how:
            case "done":
                entry.end.set_result(value)
            case "failed" if isinstance(value, ArclessError):
                entry.end.set_exception(value)
            case "failed":
                entry.end.set_exception(Refused(500, error["text"]))
            case _:
                entry.end.cancel()

    def _finish_job(self, entry: Entry, job: Job, how: str, value: Any, error: Any) -> None:
        if how == "done":
            job.state, job.fraction, job.doing, job.outcome = "done", 1.0, "", value
        elif how == "failed":
            job.state, job.error = "failed", error
        else:
            job.state = "cancelled"
        if how != "done":
            job.path = None
        self._changed(entry, now=True)

    def _tidy(self, folder: Path | None) -> None:
        """Remove what a killed process left in its folder, and the folder if nothing else is in."""
        if folder is None:
            return
        with suppress(OSError):
            hidden_files.sweep(folder)
            folder.rmdir()

    def _changed(self, entry: Entry, *, now: bool = False) -> None:
        """Tell pages of a job, not oftener than they need."""
        job = entry.job
        if job is None or (not now and not entry.is_told):
            return
        wait = entry.told_at + _BETWEEN_S - time.monotonic()
        if not now and wait > 0.0:
            entry.is_told = False
            asyncio.get_running_loop().call_later(wait, self._tell_of, entry)
        else:
            self._tell_of(entry)

    def _tell_of(self, entry: Entry) -> None:
        entry.told_at, entry.is_told = time.monotonic(), True
        assert entry.job is not None
        self._tell({"topic": "job", "job": entry.job.to_dict()})

    def _forget(self) -> None:
        """Forget the oldest jobs that have ended."""
        ended = [name for name, one in self._entries.items() if one.job and one.job.has_ended]
        for name in ended[: max(0, len(ended) - KEPT)]:
            self.forget_motion(name)
            del self._entries[name]

    async def _leave(self) -> None:
        """End all processes; what they had not finished is gone."""
        self._ended = True
        workers = [*self._idle, *self._at_work]
        for worker in workers:
            entry = self._at_work.get(worker)
            if entry is not None:
                entry.wanted = False
            worker.leave()
        deadline = time.monotonic() + LEAVE_S
        while time.monotonic() < deadline and any(w.process.poll() is None for w in workers):
            await asyncio.sleep(0.02)
        for worker in workers:
            if worker.process.poll() is None:
                worker.kill()
                worker.process.wait()
            entry = self._at_work.get(worker)
            if entry is not None:
                self._tidy(entry.task.folder)
        for entry in self._entries.values():
            if entry.motion is not None:
                entry.motion.close()
        for entry in [*self._waiting, *self._questions, *self._at_work.values()]:
            entry.end.cancel()


def _look(end: "asyncio.Future[Any]") -> None:
    """Look at an end that nobody waits for."""
    if not end.cancelled():
        end.exception()
