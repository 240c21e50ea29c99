"""Mistakes in the text of a model file, and their places: read as `arcless check` reads it.

The line at rest is not looked for here, which takes a hundred times as long: the drawing asks for
it anyway, and is told.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError, ModelError
from arcless.model.load import load_text
from arcless.simulate.checks import advice
from arcless.studio.answers.answers import complaint
from arcless.studio.model_text.places import Place, places
from arcless.studio.project.kinds import kind_of
from arcless.study.definition.load import load_text as load_study_text


def check(text: str, label: str, file: Path, within: Path) -> dict[str, Any]:
    """Return kind, errors, warnings and the places of all fields.

    Parameters
    ----------
    text
        The text, which need not be saved.
    label
        Path of the file in the project, for messages.
    file
        The file, whose folder is where references begin.
    within
        Whole path of the folder that no reference may lead out of.
    """
    kind, errors, warnings = kind_of(text), list[dict[str, Any]](), list[str]()
    fields: dict[str, Place] = {}
    try:
        fields = places(text, label)
        if kind == "study":
            load_study_text(text, file, within)
        else:
            warnings = advice(load_text(text, file, within), label)
    except ArclessError as error:
        errors = [_below(_placed(one, fields), file, label) for one in _each(error)]
    return {"kind": kind, "errors": errors, "warnings": warnings, "fields": fields}


def _each(error: ArclessError) -> Iterator[ArclessError]:
    """Yield an error, and the further ones that were found with it."""
    if not isinstance(error, ModelError) or not error.also:
        yield error
        return
    also, error.also = error.also, ()
    yield error
    yield from also


def _below(found: dict[str, Any], file: Path, label: str) -> dict[str, Any]:
    """Return a complaint with the file by its path in the project."""
    names = ("text", "where")
    return found | {name: found[name].replace(str(file), label) for name in names if name in found}


def _placed(error: ArclessError, fields: dict[str, Place]) -> dict[str, Any]:
    """Return an error as a complaint, with the place of its field or its line."""
    found = complaint(error)
    path = [str(part) for part in getattr(error, "field", ())]
    while path:
        if place := fields.get(".".join(path)):
            return found | place
        path.pop()
    line = (error.where or "").rpartition(":")[2]
    return found | {"line": int(line), "column": 1} if line.isdigit() else found
