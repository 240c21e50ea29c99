"""Study files → validated studies, and the part of a study that decides its rows."""

import hashlib
import json
import os
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from arcless.errors import ModelError
from arcless.model import Line, Pantograph, Scenario
from arcless.model.fields.part import Path as Field
from arcless.model.files.pydantic_errors import explain
from arcless.model.files.yaml_reader import Origin
from arcless.model.scenario.references import Kind, check_format, read, read_given, reference
from arcless.model.shipped.library import shipped
from arcless.model.variants.variant_files import named_scenario
from arcless.study.definition.study import FORMAT, Execution, Study
from arcless.units import show

# Last part of the path of a field → what its values may name.
_NAMES: dict[str, Kind] = {"line": "line", "model": "pantograph"}
_REFERRED: dict[Kind, type[Line] | type[Pantograph]] = {"line": Line, "pantograph": Pantograph}
# Fields that no row depends on.
_WORDS = {"description": str, "sources": dict, "provenance": dict}
_MOST_SHOWN = 10


def load(source: "str | os.PathLike[str] | Mapping[str, Any] | Study") -> Study:
    """Return a study.

    Parameters
    ----------
    source
        A shipped name, a study file, or its data; paths in data are relative to the current
        folder.

    Raises
    ------
    ModelError
        The file or the data are wrong; the message says where and what is expected.
    """
    if isinstance(source, Study):
        return source
    if isinstance(source, Mapping):
        return _of_data(dict(source), Origin())
    return _of_data(*read(_file(source), Origin()))


def load_text(text: str, file: "str | os.PathLike[str]", within: Path | None = None) -> Study:
    """Return the study in a text that is, or will be, that of a file.

    Parameters
    ----------
    text
        The text.
    file
        The file, which need not be there: its folder is where references begin.
    within
        Whole path of the folder that no reference may lead out of; all are followed without.

    Raises
    ------
    ModelError
        The text is wrong, or a reference leads out of the folder.
    """
    return _of_data(*read_given(text, Path(file), Origin(within=within)))


def _of_data(data: dict[str, Any], origin: Origin) -> Study:
    check_format(data, "study", origin)
    given = data.get("scenario")
    if isinstance(given, str):
        data["scenario"] = named_scenario(given, origin, "scenario")
    elif "scenario" in data:
        data["scenario"] = reference(given, "scenario", Scenario, origin, ("scenario",))
    context = {"file": origin.label, "models": _named_models(data, origin)}
    try:
        return Study.model_validate(data, context=context)
    except ValidationError as error:
        raise explain(error, data, origin) from None


def execution(data: Mapping[str, Any]) -> Execution:
    """Return the execution settings from plain data: `kind`, `workers`, `scheduler`.

    Raises
    ------
    ModelError
        They are wrong, or do not go together.
    """
    try:
        return Execution.model_validate(dict(data))
    except ValidationError as error:
        raise explain(error, data, Origin(), ("executor",)) from None


def is_study(source: str) -> bool:
    """Return whether a file says of itself that it is a study, or is a shipped one by name."""
    path = shipped("study").get(source, Path(source))
    if not path.is_file():
        return False
    try:
        data, _ = read(path, Origin())
    except ModelError:
        return False
    given = data.get("format")
    return isinstance(given, str) and given.startswith(FORMAT.partition("/")[0] + "/")


def _file(source: "str | os.PathLike[str]") -> Path:
    """Return the file of a study, which may be given by its shipped name."""
    path, known = Path(source), shipped("study")
    name = os.fspath(source)
    if name in known:
        return known[name]
    if not (path.is_file() or path.suffix or path.name != name):
        close = get_close_matches(name, known, n=1)
        meant = f"did you mean {close[0]}?" if close else f"shipped: {', '.join(known)}"
        raise ModelError(
            "unknown study", got=show(name), expected="a shipped name or a file", hint=meant
        )
    return path


def contents(study: Study) -> dict[str, Any]:
    """Return all settings of a study, with the models that it names, as plain data."""
    data = study.to_dict()
    data["order of variables"] = list(data["variables"])
    data["models"] = study.model_contents()
    plain: dict[str, Any] = json.loads(json.dumps(data))
    return plain


def of_contents(data: Mapping[str, Any], label: str) -> Study:
    """Return a study from its contents; those of version 1 have no words.

    Raises
    ------
    ValidationError
        They are those of no study.
    """
    given = {name: data[name] for name in data if name not in ("order of variables", "models")}
    order = data.get("order of variables", list(given["variables"]))
    given["variables"] = {name: given["variables"][name] for name in order}
    context = {"file": label, "models": data.get("models", {})}
    return Study.model_validate(given, context=context)


def meaning(data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the part of a study's contents that decides its rows: no words, no executor."""
    plain: dict[str, Any] = _without_words({key: data[key] for key in data if key != "executor"})
    return plain


def digest(data: Any) -> str:
    """Return a short hash of plain data; floats count to 12 digits, as machines may differ."""
    text = json.dumps(_rounded(data), sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def differences(before: dict[str, Any], now: dict[str, Any]) -> list[str]:
    """Return what differs between two studies, a line a field; of many the first ones."""
    one, other = dict(_leaves(before)), dict(_leaves(now))
    fields = [path for path in {**one, **other} if one.get(path) != other.get(path)]
    lines = [
        f"{path}: {_shown(one, path)} → {_shown(other, path)}" for path in fields[:_MOST_SHOWN]
    ]
    more = len(fields) - _MOST_SHOWN
    return lines + ([f"and {more} more"] if more > 0 else [])


def _named_models(data: Mapping[str, Any], origin: Origin) -> dict[str, Any]:
    """Return the lines and pantographs that values name, while names are relative to the file.

    What is no study is left for the validation to refuse.
    """
    named: list[tuple[Field, object, object]] = []
    changes, variables = (data.get(name) for name in ("set", "variables"))
    if isinstance(changes, Mapping):
        named += [(("set", path), path, value) for path, value in changes.items()]
    for name, given in variables.items() if isinstance(variables, Mapping) else ():
        if isinstance(given, Mapping):
            for place, group in (("values", given), ("distribution", given.get("distribution"))):
                values = group.get("values") if isinstance(group, Mapping) else None
                for value in values if isinstance(values, list | tuple) else ():
                    named.append((("variables", name, place), given.get("field"), value))
    models = {}
    for place_, field, value in named:
        kind = _NAMES.get(str(field).rpartition(".")[2])
        if kind is not None and isinstance(value, str):
            model: Any = reference(value, kind, _REFERRED[kind], origin, place_)
            models[value] = model.to_dict()
    return models


def _shown(leaves: dict[str, Any], path: str) -> str:
    return show(leaves[path]) if path in leaves else "absent"


def _leaves(data: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    items = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in items:
        below = f"{path}.{key}" if path else str(key)
        if isinstance(value, dict | list) and value:
            yield from _leaves(value, below)
        else:
            yield below, value


def _without_words(data: Any) -> Any:
    if isinstance(data, list):
        return [_without_words(item) for item in data]
    if not isinstance(data, dict):
        return data
    return {
        key: _without_words(value)
        for key, value in data.items()
        if not isinstance(value, _WORDS.get(key, ()))
    }


def _rounded(data: Any) -> Any:
    if isinstance(data, list | tuple):
        return [_rounded(item) for item in data]
    if isinstance(data, dict):
        return {key: _rounded(value) for key, value in data.items()}
    return f"{data:.12g}" if isinstance(data, float) else data
