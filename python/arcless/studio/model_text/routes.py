"""Routes of the editor: what is wrong with a text, its fields, and changes of one field."""

from pathlib import Path
from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.routing import BaseRoute

from arcless.model import edit
from arcless.studio.answers.answers import Refused, json_body, route
from arcless.studio.model_text import check, form
from arcless.studio.project import texts
from arcless.studio.project.project import Project, is_shipped
from arcless.study import json_schema


def routes(project: Project) -> list[BaseRoute]:
    """Return the routes of texts of a project."""

    async def check_text(request: Request) -> Any:
        text, label, file, within = await _asked(project, request)
        return await run_sync(check.check, text, label, file, within)

    async def form_of(request: Request) -> Any:
        text, label, _, _ = await _asked(project, request)
        return await run_sync(form.form, text, label)

    async def patch(request: Request) -> Any:
        text, label, _, _ = await _asked(project, request)
        changes = (await json_body(request)).get("changes")
        if not isinstance(changes, dict):
            raise Refused(400, "The changes are not a JSON object")
        return {"text": await run_sync(patched, text, changes, label)}

    async def schema(_: Request) -> Any:
        return await run_sync(json_schema)

    return [
        route("check", check_text, "POST"),
        route("form", form_of, "POST"),
        route("patch", patch, "POST"),
        route("schema", schema),
    ]


def patched(text: str, changes: dict[str, Any], label: str) -> str:
    """Return a text with changed fields; None as a value takes a field away.

    Raises
    ------
    ModelError
        A change cannot be done in place.
    """
    for field, value in changes.items():
        change = (
            edit.remove(text, field, label)
            if value is None
            else edit.change(text, field, value, label)
        )
        text = change.apply(text)
    return text


async def _asked(project: Project, request: Request) -> tuple[str, str, Path, Path]:
    """Return text, path in the project, file, and the folder that references stay in."""
    asked = await json_body(request)
    path, text = asked.get("path"), asked.get("text")
    if not isinstance(path, str) or not isinstance(text, str):
        raise Refused(400, "The question has no path or no text")
    file = texts.model_file(project, path)
    return text, path, file, file.resolve().parent if is_shipped(path) else project.folder
