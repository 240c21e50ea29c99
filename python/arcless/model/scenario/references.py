"""Data of models → validated models; references between files are resolved here."""

import os
from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path as FilePath
from typing import Any, Literal, TypeVar

from pydantic import ValidationError

from arcless.errors import ModelError
from arcless.model.fields.document import Document, printed
from arcless.model.fields.part import Path
from arcless.model.files.csv_tables import with_tables
from arcless.model.files.pydantic_errors import explain
from arcless.model.files.yaml_reader import Origin, is_file, parse, read_text
from arcless.model.fmu.loading import with_fmu
from arcless.model.line.line import Line
from arcless.model.pantograph.controller import with_function
from arcless.model.pantograph.force_tables import with_force_tables
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.pantograph.roof import with_points
from arcless.model.scenario.scenario_data import MAX_PANTOGRAPHS, ScenarioData
from arcless.model.shipped.library import find, shipped
from arcless.units import plain, show

Kind = Literal["scenario", "line", "pantograph"]
Model = TypeVar("Model", bound=Document)
KINDS: tuple[Kind, ...] = ("scenario", "line", "pantograph")
# Hints for a file of a format that was not asked for.
_COMMANDS = {
    "scenario": "`arcless run {}`",
    "line": "`arcless statics {}`, or name it as the line of a scenario",
    "pantograph": "`arcless check {}`, or name it as a model of a scenario's pantographs",
    "study": "`arcless study run {}`",
}
_SUFFIXES = {".yaml", ".yml", ".json"}


def read(path: FilePath, referrer: Origin) -> tuple[dict[str, Any], Origin]:
    """Return the data in a file, and where they come from; `referrer` names the file."""
    return read_given(read_text(path, str(path)), path, referrer)


def read_given(text: str, path: FilePath, referrer: Origin) -> tuple[dict[str, Any], Origin]:
    """Return the data of a text in place of what its file has; see `read`."""
    label = str(path)
    resolved = path.resolve()
    if resolved in referrer.chain:
        names = " → ".join(part.name for part in (*referrer.chain, resolved))
        expected = "files that do not refer to each other in a circle"
        raise ModelError("recursive reference", where=label, got=names, expected=expected)
    data, positions = parse(text, label)
    chain = (*referrer.chain, resolved)
    return data, Origin(label, path.parent, positions, chain, referrer.within)


def build(
    data: Mapping[str, Any],
    kind: Kind,
    model: type[Model],
    origin: Origin,
    prefix: Path = (),
) -> Model:
    """Return the model of plain data; references in it are resolved.

    Parameters
    ----------
    data
        The data.
    kind, model
        What they are, and the class of that.
    origin
        Where they come from; references are relative to its folder.
    prefix
        Path of the field that holds the data, where they are part of others.
    """
    check_format(data, kind, origin, prefix)
    if kind == "scenario":
        data = _resolve(data, origin)
    elif kind == "pantograph":
        data = with_fmu(with_force_tables(data, origin, prefix), origin, prefix)
    try:
        return model.model_validate(data)
    except ValidationError as error:
        raise explain(error, data, origin, prefix) from None


def load_file(path: FilePath, kind: Kind, model: type[Model], referrer: Origin) -> Model:
    """Return the model in a file; `referrer` names the file."""
    data, origin = read(path, referrer)
    return build(data, kind, model, origin)


def load_named(name: str, kind: Kind, model: type[Model], origin: Origin) -> Model:
    """Return the model that a shipped name, or a file in the folder of `origin`, has."""
    return load_file(locate(name, kind, origin), kind, model, origin)


def check_format(data: Mapping[str, Any], kind: str, origin: Origin, prefix: Path = ()) -> None:
    """Refuse data that are not version 1 of the format ``arcless-KIND``."""
    expected = f"arcless-{kind}/1"
    given = data.get("format")
    # Data that are not a file of their own need no format: nobody has to guess what they are.
    is_file = origin.label is not None and not prefix
    if given == expected or (given is None and not is_file):
        return
    path = (*prefix, "format")
    what = "missing field" if given is None else "wrong format"
    is_version = isinstance(given, str) and given.startswith(f"arcless-{kind}/")
    hint = "this version of Arcless reads version 1" if is_version else other_kind(given, origin)
    if given is None:
        hint = f"start the file with format: {expected}"
    raise ModelError(
        f"{printed(path)}: {what}",
        where=origin.where(path),
        got=None if given is None else show(given),
        expected=expected,
        hint=hint,
        field=path,
    )


