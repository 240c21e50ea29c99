"""The model's data as table rows: every value with unit, source and confidence mark."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel

from arcless.model import Line, Pantograph, Provenance, Scenario

Document = Scenario | Line | Pantograph

# A measured line may have hundreds of span types; the file stays small and the result file has all.
MAX_ROWS = 400
MAX_TEXT = 160

_NOT_DATA = {"format", "name", "description", "sources", "provenance"}
# Fields where a word may stand, and what the run takes for it.
_TAKEN: dict[str, Callable[[Scenario], Any]] = {
    "solver.time_step": lambda scenario: scenario.time_step_s,
    "solver.scheme.name": lambda scenario: scenario.stepping.scheme.name,
    "solver.residual_flexibility": lambda scenario: scenario.stepping.residual_flexibility,
    "solver.wire_model": lambda scenario: scenario.stepping.wires,
    "solver.contact_wire_element": lambda scenario: scenario.stepping.contact_wire_element_m,
    "solver.messenger_wire_element": lambda scenario: scenario.stepping.messenger_wire_element_m,
}


@dataclass(frozen=True)
class Row:
    """One value: its dotted path, the value with its unit, and where it comes from."""

    path: str
    value: str
    mark: str = ""
    source: str = ""
    note: str = ""


@dataclass(frozen=True)
class Group:
    """The rows of one document: the scenario, its line, or a pantograph."""

    title: str
    description: str
    rows: list[Row]
    sources: dict[str, str]
    left_out: int = 0


def groups(scenario: Scenario) -> list[Group]:
    """Return one group for the scenario, its line and each different pantograph."""
    documents: dict[str, Document] = {f"Line {scenario.line.name}": scenario.line}
    for placement in scenario.pantographs:
        documents[f"Pantograph {placement.model.name}"] = placement.model
    documents[f"Scenario {scenario.name}"] = scenario
    return [_group(title, document) for title, document in documents.items()]


def marks_used(found: Sequence[Group]) -> set[str]:
    """Return the confidence marks that occur."""
    return {row.mark for group in found for row in group.rows if row.mark}


def _group(title: str, document: Document) -> Group:
    rows = list(_rows(document, document, ""))
    return Group(
        title, document.description, rows[:MAX_ROWS], document.sources, max(0, len(rows) - MAX_ROWS)
    )


def _rows(document: Document, part: BaseModel, prefix: str) -> Iterator[Row]:
    for name, field in type(part).model_fields.items():
        if part is document and name in _NOT_DATA:
            continue
        extra = field.json_schema_extra
        unit = str(extra.get("unit", "")) if isinstance(extra, Mapping) else ""
        yield from _value_rows(
            document, getattr(part, name), f"{prefix}{field.alias or name}", unit
        )


def _value_rows(document: Document, value: Any, path: str, unit: str) -> Iterator[Row]:
    if value is None or (isinstance(value, Document) and value is not document):
        return
    if isinstance(value, BaseModel):
        yield from _rows(document, value, f"{path}.")
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from _value_rows(document, item, f"{path}.{key}", unit)
    elif isinstance(value, tuple) and value and isinstance(value[0], BaseModel):
        for index, item in enumerate(value):
            yield from _value_rows(document, item, f"{path}.{index}", unit)
    else:
        yield _row(document, value, path, unit)


def _row(document: Document, value: Any, path: str, unit: str) -> Row:
    shown = "" if unit == "1" else unit
    text = _text(value, shown)
    if isinstance(value, str) and isinstance(document, Scenario) and path in _TAKEN:
        taken = _text(_TAKEN[path](document), shown)
        text += f" ({taken})" if taken != text else ""
    origin = _origin(document, path)
    return Row(path, text, origin.mark or "", origin.source or "", origin.note or "")


def _origin(document: Document, path: str) -> Provenance:
    """Return the provenance of a value, or of the mapping it was given in."""
    while path:
        if path in document.provenance:
            return document.provenance[path]
        path = path.rpartition(".")[0]
    return Provenance(mark=None, source=None, note=None)


def _text(value: Any, unit: str) -> str:
    if isinstance(value, tuple):
        text, unit = ", ".join(_text(item, "") for item in value) or "none", unit if value else ""
    elif isinstance(value, bool):
        text, unit = ("yes" if value else "no"), ""
    elif isinstance(value, float):
        text = f"{value:,.8g}".replace(",", "\u202f")
    else:  # words and counts have no unit
        text, unit = str(value), ""
    if len(text) > MAX_TEXT:
        text = text[:MAX_TEXT] + " …"
    return f"{text} {unit}".rstrip()
