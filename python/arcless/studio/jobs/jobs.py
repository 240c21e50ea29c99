"""Jobs of a server: as many at once as there are processors, the rest waits its turn."""

import asyncio
import itertools
import secrets
import time
from collections import deque
from collections.abc import AsyncIterator, Callable
from concurrent.futures import Future
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any

from arcless.platforms.processors import processors
from arcless.storage import hidden_files
from arcless.studio.answers.answers import Refused, complaint
from arcless.studio.jobs.entry import Entry
from arcless.studio.jobs.job import Job, Kind, Task
from arcless.studio.jobs.pool import Pool
from arcless.studio.processes.ends import Cancelled, Gone

# Jobs that are kept in the list when they have ended, and those that may wait. More would make
# the list long; less forgets what the user has not seen yet.
KEPT, MOST_WAITING = 100, 1000
# Motions of ended jobs that are kept, and the bytes of all of them on the disk: the oldest go.
MOTIONS, MOTION_BYTES = 8, 8 << 30
# Time in s between two messages of one job.
BETWEEN_S = 0.05
# Time in s that a job has to end by itself when it is cancelled; then its process is killed. A
# line at rest of some km is found in native code that nobody can interrupt.
CANCEL_S = 0.7
# Time in s after which another process is made ready. Longer, a second run at once waits for its
# process to start; shorter, one is started for each run of a second.
READY_AFTER_S = 0.5
# Processes for questions that are answered at once, besides those of jobs.
_FOR_QUESTIONS = 2


