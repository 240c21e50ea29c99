"""The folder at a glance: models, runs, studies, measured data, and the shipped library."""

import os
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError
from arcless.model.files.yaml_reader import parse, read_text
from arcless.model.shipped.library import library
from arcless.results.kept_runs.search import search
from arcless.studio.project.kinds import kind_of
from arcless.studio.project.project import Project
from arcless.studio.project.texts import ENDINGS


def view(project: Project) -> dict[str, Any]:
    """Return what the page shows of a project; see `ProjectView` there."""
    found = search(project.folder)
    return {
        "name": project.folder.name,
        "folder": str(project.folder),
        "version": version("arcless"),
        "models": _models(project, found.studies),
        "library": _library(),
        "runs": [one.to_dict() | {"path": project.name_of(one.path)} for one in found.runs],
        "studies": [],
        "measured": [],
    }


@cache
def _library() -> list[dict[str, Any]]:
    return [
        {"path": f"shipped:{one.kind}/{one.name}", "kind": one.kind, "name": one.name,
         "description": one.title}
        for one in library() if one.kind != "wire"
    ]  # fmt: skip


def _models(project: Project, studies: list[Path]) -> list[dict[str, Any]]:
    entries = []
    for name, folders, files in os.walk(project.folder):
        folders[:] = sorted(
            one for one in folders
            if not one.startswith(".") and Path(name, one) not in studies and one != "runs"
        )  # fmt: skip
        for file in sorted(files):
            path = Path(name, file)
            if path.suffix.lower() in ENDINGS and not file.startswith("."):
                entry = _model(project, path)
                entries += [] if entry is None else [entry]
    return entries


def _model(project: Project, file: Path) -> dict[str, Any] | None:
    label = project.name_of(file)
    known = {"path": label, "name": file.stem, "description": ""}
    try:
        text = read_text(file, label)
        kind = kind_of(text)
        if kind is None:
            return None
        known["kind"] = kind
        data, _ = parse(text, label)
    except ArclessError as error:
        return known | {"error": str(error)} if "kind" in known else None
    return known | {"name": str(data.get("name", file.stem)),
                    "description": str(data.get("description") or "")}  # fmt: skip
