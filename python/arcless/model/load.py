"""Names, files and plain data → validated models."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeVar

from arcless.errors import ModelError
from arcless.model.files.yaml_reader import Origin
from arcless.model.line.line import Line
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.scenario.references import (
    KINDS,
    Kind,
    build,
    locate,
    other_kind,
    read,
    read_given,
)
from arcless.model.scenario.scenario import Scenario
from arcless.model.shipped.library import find
from arcless.model.variants.variant_files import scenario_of
from arcless.units import plain, show

Source = str | os.PathLike[str] | Mapping[str, Any]
Model = TypeVar("Model", Scenario, Line, Pantograph)
_MODELS: dict[Kind, type[Scenario] | type[Line] | type[Pantograph]] = {
    "scenario": Scenario,
    "line": Line,
    "pantograph": Pantograph,
}


def load(source: Source | Scenario) -> Scenario:
    """Return a scenario.

    Parameters
    ----------
    source : str, path or mapping
        Shipped name, model file, or the data themselves.

    Returns
    -------
    Scenario
        Validated; its line and pantographs are resolved.

    Raises
    ------
    ModelError
        The file or the data are wrong; the message says where and what is expected.
    """
    return source if isinstance(source, Scenario) else _load(source, "scenario", Scenario)


def load_line(source: Source | Line) -> Line:
    """Return a line from a shipped name, a file or plain data; see `load`."""
    return source if isinstance(source, Line) else _load(source, "line", Line)


def load_pantograph(source: Source | Pantograph) -> Pantograph:
    """Return a pantograph from a shipped name, a file or plain data; see `load`."""
    if isinstance(source, Pantograph):
        return source
    return _load(source, "pantograph", Pantograph)


def load_any(source: Source) -> Scenario | Line | Pantograph:
    """Return the model in a file of any of the three formats, or a shipped one by name."""
    if isinstance(source, Mapping):
        return _model(source, _kind_of(source.get("format"), Origin()), Origin())
    if isinstance(source, str):
        for kind in KINDS:
            if file := find(kind, source):
                data, origin = read(file, Origin())
                return _model(data, kind, origin)
    data, origin = read(locate(source, "scenario", Origin()), Origin())
    return _model(data, _kind_of(data.get("format"), origin), origin)


def load_text(
    text: str, file: str | os.PathLike[str], within: Path | None = None
) -> Scenario | Line | Pantograph:
    """Return the model in a text that is, or will be, that of a file.

    Parameters
    ----------
    text
        The text, of any of the three formats.
    file
        The file, which need not be there: its folder is where references begin.
    within
        Whole path of the folder that no reference may lead out of; all are followed without.

    Raises
    ------
    ModelError
        The text is wrong, or a reference leads out of the folder.
    """
    data, origin = read_given(text, Path(file), Origin(within=within))
    return _model(data, _kind_of(data.get("format"), origin), origin)


def _model(data: Mapping[str, Any], kind: Kind, origin: Origin) -> Scenario | Line | Pantograph:
    """Return the model of a kind in plain data; a scenario may be a variant of another one."""
    if kind == "scenario":
        return scenario_of(data, origin)
    if kind == "line":
        return build(dict(data), kind, Line, origin)
    return build(dict(data), kind, Pantograph, origin)


def _load(source: Source, kind: Kind, model: type[Model]) -> Model:
    if isinstance(source, Mapping):
        return _of_kind(source, kind, model, Origin())
    if not isinstance(source, (str, os.PathLike)):
        expected = f"the name of a shipped {kind}, a file, or a mapping"
        raise ModelError(kind, got=show(source), expected=expected)
    data, origin = read(locate(source, kind, Origin()), Origin())
    return _of_kind(data, kind, model, origin)


def _of_kind(data: Mapping[str, Any], kind: Kind, model: type[Model], origin: Origin) -> Model:
    found = _model(data, kind, origin)
    assert isinstance(found, model)
    return found


def check_kind(value: object, kind: Kind = "scenario") -> None:
    """Refuse what is no model where a function of the package takes one.

    Raises
    ------
    ModelError
        It is a name, a path or plain data, which `arcless.load` and its like take.
    """
    if isinstance(value, _MODELS[kind]):
        return
    given = repr(os.fspath(value)) if isinstance(value, str | os.PathLike) else "…"
    loader = "load" if kind == "scenario" else f"load_{kind}"
    got = show(value) if isinstance(value, str | Mapping | None) else f"a {type(value).__name__}"
    hint = f"arcless.{loader}({plain(given)}) gives one"
    if kind == "scenario" and isinstance(value, Line):
        hint = "a scenario names a line, pantographs and a speed"
    raise ModelError(f"not a {kind}", got=got, expected=f"a {kind}", hint=hint)


def _kind_of(given: object, origin: Origin) -> Kind:
    for kind in KINDS:
        if isinstance(given, str) and given.startswith(f"arcless-{kind}/"):
            return kind
    raise ModelError(
        "format: missing field" if given is None else "format",
        where=origin.where(("format",)),
        got=None if given is None else show(given),
        expected=" or ".join(f"arcless-{kind}/1" for kind in KINDS),
        hint=other_kind(given, origin),
    )
