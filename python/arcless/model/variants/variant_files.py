"""Variants: scenario files that hold only what differs from another scenario.

``base`` names the other scenario, ``set`` the fields that differ, by their dotted paths, as
``arcless run BASE --set`` takes them; a value may say where it comes from, as in any model file.
"""

from collections.abc import Mapping
from typing import Any, Literal

from pydantic import Field, ValidationError

from arcless.errors import ModelError
from arcless.model.fields.document import Document, dotted, unwrap
from arcless.model.fields.part import Path
from arcless.model.files.pydantic_errors import explain
from arcless.model.files.text_patches import rendered
from arcless.model.files.yaml_reader import Origin
from arcless.model.line.line import Line
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.scenario.overrides import Origins, apply
from arcless.model.scenario.references import build, check_format, locate, read, reference
from arcless.model.scenario.scenario import Scenario
from arcless.units import show

# A scenario has more fields; of a variant, these would be those of its base.
_OWN = {"name", "description", "sources", "format"}
_MODELS: dict[str, tuple[Literal["line", "pantograph"], type[Line] | type[Pantograph]]] = {
    "line": ("line", Line),
    "model": ("pantograph", Pantograph),
}


class Variant(Document):
    """A variant of a scenario: the scenario, and the fields in which it differs."""

    format: Literal["arcless-scenario/1"] = Field(
        default="arcless-scenario/1", description="Format and version."
    )
    base: str = Field(
        description="Scenario it is a variant of: shipped name, or file relative to this one.",
        min_length=1,
    )
    set_: dict[str, Any] = Field(
        default_factory=dict,
        alias="set",
        description="Fields that differ from the base, by dotted path, as with --set.",
    )


def is_variant(data: Mapping[str, Any]) -> bool:
    """Return whether data of a scenario are those of a variant."""
    return "base" in data


def scenario_of(data: Mapping[str, Any], origin: Origin) -> Scenario:
    """Return the scenario in plain data, of a variant or whole.

    Parameters
    ----------
    data
        The data.
    origin
        Where they come from; references are relative to its folder.

    Raises
    ------
    ModelError
        The data or the base are wrong, or variants are each other's base.
    """
    if not is_variant(data):
        return build(data, "scenario", Scenario, origin)
    check_format(data, "scenario", origin)
    variant = _validated(data, origin)
    base = named_scenario(variant.base, origin, "base")
    given = {path: _Given.of(path, value, origin) for path, value in variant.set_.items()}
    entries = {path: {**_note(base), **one.entry} for path, one in given.items()}
    changes = {path: one.value for path, one in given.items()}
    try:
        place = Origin(folder=origin.folder, within=origin.within)
        found = apply(base, changes, Origins(entries, variant.sources), place)
    except ModelError as error:
        path = _place(error, changes)
        here = origin.where(path)
        # A place of its own is that of a table that the value names.
        error.where = here if error.where is None else f"{error.where} (named in {here})"
        error.field = path
        raise
    named = {"name": variant.name, "description": variant.description or base.description}
    return found.model_copy(update=named)


def variant_text(name: str, base: str, changes: Mapping[str, Any]) -> str:
    """Return the text of a variant's file.

    Parameters
    ----------
    name
        Name of the variant.
    base
        Shipped name of its base, or that one's file relative to the variant's.
    changes
        Fields that differ, by dotted path, values as typed.

    Raises
    ------
    ModelError
        A value is no text, number, true, false, nothing, list or mapping, or is not finite.
    """
    lines = ["format: arcless-scenario/1", f"name: {rendered(name)}", f"base: {rendered(base)}"]
    given = [f"  {rendered(path)}: {rendered(value)}" for path, value in changes.items()]
    return "\n".join([*lines, *(["set:", *given] if given else []), ""])


def _validated(data: Mapping[str, Any], origin: Origin) -> Variant:
    """Return what a variant's file holds, its values as they stand there."""
    own = {key: value for key, value in data.items() if key != "set"}
    try:
        # Values of `set` keep what they say of their origin: the fields they go to take it.
        variant = Variant.model_validate({**own, "set": {}})
        return variant.model_copy(update={"set_": _mapping(data.get("set", {}))})
    except ValidationError as error:
        raise explain(error, data, origin, ()) from None
    except ModelError as error:
        error.where, error.field = origin.where(("set",)), ("set",)
        raise


def _mapping(given: object) -> dict[str, Any]:
    if given is None:
        return {}
    if isinstance(given, Mapping):
        return {str(path): value for path, value in given.items()}
    expected = "fields and their values, for example line.contact_wire.tension: 24 kN"
    raise ModelError("set", got=show(given), expected=expected)


class _Given:
    """A value of `set`, and what it says of its origin."""

    def __init__(self, value: Any, entry: dict[str, str]) -> None:
        self.value, self.entry = value, entry

    @classmethod
    def of(cls, path: str, value: Any, origin: Origin) -> "_Given":
        place: Path = ("set", path)
        first, _, _ = path.partition(".")
        if first in _OWN:
            expected = "a field that the base has"
            hint = f"{first} is in the variant itself" if path == first else None
            where = origin.where(place)
            raise ModelError(f"set.{path}", where=where, expected=expected, hint=hint, field=place)
        entry: dict[str, str] = {}
        if isinstance(value, Mapping) and "value" in value and "format" not in value:
            entry = {key: str(text) for key, text in value.items() if key != "value"}
            # The names of mark, source and note are checked as in any other file.
            try:
                value = unwrap({"value": value["value"], **entry}, place, dict[str, Any]().update)
            except ModelError as error:
                error.where = origin.where(place)
                raise
        last = path.rpartition(".")[2]
        if last in _MODELS and isinstance(value, str):
            kind, model = _MODELS[last]
            value = reference(value, kind, model, origin, place)
        return cls(value, entry)


def named_scenario(name: str, origin: Origin, field: str) -> Scenario:
    """Return the scenario that a field of a file names, of a variant or whole.

    Parameters
    ----------
    name
        Shipped name, or file relative to that of `origin`.
    origin
        The file that names it.
    field
        The field there.

    Raises
    ------
    ModelError
        There is no such scenario, or it is wrong.
    """
    path: Path = (field,)
    try:
        file = locate(name, "scenario", origin)
    except ModelError as error:
        error.what, error.where, error.field = f"{field}: {error.what}", origin.where(path), path
        raise
    with origin.referring(path):
        return scenario_of(*read(file, origin))


def _note(base: Scenario) -> dict[str, str]:
    return {"note": f"differs from {base.name}"}


def _place(error: ModelError, changes: Mapping[str, Any]) -> Path:
    """Return where in a variant's file stands what an error is about, as far as that is told."""
    about = dotted(error.field) if error.field else error.what
    for path in changes:
        bare = path.replace(".model.", ".")
        if about.startswith(path) or about.replace(".model.", ".").startswith(bare):
            return ("set", path)
    return ("set",) if changes else ()
