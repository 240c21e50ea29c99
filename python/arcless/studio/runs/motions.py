"""Motion of runs and jobs, opened for who plays it."""

import os
from collections import OrderedDict
from pathlib import Path

from anyio.to_thread import run_sync

from arcless.studio.answers.answers import Refused
from arcless.studio.jobs.jobs import Jobs
from arcless.studio.motion.channels import MotionSource
from arcless.studio.motion.recorded import RecordedMotion
from arcless.studio.project.project import Project
from arcless.studio.runs.routes import run_of
from arcless.studio.stream.sources import Name

# Stored runs that are kept open. With fewer, going back to a run reads its file again, which takes
# a second of 50 km; with more, files that nobody looks at take memory.
KEPT_OPEN = 4
# A file as it was: when it was changed, how large it is, and which one it is on the disk.
Identity = tuple[str, int, int, int]


class Motions:
    """Opens motion by what a page names."""

    def __init__(self, project: Project, jobs: Jobs) -> None:
        self._project, self._jobs = project, jobs
        self._open: OrderedDict[Identity, RecordedMotion] = OrderedDict()

    async def open(self, name: Name) -> MotionSource:
        """Return the motion of a run, or of a job as soon as it has any.

        Raises
        ------
        ArclessError, Refused
            There is none.
        """
        kind, what = name
        if kind == "run":
            return await run_sync(self._stored, what)
        entry = self._jobs.entry(what)
        await entry.opened.wait()
        if entry.motion is not None:
            return entry.motion
        job = entry.job
        if job is None or job.kind != "run" or job.state != "done" or job.path is None:
            raise Refused(404, "nothing of this job moves")
        return await run_sync(self._stored, job.path)

    def _stored(self, path: str) -> MotionSource:
        file = run_of(self._project, path)
        identity = identity_of(file)
        found = self._open.pop(identity, None) or RecordedMotion(file)
        self._open[identity] = found
        while len(self._open) > KEPT_OPEN:
            self._open.popitem(last=False)
        return found


def identity_of(file: Path) -> Identity:
    """Return what tells a file from the one that takes its name later."""
    state = os.stat(file)  # noqa: PTH116 - as short
    return str(file), state.st_mtime_ns, state.st_size, state.st_ino
