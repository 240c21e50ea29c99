"""A job, or a question that is not listed, with all that belongs to it on the server."""

import asyncio
from typing import Any, BinaryIO

from arcless.studio.jobs.job import Job, Task
from arcless.studio.motion.spool import SpooledMotion
from arcless.studio.processes.worker import Worker


class Entry:
    """A task, the process that does it, and the page's view of it.

    Attributes
    ----------
    task, job
        The task; the job as pages see it, None of a question.
    end
        Result of the task, or its error; cancelled where it was cancelled.
    worker
        Process that does it; None before.
    motion
        Motion that it spools; None before its first row.
    opened
        Set when motion is there, or will never be.
    """

    def __init__(self, task: Task, job: Job | None) -> None:
        self.task, self.job = task, job
        self.end: asyncio.Future[Any] = asyncio.get_running_loop().create_future()
        self.worker: Worker | None = None
        self.motion: SpooledMotion | None = None
        self.opened = asyncio.Event()
        self.told_at, self.is_told = 0.0, True
        self._file: BinaryIO | None = None

    def give_spool(self, file: BinaryIO | None) -> None:
        """Have its motion written to a file; None: it will show none."""
        self._file = file
        if file is None:
            self.opened.set()

    def begin_motion(
        self, layout: Any, geometry: Any, every_s: float, end_s: float, search: int | None
    ) -> None:
        """Have motion from now on; what was there before is replaced."""
        if self._file is None:
            return
        before = self.motion
        self.motion = SpooledMotion(
            self._file, layout, geometry, every_s=every_s, estimated_end_s=end_s, search=search
        )
        if before is not None:
            before.replace(self.motion)
        self.opened.set()

    def end_motion(self) -> None:
        """Say that no more rows come."""
        if self.motion is not None:
            self.motion.final = True
        elif self._file is not None:
            self._file.close()
        self.opened.set()

    def forget_motion(self) -> None:
        """Give the disk of its motion back."""
        if self.motion is not None:
            self.motion.close()
            self.motion = None
