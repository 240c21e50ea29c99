"""Routes of the folder: what is in it, texts of its files, variants, measured runs."""

from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.routing import BaseRoute

from arcless.studio.answers.answers import json_body, route
from arcless.studio.project import measured, texts, variants
from arcless.studio.project.view import View


def routes(view: View) -> list[BaseRoute]:
    """Return the routes of a project, of which there is a view."""
    project = view.project

    async def read_project(_: Request) -> Any:
        return await run_sync(view.read)

    async def read_file(request: Request) -> Any:
        return await run_sync(texts.read, project, request.query_params.get("path", ""))

    async def write_file(request: Request) -> Any:
        asked = await json_body(request)
        path, text, before = (asked.get(name) for name in ("path", "text", "version"))
        return await run_sync(texts.write, project, path, text, before)

    async def make_variant(request: Request) -> Any:
        asked = await json_body(request)
        scenario, name, changes = (asked.get(name) for name in ("scenario", "name", "changes"))
        return {"path": await run_sync(variants.make, project, scenario, name, changes)}

    async def keep_measured(request: Request) -> Any:
        name = request.query_params.get("name", "")
        return {"path": await measured.keep(project, name, request.stream())}

    return [
        route("project", read_project),
        route("file", read_file),
        route("file", write_file, "PUT"),
        route("variant", make_variant, "POST"),
        route("measured", keep_measured, "POST"),
    ]
