"""Routes of studies."""

from collections.abc import Callable
from typing import Any

from anyio import CapacityLimiter, Lock
from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute

from arcless.studio.answers.answers import Refused, json_body, route
from arcless.studio.project.project import Project
from arcless.studio.runs.routes import REPORT_POLICY
from arcless.studio.studies.computing import Computing
from arcless.studio.studies.desk import Desk
from arcless.studio.studies.kept_rows import MOST_ROWS

# Digits of a whole number in a question: more than any study has variants.
_DIGITS = 9


def routes(project: Project, computing: Computing) -> list[BaseRoute]:
    """Return the routes of a project's studies."""
    desk, turn, own = Desk(project, computing), Lock(), CapacityLimiter(1)

    async def work(act: Callable[[], Any]) -> Any:
        # Rows that are kept are for one thread at a time.
        async with turn:
            return await run_sync(act, limiter=own)

    async def fields(request: Request) -> Any:
        asked = await json_body(request)
        return await run_sync(desk.fields, _text(asked, "scenario"))

    async def text(request: Request) -> Any:
        asked = await json_body(request)
        given = asked.get("definition")
        if not isinstance(given, dict):
            raise Refused(400, "A definition is expected")
        return await run_sync(desk.text, _text(asked, "path"), given)

    async def run(request: Request) -> Any:
        asked = await json_body(request)
        path = _text(asked, "path")
        resume, retry = asked.get("resume") is True, asked.get("retry_failed") is True
        return await work(lambda: desk.run(path, resume=resume, retry_failed=retry))

    async def stop(request: Request) -> Any:
        asked = await json_body(request)
        return await work(lambda: desk.stop(_text(asked, "path")))

    async def about(request: Request) -> Any:
        return await work(lambda: desk.about(request.query_params.get("path", "")))

    async def rows(request: Request) -> Any:
        asked = request.query_params
        after, most = _whole(asked.get("after", "0")), _whole(asked.get("most", str(MOST_ROWS)))
        path, edition = asked.get("path", ""), asked.get("edition", "")
        return await work(lambda: desk.rows(path, after, edition, most))

    async def scenario(request: Request) -> Any:
        asked = await json_body(request)
        path, name = _text(asked, "path"), _text(asked, "name")
        number = _whole(str(asked.get("variant", "")))
        return await work(lambda: desk.scenario(path, number, name))

    async def report(request: Request) -> Any:
        content = await work(lambda: desk.report(request.query_params.get("path", "")))
        headers = {"Content-Security-Policy": REPORT_POLICY}
        return Response(content, media_type="text/html; charset=utf-8", headers=headers)

    return [
        route("studies/fields", fields, "POST"),
        route("studies/text", text, "POST"),
        route("studies/run", run, "POST"),
        route("studies/stop", stop, "POST"),
        route("studies/definition", about),
        route("studies/rows", rows),
        route("studies/scenario", scenario, "POST"),
        route("studies/report", report),
    ]


def _text(asked: dict[str, Any], name: str) -> str:
    value = asked.get(name)
    if not isinstance(value, str) or not value:
        raise Refused(400, f"`{name}` is expected, a text")
    return value


def _whole(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) <= _DIGITS):
        raise Refused(400, "A whole number is expected")
    return int(text)
