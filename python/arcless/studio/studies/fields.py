"""Fields of a scenario that a study can vary: numbers that are given, each with a first range."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel

from arcless.model import Scenario
from arcless.model.fields.part import Unit, find_unit
from arcless.units import written_in

# A range is offered this far around the value: enough to see a trend, and still a line of its kind.
SHARE = 0.1
# Significant digits of an end of a range: as somebody would type it.
DIGITS = 4
# Fields about the run as such, and words.
_LEFT_OUT = frozenset({"provenance", "sources", "certainty", "output", "format"})
_TITLES = {"pantographs": "pantograph", "line": "line", "model": ""}


@dataclass(frozen=True)
class VariedField:
    """A field.

    Attributes
    ----------
    field
        Dotted path, as of `arcless run --set`.
    label, group, description
        Words: of the field, of what it belongs to, and what it is.
    typed, unit
        Its value as it stands in the file, and the unit of the two below.
    value
        Number in that unit.
    offered
        Range to start from in that unit, within the field's limits; None where the value is 0.
    limits
        The limits in words; empty without.
    """

    field: str
    label: str
    group: str
    description: str
    typed: str
    unit: str
    value: float
    offered: tuple[float, float] | None
    limits: str


def fields(scenario: Scenario) -> list[VariedField]:
    """Return the fields of a scenario that are numbers and have a value, in their order."""
    given = _given(scenario.to_dict())
    return [
        _varied(path, value, unit, about, given.get(path))
        for path, value, unit, about in _numbers(scenario, ())
    ]


def words_of_field(path: str) -> str:
    """Return a field by its dotted path in words, as the list of fields has it."""
    *above, last = path.split(".")
    group, label = _words(above), _words([last])
    return (f"{group}: {label}" if group else label).capitalize()


def _numbers(part: BaseModel, above: tuple[str, ...]) -> Iterator[tuple[str, float, Unit, str]]:
    """Yield dotted path, value in SI, unit and description of each number."""
    for name, about in type(part).model_fields.items():
        key = about.alias or name
        value = getattr(part, name)
        if key in _LEFT_OUT:
            continue
        path = (*above, key)
        unit = find_unit(about)
        if isinstance(value, float | int) and not isinstance(value, bool) and unit is not None:
            yield ".".join(path), float(value), unit, about.description or ""
        else:
            yield from _inside(value, path)


def _inside(value: Any, path: tuple[str, ...]) -> Iterator[tuple[str, float, Unit, str]]:
    if isinstance(value, BaseModel):
        yield from _numbers(value, path)
        return
    # Spans by their hundreds are not varied one by one; span types and pantographs are.
    is_spans = path[-1:] == ("spans",)
    if isinstance(value, list | tuple) and not is_spans:
        value = dict(enumerate(value))
    for key, item in value.items() if isinstance(value, Mapping) else ():
        if isinstance(item, BaseModel) and "." not in str(key):
            yield from _numbers(item, (*path, str(key)))


def _varied(path: str, value: float, unit: Unit, about: str, given: str | None) -> VariedField:
    written = None if given is None else written_in(given, unit.unit)
    name, scale = written or (unit.label, 1.0)
    name = "" if unit.unit == "1" else name
    shown = value / scale
    *above, last = path.split(".")
    return VariedField(
        field=path,
        label=_words([last]).capitalize(),
        group=_words(above).capitalize() or "Scenario",
        description=about,
        typed=given if given and written else f"{shown:.6g} {name}".rstrip(),
        unit=name,
        value=float(f"{shown:.12g}"),
        offered=_offered(value, unit, scale),
        limits=unit.bounds,
    )


def _offered(value: float, unit: Unit, scale: float) -> tuple[float, float] | None:
    if value == 0.0:
        return None
    ends = sorted(value * (1.0 + sign * SHARE) for sign in (-1.0, 1.0))
    low = max([ends[0], *(one for one in (unit.minimum, unit.above) if one is not None)])
    high = min([ends[1], *(one for one in (unit.maximum, unit.below) if one is not None)])
    if not low < high:
        return None
    return float(f"{low / scale:.{DIGITS}g}"), float(f"{high / scale:.{DIGITS}g}")


def _words(parts: list[str]) -> str:
    words = []
    for part in parts:
        if part.isdigit():
            words.append(str(int(part) + 1))
        elif _TITLES.get(part, part):
            words.append(_TITLES.get(part, part).replace("_", " "))
    return " ".join(words)


def _given(data: Mapping[str, Any]) -> dict[str, str]:
    """Return what was typed for fields, by their paths, of a scenario and the models in it."""
    documents = [("", data), ("line.", data.get("line", {}))]
    documents += [
        (f"pantographs.{at}.model.", placed.get("model", {}))
        for at, placed in enumerate(data.get("pantographs", ()))
    ]
    found = {}
    for prefix, document in documents:
        for path, entry in (document.get("provenance") or {}).items():
            if isinstance(entry.get("given"), str):
                found[prefix + path] = entry["given"].strip()
    return found