def other_kind(given: object, origin: Origin) -> str | None:
    """Return what a file of another format is, and the command for it; None if it is none."""
    name, _, _ = given.partition("/") if isinstance(given, str) else ("", "", "")
    kind = name.removeprefix("arcless-")
    if name == kind or kind not in _COMMANDS:
        return None
    is_named = origin.label is None or len(origin.chain) > 1
    file = origin.label or ""
    command = "" if is_named else f": {_COMMANDS[kind].format(plain(file) if file else '')}"
    return f"this is a {kind}{command}"


def _resolve(data: Mapping[str, Any], origin: Origin) -> dict[str, Any]:
    """Replace the references of a scenario by the models they name."""
    resolved = dict(data)
    if "line" in data:
        resolved["line"] = reference(data["line"], "line", Line, origin, ("line",))
    if "as_built" in data:
        resolved["as_built"] = with_tables(data["as_built"], origin)
    placements = data.get("pantographs")
    if isinstance(placements, (list, tuple)):
        resolved["pantographs"] = [
            _placement(item, origin, ("pantographs", index))
            if isinstance(item, Mapping) and index < MAX_PANTOGRAPHS
            else item
            for index, item in enumerate(placements)
        ]
    return resolved


def _placement(item: Mapping[str, Any], origin: Origin, path: Path) -> dict[str, Any]:
    resolved = dict(item)
    if "model" in item:
        where = (*path, "model")
        resolved["model"] = reference(item["model"], "pantograph", Pantograph, origin, where)
    controller = item.get("controller")
    if isinstance(controller, Mapping):
        resolved["controller"] = with_function(controller, origin, (*path, "controller"))
    motion = item.get("roof_motion")
    if isinstance(motion, Mapping):
        resolved["roof_motion"] = with_points(dict(motion), origin, (*path, "roof_motion"))
    return resolved


def reference(value: object, kind: Kind, model: type[Model], origin: Origin, path: Path) -> object:
    """Return the model that a field holds: by shipped name, by file, or written there."""
    if isinstance(value, Mapping):
        return build(dict(value), kind, model, origin, path)
    if isinstance(value, (Line, Pantograph, ScenarioData)):
        return value
    if not isinstance(value, str):
        raise ModelError(
            printed(path),
            where=origin.where(path),
            got=show(value),
            expected=f"the name of a shipped {kind}, a file, or a mapping",
            field=path,
        )
    try:
        file = locate(value, kind, origin)
    except ModelError as error:
        error.what, error.where = f"{printed(path)}: {error.what}", origin.where(path)
        raise
    with origin.referring(path):
        return load_file(file, kind, model, origin)


def locate(source: str | os.PathLike[str], kind: Kind, origin: Origin) -> FilePath:
    """Return the file that is named by a shipped name or by its path."""
    if isinstance(source, str):
        if file := find(kind, source):
            return file
        path = origin.file(source)
        is_path = path.suffix in _SUFFIXES or os.sep in source or "/" in source
        if not is_path and not is_file(path):
            raise ModelError(
                f"unknown {kind}",
                got=show(source),
                expected=f"a shipped name or a file ({', '.join(sorted(_SUFFIXES))})",
                hint=_hint(source, kind),
            )
        return path
    return FilePath(source)


def _hint(name: str, kind: Kind) -> str:
    """Return what may be meant by a name that no shipped model of a kind has."""
    known = shipped(kind)
    close = get_close_matches(name, known, n=1)
    meant = f"did you mean {close[0]}?" if close else f"shipped: {', '.join(known)}"
    others = [other for other in KINDS if other != kind and name in shipped(other)]
    return f"{name} is a shipped {others[0]}; {meant}" if others else meant
