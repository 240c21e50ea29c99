"""Routes of the folder: what is in it, and texts of its files."""

from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.routing import BaseRoute

from arcless.studio.answers.answers import json_body, route
from arcless.studio.project import texts, view
from arcless.studio.project.project import Project


def routes(project: Project) -> list[BaseRoute]:
    """Return the routes of a project."""

    async def read_project(_: Request) -> Any:
        return await run_sync(view.view, project)

    async def read_file(request: Request) -> Any:
        return await run_sync(texts.read, project, request.query_params.get("path", ""))

    async def write_file(request: Request) -> Any:
        asked = await json_body(request)
        return await run_sync(
            texts.write, project, asked.get("path"), asked.get("text"), asked.get("version")
        )

    return [
        route("project", read_project),
        route("file", read_file),
        route("file", write_file, "PUT"),
    ]
