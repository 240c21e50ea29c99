"""Changes to a scenario by dotted path: ``line.contact_wire.tension=24 kN``."""

from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass
from typing import Any, TypeVar

from pydantic import BaseModel

from arcless.errors import ModelError
from arcless.model.fields.document import Document, Provenance, dotted, written
from arcless.model.fields.part import Unit, find_unit, nearest
from arcless.model.files.yaml_nodes import scalar
from arcless.model.files.yaml_reader import Origin, parse
from arcless.model.line.line import Line
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.scenario.as_typed import SET_FOR_RUN, carry
from arcless.model.scenario.references import build, load_named
from arcless.model.scenario.scenario_data import ScenarioData
from arcless.model.shipped.wire_catalogue import GIVES
from arcless.units import show

Model = TypeVar("Model", bound=ScenarioData)
# Giving one of these takes the others back, unless they are changed in the same call.
_EXCLUSIVE = {
    "speed": ("speed_profile",),
    "speed_profile": ("speed",),
    "static_force": ("mean_force",),
    "mean_force": ("static_force",),
    "presag": ("lengths",),
    "lengths": ("presag",),
    "spans": ("from", "to"),
    "from": ("spans",),
    "to": ("spans",),
    "masses": ("matrices", "fmu"),
    "matrices": ("masses", "fmu"),
    "fmu": ("masses", "matrices"),
    "file": ("time", "position", "displacement", "sha256"),
    "time": ("position", "file"),
    "position": ("time", "file"),
    "displacement": ("file",),
    "catalogue": GIVES,
}
_SECOND = "`arcless new NAME --from SCENARIO --two-pantographs tsi` makes a scenario with two"


def parse_override(text: str) -> tuple[str, Any]:
    """Return path and value of ``path.to.field=value``.

    The value is read as in a model file: a number, a text with its unit, true, false, null, or a
    list or mapping in brackets.

    Examples
    --------
    >>> parse_override("line.contact_wire.tension=24 kN")
    ('line.contact_wire.tension', '24 kN')
    """
    path, equals, value = (part.strip() for part in text.partition("="))
    if not path or not equals or not value:
        raise ModelError(
            "override",
            got=show(text),
            expected="path.to.field=value",
            hint="for example line.contact_wire.tension=24 kN",
        )
    if value[0] in "[{\"'":
        data, _ = parse(f"value: {value}", f"override {path}")
        return path, data["value"]
    return path, scalar(value)


@dataclass(frozen=True)
class Origins:
    """Where changed values come from.

    Attributes
    ----------
    entries
        Note, mark and keys of sources of each change, by its path.
    sources
        Citations of these keys.
    """

    entries: Mapping[str, Mapping[str, str]]
    sources: Mapping[str, str]

    def of(self, path: str) -> dict[str, str]:
        """Return what is known of the value of a field."""
        return dict(self.entries.get(path, {"note": SET_FOR_RUN}))


_OF_THE_RUN = Origins({}, {})
_ANYWHERE = Origin()


def apply(
    scenario: Model,
    changes: Mapping[str, Any],
    origins: Origins = _OF_THE_RUN,
    place: Origin = _ANYWHERE,
) -> Model:
    """Return a validated copy of `scenario` with changed fields; see `Scenario.with_`.

    Files that changes name are relative to the folder of `place`, and stay within its limit.

    Raises
    ------
    ModelError
        There is no such field, or the scenario is not valid with it.
    """
    changed_groups = {path.partition(".")[0] for path in changes}
    dumped = {"provenance", "sources", *changed_groups}
    data = scenario.model_dump(mode="json", by_alias=True, include=dumped)
    # Parts without a change are valid as they are; reading a line again takes longest of all.
    data = {name: data.get(name, getattr(scenario, name)) for name in type(scenario).model_fields}
    replaced: set[str] = set()
    named: dict[str, Document] = {}
    for path, value in changes.items():
        replaced |= _set(data, path, value, set(changes), named, origins=origins, origin=place)
    changed = build(data, "scenario", type(scenario), place)
    carry(scenario, changed, replaced, named)
    return changed


def apply_to_line(line: Line, changes: Mapping[str, Any], place: Origin = _ANYWHERE) -> Line:
    """Return a validated copy of a line with changed fields, with or without `line.` before them.

    Files that changes name are relative to the folder of `place`, and stay within its limit.

    Raises
    ------
    ModelError
        There is no such field, or the line is not valid with it.
    """
    data = line.model_dump(mode="json", by_alias=True)
    own = {path.removeprefix("line."): value for path, value in changes.items()}
    for path, value in own.items():
        _set(data, path, value, set(own), {}, origin=place)
    return build(data, "line", Line, place)


