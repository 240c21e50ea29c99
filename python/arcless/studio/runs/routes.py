"""Routes of jobs and runs."""

from pathlib import Path
from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.responses import FileResponse
from starlette.routing import BaseRoute

from arcless.results.kept_runs.places import REPORT_NAME, RESULT_NAME
from arcless.studio.answers.answers import Refused, json_body, route
from arcless.studio.jobs.job import Job, Task
from arcless.studio.jobs.jobs import Jobs
from arcless.studio.project.project import Project
from arcless.studio.runs import run
from arcless.studio.runs.order import Order, order_of
from arcless.studio.runs.places import run_of
from arcless.studio.runs.standing import is_current

# A report has its script inside and needs nothing else: it runs in a place of its own, from which
# nothing of the studio can be asked.
REPORT_POLICY = (
    "sandbox allow-scripts allow-popups allow-downloads; default-src 'none'; "
    "script-src 'unsafe-inline' 'unsafe-eval' blob:; style-src 'unsafe-inline'; "
    "img-src data: blob:; font-src data:; worker-src blob:; frame-ancestors 'self'"
)


def routes(project: Project, jobs: Jobs) -> list[BaseRoute]:
    """Return the routes of jobs and of runs."""
    asked = _Asked(project, jobs)
    return [
        route("runs", asked.begin, "POST"),
        route("jobs", asked.listing),
        route("jobs/{id}/cancel", asked.cancel, "POST"),
        route("run", asked.told),
        route("run/line", asked.line),
        route("run/current", asked.current, "POST"),
        route("run/report", asked.report),
        route("run/report", asked.write_report, "POST"),
    ]


class _Asked:
    def __init__(self, project: Project, jobs: Jobs) -> None:
        self._project, self._jobs = project, jobs

    async def begin(self, request: Request) -> Any:
        body = await json_body(request)
        order = await run_sync(order_of, self._project, body)
        return {"job": start(self._project, self._jobs, order).to_dict()}

    async def listing(self, _: Request) -> Any:
        return self._jobs.listing()

    async def cancel(self, request: Request) -> Any:
        return self._jobs.cancel(request.path_params["id"])

    async def told(self, request: Request) -> Any:
        file = await run_sync(run_of, self._project, request.query_params.get("path"))
        report = file.with_name(REPORT_NAME)
        found = await self._jobs.compute(run.told, file)
        return found | {
            "path": self._project.name_of(_named(file)),
            "report": file.name == RESULT_NAME and report.is_file(),
        }

    async def line(self, request: Request) -> Any:
        name = request.query_params.get("job")
        if name is not None:
            entry = self._jobs.entry(name)
            await entry.opened.wait()
            if entry.motion is not None:
                return entry.motion.geometry
            return await self._jobs.compute(run.line, await run_sync(self._done, entry.job))
        file = await run_sync(run_of, self._project, request.query_params.get("path"))
        return await self._jobs.compute(run.line, file)

    async def current(self, request: Request) -> Any:
        body = await json_body(request)
        return {"current": await run_sync(is_current, self._project, body)}

    def _done(self, job: Job | None) -> Path:
        """Return the result of a job that has ended."""
        if job is None or job.kind != "run" or job.state != "done":
            raise Refused(404, "nothing of this job moves")
        return run_of(self._project, job.path)

    async def report(self, request: Request) -> Any:
        file = await run_sync(run_of, self._project, request.query_params.get("path"))
        page = self._project.inside(self._project.name_of(file.with_name(REPORT_NAME)))
        if file.name != RESULT_NAME or not page.is_file():
            raise Refused(404, "this run has no report yet")
        return FileResponse(
            page, media_type="text/html", headers={"Content-Security-Policy": REPORT_POLICY}
        )

    async def write_report(self, request: Request) -> Any:
        body = await json_body(request)
        file = await run_sync(run_of, self._project, body.get("path"))
        to = file.with_suffix(".pdf") if body.get("pdf") is True else file.with_suffix(".html")
        if file.name == RESULT_NAME:
            to = to.with_stem(Path(REPORT_NAME).stem)
        path = self._project.name_of(to)
        self._project.inside(path)  # a link that is there already could lead out
        task = Task(run.write_report, (file, to))
        job = self._jobs.start("report", f"Report of {_named(file).name}", task, path=path)
        return {"job": job.to_dict()}


def start(project: Project, jobs: Jobs, order: Order) -> Job:
    """Begin a run that was ordered.

    Raises
    ------
    Refused
        Another one writes into its folder.
    """
    task = Task(run.run, (order,), folder=order.folder, shows=True)
    return jobs.start("run", order.folder.name, task, path=project.name_of(order.folder))


def _named(file: Path) -> Path:
    return file.parent if file.name == RESULT_NAME else file
