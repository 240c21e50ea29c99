"""Routes of the editor: mistakes in a text, its fields, changes of one, a copy to begin with."""

import json
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.routing import BaseRoute

from arcless.errors import ArclessError, ModelError
from arcless.model import Scenario, edit
from arcless.model.files.yaml_reader import parse
from arcless.model.load import load_text
from arcless.model.own_copy import copies, write_copies
from arcless.model.variants.variant_files import is_variant
from arcless.studio.answers.answers import Refused, json_body, route
from arcless.studio.model_text import check, form
from arcless.studio.project import texts
from arcless.studio.project.kinds import kind_of
from arcless.studio.project.project import Project, is_shipped
from arcless.study import json_schema
from arcless.units import show


def routes(project: Project) -> list[BaseRoute]:
    """Return the routes of texts of a project."""

    async def check_text(request: Request) -> Any:
        text, label, file, within = await _asked(project, request)
        return await run_sync(check.check, text, label, file, within)

    async def form_of(request: Request) -> Any:
        text, label, file, within = await _asked(project, request)
        return await run_sync(_form, text, label, file, within)

    async def patch(request: Request) -> Any:
        text, label, _, _ = await _asked(project, request)
        changes = (await json_body(request)).get("changes")
        if not isinstance(changes, dict):
            raise Refused(400, "The changes are not a JSON object")
        return {"text": await run_sync(patched, text, changes, label)}

    async def schema(_: Request) -> Any:
        return await run_sync(_schema)

    async def new(request: Request) -> Any:
        asked = await json_body(request)
        name, source = asked.get("name"), asked.get("from")
        if not isinstance(name, str) or not isinstance(source, str):
            raise Refused(400, "A new model needs a name, and the model to begin with")
        whole, spacing = asked.get("with_pantographs") is True, asked.get("two_pantographs")
        if spacing is not None and not isinstance(spacing, str):
            raise Refused(400, "The spacing of two pantographs is a text, such as tsi or 85 m")
        return {"path": await run_sync(begun, project, name, source, whole, spacing)}

    return [
        route("new", new, "POST"),
        route("check", check_text, "POST"),
        route("form", form_of, "POST"),
        route("patch", patch, "POST"),
        route("schema", schema),
    ]


@cache
def _schema() -> dict[str, Any]:
    return json_schema()


def begun(
    project: Project,
    name: str,
    source: str,
    with_pantographs: bool,
    two_pantographs: str | None = None,
) -> str:
    """Begin a model in the folder as `arcless new` does, and return its path there.

    Raises
    ------
    ArclessError
        There is no such shipped model, or a file of the name is there.
    """
    if not is_shipped(source):
        raise ModelError("no model to begin with", got=show(source), expected="shipped:KIND/NAME")
    given = source.removeprefix("shipped:")
    files = copies(name, given, with_pantographs=with_pantographs, two_pantographs=two_pantographs)
    write_copies(project.folder, files, json.dumps(json_schema(), indent=2) + "\n")
    return f"{name}.yaml"


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


def _form(text: str, label: str, file: Path, within: Path) -> dict[str, Any]:
    scenario = None
    with suppress(ArclessError):  # the check says what is wrong
        data, _ = parse(text, label)
        if kind_of(text) == "scenario" and is_variant(data):
            loaded = load_text(text, file, within)
            scenario = loaded if isinstance(loaded, Scenario) else None
    return form.form(text, label, scenario)


async def _asked(project: Project, request: Request) -> tuple[str, str, Path, Path]:
    """Return text, path in the project, file, and the folder that references stay in."""
    asked = await json_body(request)
    path, text = asked.get("path"), asked.get("text")
    if not isinstance(path, str) or not isinstance(text, str):
        raise Refused(400, "The question has no path or no text")
    file = texts.model_file(project, path)
    return text, path, file, file.resolve().parent if is_shipped(path) else project.folder
