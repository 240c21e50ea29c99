"""Motion of runs and jobs, opened for pages that play it."""

from collections import OrderedDict
from pathlib import Path

from anyio.to_thread import run_sync

from arcless.studio.answers.answers import Refused
from arcless.studio.jobs.job import Task
from arcless.studio.jobs.jobs import Jobs
from arcless.studio.motion.channels import MotionSource, moves_wires
from arcless.studio.motion.recorded import Recorded, recorded
from arcless.studio.project.project import Project
from arcless.studio.runs import run
from arcless.studio.runs.places import run_of
from arcless.studio.stream.sources import Name

# Stored runs that are kept open. With fewer, going back to a run reads its file again, which takes
# a second of 50 km; with more, files that nobody looks at take memory.
KEPT_OPEN = 4


class Motions:
    """Opens motion by what a page names."""

    def __init__(self, project: Project, jobs: Jobs) -> None:
        self._project, self._jobs = project, jobs
        self._open: OrderedDict[tuple[Path, run.Identity], Recorded] = OrderedDict()

    async def open(self, name: Name) -> MotionSource:
        """Return the motion of a run, or of a job as soon as it has any.

        Raises
        ------
        ArclessError, Refused
            There is none.
        """
        kind, what = name
        if kind == "run":
            return await self._of_run(what)
        entry = self._jobs.entry(what)
        await entry.opened.wait()
        if entry.motion is not None:
            return entry.motion
        job = entry.job
        if job is None or job.kind != "run" or job.state != "done" or job.path is None:
            raise Refused(404, "nothing of this job moves")
        return await self._of_run(job.path)

    def compute(self, name: Name) -> str:
        """Begin to compute the motion of a run that has none; return the name of the job.

        Raises
        ------
        ArclessError, Refused
            There is no such run.
        """
        kind, path = name
        if kind != "run":
            raise Refused(400, "motion is computed of a run")
        file = run_of(self._project, path)
        known = self._computed(path, run.identity_of(file), ended=False)
        if known is not None:
            return known
        title = f"Motion of {Path(path).name}"
        identity = run.identity_of(file)
        task = Task(run.motion, (file,), shows=True, about=(path, identity))
        job = self._jobs.start("motion", title, task)
        end = self._jobs.entry(job.id).end
        end.add_done_callback(lambda _: self._replace(file, identity, job.id))
        return job.id

    async def _of_run(self, path: str) -> MotionSource:
        file = await run_sync(run_of, self._project, path)
        identity = run.identity_of(file)
        known = self._open.pop((file, identity), None)
        found = await run_sync(recorded, file) if known is None else known
        self._open[file, identity] = found
        while len(self._open) > KEPT_OPEN:
            self._open.popitem(last=False)
        if not moves_wires(found):
            name = self._computed(path, identity, ended=True)
            spooled = None if name is None else self._jobs.entry(name).motion
            return spooled or found
        return found

    def _computed(self, path: str, identity: run.Identity, *, ended: bool) -> str | None:
        """Return the job that computed this very run, or its motion, and still has it."""
        for name, entry in self._jobs.with_motion():
            job = entry.job
            if job is None or (ended and job.state != "done"):
                continue
            own = entry.task.about == (path, identity)
            if own or (job.path == path and _identity_in(job.outcome) == identity):
                return name
        return None

    def _replace(self, file: Path, identity: run.Identity, name: str) -> None:
        """Have pages that play a run see its wires move, once that is computed."""
        entry = self._jobs.entry(name)
        played = self._open.get((file, identity))
        done = entry.job is not None and entry.job.state == "done"
        if done and entry.motion is not None and played is not None:
            played.later = entry.motion


def _identity_in(outcome: object) -> object:
    return outcome.get("identity") if isinstance(outcome, dict) else None