class Jobs:
    """All jobs of a server. Everything is called on the event loop.

    Parameters
    ----------
    tell
        Takes messages for all pages.
    most
        Jobs at once; the number of processors without.
    """

    def __init__(self, tell: Callable[[dict[str, Any]], None], most: int | None = None) -> None:
        self._tell = tell
        self._most = most or processors()
        self._entries: dict[str, Entry] = {}
        self._waiting: deque[Entry] = deque()
        self._questions: deque[Entry] = deque()
        self._pool = Pool(self._heard, self._over)
        self._has_ended = False
        self._number = itertools.count(1)
        self._server = secrets.token_hex(3)  # jobs of an older server are other ones

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Have a process ready until the server ends; leave none behind."""
        self._pool.prepare()
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
        for other in self._jobs():
            if path is not None and other.path == path and not other.has_ended:
                raise Refused(409, f"{path} is being computed already", job=other.to_dict())
        job = Job(f"{self._server}-{next(self._number)}", kind, title, path=path)
        entry = Entry(task, job)
        entry.end.add_done_callback(_look)
        self._entries[job.id] = entry
        self._waiting.append(entry)
        self._forget()
        self._changed(entry, now=True)
        self._begin()
        return job

    async def compute(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Return what a function returns, computed in a worker process; not listed as a job.

        It is called as functions of jobs are, with a `Talk` first, and cancelled where nobody
        waits any more.

        Raises
        ------
        ArclessError
            That of the function.
        Refused
            The process failed.
        """
        entry = Entry(Task(function, arguments), None)
        entry.end.add_done_callback(_look)
        self._questions.append(entry)
        self._begin()
        try:
            return await asyncio.shield(entry.end)
        except asyncio.CancelledError:
            self._cancel(entry)
            raise

    def listing(self) -> list[dict[str, Any]]:
        """Return all jobs as plain values, the oldest first."""
        return [job.to_dict() for job in self._jobs()]

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

    def with_motion(self) -> list[tuple[str, Entry]]:
        """Return the jobs that have motion or will have some, the newest first."""
        found = reversed(self._entries.items())
        return [(name, one) for name, one in found if one.motion or _will_show(one)]

    def cancel(self, name: str) -> dict[str, Any]:
        """End a job within a second; one that has ended stays as it is."""
        entry = self.entry(name)
        self._cancel(entry)
        assert entry.job is not None
        return entry.job.to_dict()

    def _jobs(self) -> list[Job]:
        return [entry.job for entry in self._entries.values() if entry.job is not None]

    def _begin(self) -> None:
        """Begin what may begin, and have a process ready for what comes next."""
        if self._has_ended:
            return
        while self._waiting and self._pool.busy(jobs=True) < self._most:
            entry = self._waiting.popleft()
            assert entry.job is not None
            entry.job.state = "running"
            self._pool.assign(entry)
            self._changed(entry, now=True)
        while self._questions and self._pool.busy(jobs=False) < _FOR_QUESTIONS:
            self._pool.assign(self._questions.popleft())
        # Later: a start takes some ms of the event loop and a second of a processor, which what has
        # just begun may need itself; and soon its own process may be free again.
        asyncio.get_running_loop().call_later(READY_AFTER_S, self._prepare)

    def _prepare(self) -> None:
        if not self._has_ended:
            self._pool.prepare()

    def _heard(self, entry: Entry, message: tuple[Any, ...]) -> None:
        match message:
            case ("progress", float(fraction), str(doing)) if entry.job:
                entry.job.fraction, entry.job.doing = fraction, doing
                self._changed(entry)
            case ("note", str(text)) if entry.job:
                entry.job.notes.append(text)
                self._changed(entry)
            case ("motion", *about):
                entry.begin_motion(*about)
            case ("edge", rows, end_s, final) if entry.motion is not None:
                entry.motion.grow(rows, end_s, final=final)

    def _over(self, entry: Entry, end: "Future[Any]") -> None:
        error = end.exception()
        if isinstance(error, Gone | Cancelled):
            _tidy(entry.task.folder)
        if error is None:
            self._finish(entry, "done", end.result())
        elif isinstance(error, Cancelled):
            self._finish(entry, "cancelled", None)
        else:
            self._finish(entry, "failed", error)
        self._begin()

    def _cancel(self, entry: Entry) -> None:
        if entry.end.done():
            return
        for queue in (self._waiting, self._questions):
            if entry in queue:
                queue.remove(entry)
                self._finish(entry, "cancelled", None)
                return
        if entry.worker is not None:
            entry.worker.cancel(CANCEL_S)

    def _finish(self, entry: Entry, how: str, value: Any) -> None:
        if entry.end.done():
            return
        entry.end_motion()
        if entry.job is not None:
            _finish_job(entry.job, how, complaint(value) if how == "failed" else value)
            self._changed(entry, now=True)
        if how == "done":
            entry.end.set_result(value)
        elif how == "cancelled":
            entry.end.cancel()
        else:
            entry.end.set_exception(value)

    def _changed(self, entry: Entry, *, now: bool = False) -> None:
        """Tell pages of a job, not oftener than they need."""
        if entry.job is None or (not now and not entry.is_told):
            return
        wait = entry.told_at + BETWEEN_S - time.monotonic()
        if not now and wait > 0.0:
            entry.is_told = False
            asyncio.get_running_loop().call_later(wait, self._tell_of, entry, entry.job)
        else:
            self._tell_of(entry, entry.job)

    def _tell_of(self, entry: Entry, job: Job) -> None:
        entry.told_at, entry.is_told = time.monotonic(), True
        self._tell({"topic": "job", "job": job.to_dict()})

    def _forget(self) -> None:
        """Forget the oldest jobs that have ended, and the oldest motions before that."""
        ended = [name for name, one in self._entries.items() if one.job and one.job.has_ended]
        for name in ended[: max(0, len(ended) - KEPT)]:
            self._entries.pop(name).forget_motion()
        room, count = MOTION_BYTES, MOTIONS
        for _, entry in self.with_motion():
            room, count = room - (entry.motion.size if entry.motion else 0), count - 1
            if entry.job and entry.job.has_ended and (room < 0 or count < 0):
                entry.forget_motion()

    async def _leave(self) -> None:
        """End all processes; what they had not finished is gone."""
        self._has_ended = True
        for entry in [*self._waiting, *self._questions]:
            entry.end.cancel()
        ends = [entry.end for entry in self._pool.leave()]
        if ends:
            await asyncio.wait(ends)
        for entry in self._entries.values():
            entry.forget_motion()


def _will_show(entry: Entry) -> bool:
    return entry.task.shows and not entry.end.done()


def _finish_job(job: Job, how: str, value: Any) -> None:
    if how == "done":
        job.state, job.fraction, job.doing, job.outcome = "done", 1.0, "", value
        return
    job.path = None
    if how == "failed":
        job.state, job.error = "failed", value
    else:
        job.state = "cancelled"


def _tidy(folder: Path | None) -> None:
    """Remove what a killed process left in its folder, and the folder if nothing else is in."""
    if folder is not None:
        with suppress(OSError):
            hidden_files.sweep(folder)
            folder.rmdir()


def _look(end: "asyncio.Future[Any]") -> None:
    """Look at an end that nobody waits for."""
    if not end.cancelled():
        end.exception()
