"""Routes of series, figures, comparison and explanation."""

from functools import partial
from pathlib import Path
from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute

from arcless.assess.rules import ANY_SUPPLY
from arcless.errors import ArclessError, ExplanationError
from arcless.measurements import is_measured
from arcless.storage import hidden_files
from arcless.studio.answers.answers import Refused, complaint, json_body, route
from arcless.studio.charts import asked, assessed, series, space_time
from arcless.studio.charts.charted_run import ChartedRun
from arcless.studio.charts.comparing import ChartedComparison, checked, measured_of, names_of
from arcless.studio.charts.kept import Kept
from arcless.studio.charts.measured_as import assessed_alone, measured_as
from arcless.studio.charts.plain.drawable import drawable
from arcless.studio.project.project import Project

# Endings of files that a run is exported to, and their types in an answer.
_TYPES = {
    "csv": "text/csv; charset=utf-8",
    "mat": "application/octet-stream",
    "parquet": "application/octet-stream",
    "pdf": "application/pdf",
    "xlsx": "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
}


def routes(project: Project) -> list[BaseRoute]:
    """Return the routes of charts; runs and comparisons stay in memory for further questions."""
    return [
        *_of_runs(project, Kept(ChartedRun)),
        *_of_comparisons(project, Kept(ChartedComparison)),
    ]


def _of_runs(project: Project, kept: Kept[ChartedRun]) -> list[BaseRoute]:
    def of(request: Request) -> ChartedRun:
        return kept.of(asked.result_file(project, request.query_params.get("run", "")))

    async def read_series(request: Request) -> Any:
        return await run_sync(lambda: series.answer(of(request), request))

    async def read_figures(request: Request) -> Any:
        return await run_sync(lambda: assessed.sections(of(request)))

    async def read_figure(request: Request) -> Any:
        def found() -> Any:
            run = of(request)
            figure = run.figure(request.query_params.get("key", ""))
            return drawable(figure, asked.shown(request.query_params), run.pyramid)

        return await run_sync(found)

    async def read_assessed(request: Request) -> Any:
        return await run_sync(lambda: assessed.assessed(of(request)))

    async def explain(request: Request) -> Any:
        def found() -> Any:
            run = of(request)
            with run.lock:
                try:
                    return assessed.explained(run)
                except ExplanationError as error:  # nothing is wrong with the question
                    return {"refused": complaint(error), "pantographs": []}

        return await run_sync(found)

    async def read_space_time(request: Request) -> Any:
        return await run_sync(lambda: space_time.answer(of(request), request.query_params))

    async def export(request: Request) -> Any:
        return await run_sync(lambda: _exported(of(request), request.query_params.get("as", "")))

    return [
        route("series", read_series),
        route("figures", read_figures),
        route("figure", read_figure),
        route("assessed", read_assessed),
        route("explain", explain),
        route("space_time", read_space_time),
        route("export", export),
    ]


def _of_comparisons(project: Project, kept: Kept[ChartedComparison]) -> list[BaseRoute]:
    def place(path: str) -> Path:
        whole = project.inside(path)
        return asked.result_file(project, path) if whole.is_dir() else whole

    def compared(question: dict[str, Any]) -> Any:
        files = [place(path) for path in checked(question.get("subjects"))]
        for file, path in zip(files, question["subjects"], strict=True):
            if not file.is_file():
                raise Refused(404, f"There is no {path}")
        names = names_of(question)
        found = kept.of(*files, names=names, measured=measured_of(question, question["subjects"]))
        key = question.get("figure")
        if key is None:
            return found.told()
        shown = asked.shown(question)
        return drawable(found.figure(str(key)), shown, found.pyramid)

    async def compare(request: Request) -> Any:
        return await run_sync(partial(compared, await json_body(request)))

    def alone(question: dict[str, Any]) -> Any:
        path, how = question.get("path"), measured_as(question.get("as", {}))
        file = project.inside(path if isinstance(path, str) else "")
        if not (is_measured(file) and file.is_file()):
            raise Refused(404, f"There is no measurement {path}")
        try:
            return assessed_alone(file, how)
        except ArclessError as error:  # the page has a form for what is missing
            return {"refused": complaint(error), "supplies": list(ANY_SUPPLY)}

    async def measurement(request: Request) -> Any:
        return await run_sync(partial(alone, await json_body(request)))

    return [route("compare", compare, "POST"), route("measurement", measurement, "POST")]


def _exported(run: ChartedRun, ending: str) -> Response:
    """Return a run as a file of another program, or its report on paper."""
    if ending not in _TYPES:
        raise Refused(400, f"`as` is none of {', '.join(_TYPES)}")
    name = run.result.scenario.name
    with hidden_files.temporary_folder() as folder:
        file = folder / f"run.{ending}"
        if ending == "pdf":
            run.result.write_pdf(file)
        else:
            run.result.export(file)
        content = file.read_bytes()
    safe = "".join(letter if letter.isascii() and letter.isalnum() else "-" for letter in name)
    attachment = f'attachment; filename="{safe}.{ending}"'
    return Response(content, media_type=_TYPES[ending], headers={"Content-Disposition": attachment})
