"""A row of a study as a scenario file that holds only what differs from the study's scenario."""

import json
import os
from pathlib import Path, PurePosixPath
from typing import Any

from arcless.errors import ArclessError, ModelError
from arcless.model.files.yaml_reader import parse
from arcless.model.load import load_text
from arcless.model.shipped.library import shipped
from arcless.model.variants.variant_files import variant_text
from arcless.studio.project import texts
from arcless.studio.project.project import Project
from arcless.studio.studies.kept_rows import written_scenario
from arcless.study import StudyFolder
from arcless.study.evaluation.variants import scenario, variant
from arcless.study.report.commands import amount_of


def scenario_of(project: Project, place: StudyFolder, number: int, name: str) -> dict[str, str]:
    """Write the scenario of a variant, `base` and `set`; return its path.

    A file that says so already stays.

    Raises
    ------
    ModelError
        The study holds its scenario itself, the file is not found, or it is another one now.
    OutputError
        The name is no file below the folder.
    """
    wanted = scenario(place.study, number)
    path = f"{name}.yaml"
    target = texts.model_file(project, path)
    base = _base(project, place, target.parent)
    text = variant_text(name, base, _changes(place, number))
    _check_same(project, text, target, wanted.to_dict())
    if target.is_file() and texts.read(project, path)["text"] == text:
        return {"path": path}  # opened before
    texts.write(project, path, text, None)
    return {"path": path}


def _changes(place: StudyFolder, number: int) -> dict[str, Any]:
    """Return what a variant sets, as the study file has it where that is the same number."""
    asked = place.study
    made = variant(asked, number)
    named = {axis.field: amount_of(asked, axis, made.values[axis.name]) or made.values[axis.name]
             for axis in asked.axes}  # fmt: skip
    drawn = {axis.field: made.changes[axis.field] for axis in asked.axes if axis.is_drawn}
    changes = {**asked.changes, **named, **drawn}
    return dict(sorted(changes.items(), key=lambda one: one[0].count(".")))


def _base(project: Project, place: StudyFolder, folder: Path) -> str:
    """Return the study's scenario as a file in `folder` names it."""
    named = written_scenario(place.path)
    if named is None:
        raise ModelError(
            "a variant of a scenario that is written in the study itself",
            expected="a study that names its scenario",
            hint="`arcless study variant` writes the whole scenario",
        )
    if named in shipped("scenario"):
        return named
    for file in _study_files(project, place.study.name):
        found = project.inside(str(PurePosixPath(project.name_of(file.parent), named)))
        if found.is_file():
            return Path(os.path.relpath(found, folder)).as_posix()
    raise ModelError(
        "the scenario of the study is not found",
        got=named,
        expected="a file next to the study file",
    )


def _study_files(project: Project, name: str) -> list[Path]:
    found = []
    for file in sorted(project.folder.rglob("*.y*ml")):
        relative = file.relative_to(project.folder).parts
        if "runs" in relative or any(part.startswith(".") for part in relative):
            continue
        try:
            data, _ = parse(file.read_text("utf-8"), file.name)
        except (ArclessError, OSError, ValueError):
            continue
        if str(data.get("format")).startswith("arcless-study/") and data.get("name") == name:
            found.append(file)
    return found


def _check_same(project: Project, text: str, target: Path, wanted: dict[str, Any]) -> None:
    made = load_text(text, target, project.folder).to_dict()
    if _numbers(made) != _numbers(wanted):
        raise ModelError(
            "the scenario of the study was changed since the study was begun",
            expected="the file as it was then",
            hint="`arcless study variant` writes the whole scenario of the variant",
        )


def _numbers(data: Any) -> Any:
    """Return what decides a run: no words."""
    words = ("name", "description", "sources", "provenance")
    kept = {key: value for key, value in data.items() if key not in words}
    return json.loads(json.dumps(kept, default=str), object_hook=_without_words)


def _without_words(part: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in part.items() if key not in ("sources", "provenance")}