def field_of(scenario: ScenarioData, path: str) -> tuple[str, Unit | None]:
    """Return the whole path of a field, nothing left out, and its unit or None.

    Raises
    ------
    ModelError
        There is no such field.
    """
    place: Any = scenario
    unit: Unit | None = None
    whole = _full_path(scenario.to_dict(), path)
    for part in whole:
        if isinstance(place, BaseModel):
            fields = type(place).model_fields
            name = next(n for n, field in fields.items() if part in (field.alias, n))
            place, unit = getattr(place, name), find_unit(fields[name])
        else:
            place = place[part]
    return dotted(tuple(whole)), unit


def _set(
    data: dict[str, Any],
    path: str,
    value: Any,
    changed: set[str],
    named: dict[str, Document],
    *,
    origins: Origins = _OF_THE_RUN,
    origin: Origin = _ANYWHERE,
) -> set[str]:
    """Set a field, note the model that was named for it; return the paths that are other now."""
    *groups, last = _full_path(data, path)
    place: Any = data
    document, inside = data, 0
    for depth, part in enumerate(groups, start=1):
        place = place[part]
        if isinstance(place, dict) and "provenance" in place:
            document, inside = place, depth
    before, _, _ = path.rpartition(".")
    # A change further inside must not reach the caller's mapping.
    given = isinstance(value, Line | Pantograph)
    model = value if given else _named_model(last, value, origin)
    place[last] = deepcopy(value) if model is None else model.to_dict()
    whole = dotted((*groups, last))
    replaced = {whole}
    if model is not None:
        named[whole] = model
    for other in _EXCLUSIVE.get(str(last), ()) if isinstance(place, dict) else ():
        if other in place and f"{before}.{other}".lstrip(".") not in changed:
            place[other] = None
            replaced.add(dotted((*groups, other)))
    relative = ".".join(str(part) for part in (*groups, last)[inside:])
    _renew_provenance(document["provenance"], relative, value, origins.of(path))
    _cite(document, origins, path)
    return replaced


def _named_model(field: str | int, value: Any, origin: Origin) -> Line | Pantograph | None:
    """Return the model that is given by name, or None: later changes can go into its data."""
    if isinstance(value, str) and field == "line":
        return load_named(value, "line", Line, origin)
    if isinstance(value, str) and field == "model":
        return load_named(value, "pantograph", Pantograph, origin)
    return None


def _renew_provenance(
    provenance: dict[str, Any], path: str, value: Any, origin: dict[str, str]
) -> None:
    """Forget where the replaced value came from, and note where the new one does."""
    for known in list(provenance):
        if known == path or known.startswith(f"{path}."):
            del provenance[known]
    given = value.name if hasattr(value, "name") else written(value)
    provenance[path] = {**origin, "given": given}


def _cite(document: dict[str, Any], origins: Origins, path: str) -> None:
    """Add the citations of a changed value to its document: they are looked for there."""
    entry = Provenance.model_validate({"source": origins.of(path).get("source")})
    for key in entry.source_keys:
        if key not in origins.sources:
            raise ModelError(f"{path}: unknown source", got=show(key), expected="a key of sources")
        known = document["sources"].setdefault(key, origins.sources[key])
        if known != origins.sources[key]:
            raise ModelError(
                f"{path}: source cited twice",
                got=show(key),
                expected=f"another key: {document['name']} cites something else by it",
            )


def _full_path(data: dict[str, Any], path: str) -> list[str | int]:
    """Return the parts of a path in `data`; ``model`` of a pantograph may be left out."""
    parts: list[str | int] = []
    place: Any = data
    names = path.split(".")
    for depth, name in enumerate(names):
        if isinstance(place, dict) and name not in place:
            model = place.get("model")
            if isinstance(model, dict) and name in model:
                parts.append("model")
                place = model
        parts.append(_step(place, name, names[:depth], path))
        place = place[parts[-1]]
    return parts


def _step(place: Any, name: str, above: list[str], path: str) -> str | int:
    where = ".".join(above)
    if isinstance(place, dict):
        if name in place:
            return name
        known = [key for key in place if key != "provenance"]
        hint = nearest(name, known)
        whole = "the line" if place.get("format") == "arcless-line/1" else "the scenario"
        title = f"a field of {where or whole}"
        raise ModelError(f"{path}: unknown field", got=show(name), expected=title, hint=hint)
    if isinstance(place, list):
        if name.isdecimal() and int(name) < len(place):
            return int(name)
        expected = f"a number from 0 to {len(place) - 1}" if place else "the whole list"
        hint = _SECOND if (where, name) == ("pantographs", "1") else None
        raise ModelError(f"{path}: unknown item", got=show(name), expected=expected, hint=hint)
    got = f"{where} is {show(place)}"
    whole = f"set {where} as a whole, for example {where}={{{name}: …}}"
    raise ModelError(
        f"{path}: not a group of fields",
        got=got,
        expected="a group",
        hint=whole if place is None else None,
    )
