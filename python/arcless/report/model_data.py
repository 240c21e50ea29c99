"""The model's data as table rows: every value with unit, source and confidence mark."""

import dataclasses
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel

from arcless.errors import ModelError
from arcless.model import Line, Pantograph, Provenance, Scenario
from arcless.model.fields.part import Unit, find_unit
from arcless.model.pantograph.placement import PantographPlacement
from arcless.units import to_si

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
    """One value: its dotted path, the value as it was typed, and where it comes from.

    `si` is the value in SI with its unit, where that is written otherwise; `is_default` says that
    nobody gave it; `content` is the value of the model, by which rows are compared.
    """

    path: str
    value: str
    si: str = ""
    is_default: bool = False
    mark: str = ""
    source: str = ""
    note: str = ""
    content: Any = dataclasses.field(default=None, compare=False, repr=False)


@dataclass(frozen=True)
class Group:
    """The rows of one document: the scenario, its line, or a pantograph."""

    title: str
    description: str
    rows: list[Row]
    sources: dict[str, str]
    left_out: int = 0

    @property
    def given(self) -> list[Row]:
        """Values that somebody gave."""
        return [row for row in self.rows if not row.is_default]

    @property
    def defaults(self) -> list[Row]:
        """Default values."""
        return [row for row in self.rows if row.is_default]


def groups(scenario: Scenario, forces: Mapping[str, float] | None = None) -> list[Group]:
    """Return one group for the scenario, its line and each different pantograph.

    Parameters
    ----------
    scenario
        What was run.
    forces
        Static force of each pantograph in the run in N, by its name there: the rows of the scenario
        then have those that were found, and the rows of a pantograph say where its own is not used.
    """
    documents: dict[str, Document] = {f"Line {scenario.line.name}": scenario.line}
    for placement in scenario.pantographs:
        documents[f"Pantograph {placement.model.name}"] = placement.model
    documents[f"Scenario {scenario.name}"] = scenario
    made = [_group(title, document) for title, document in documents.items()]
    return made if forces is None else [_with_forces(one, scenario, forces) for one in made]


def origin_of_force(placement: PantographPlacement) -> str:
    """Return where the static force of a pantograph in a run is from, in words."""
    if placement.mean_force is not None:
        return f"found for a mean contact force of {placement.mean_force:.5g} N"
    if placement.static_force is not None:
        return "given by the scenario"
    return "given by the pantograph's data"


def _with_forces(group: Group, scenario: Scenario, forces: Mapping[str, float]) -> Group:
    """Return a group with the static forces of the run."""
    rows = []
    for row in group.rows:
        rows.append(_unused(row, group.title, scenario))
        for index, one in enumerate(scenario.pantographs):
            path = f"pantographs.{index}."
            if (group.title, row.path) == (f"Scenario {scenario.name}", f"{path}mean_force"):
                found = forces.get(one.name)
                rows += [] if found is None else [_found(f"{path}static_force", found, one)]
    return dataclasses.replace(group, rows=rows)


def _found(path: str, force: float, placement: PantographPlacement) -> Row:
    note = f"Of this run: {origin_of_force(placement)}."
    return Row(path, f"{force:.5g} N", mark="D", note=note, content=force)


def _unused(row: Row, title: str, scenario: Scenario) -> Row:
    """Return the static force of a pantograph's own data with the word that no run took it."""
    of = [one for one in scenario.pantographs if title == f"Pantograph {one.model.name}"]
    own = any(one.mean_force is None and one.static_force is None for one in of)
    if row.path != "static_force" or not of or own:
        return row
    note = f"Not used in this run: the scenario sets the force. {row.note}".rstrip()
    return dataclasses.replace(row, note=note)


def rows_of(document: Document) -> list[Row]:
    """Return the rows of one document, all of them, without those of documents inside of it."""
    return list(_rows(document, document, ""))


def marks_used(found: Sequence[Group]) -> set[str]:
    """Return the confidence marks that occur."""
    return {row.mark for group in found for row in group.rows if row.mark}


def _group(title: str, document: Document) -> Group:
    rows = rows_of(document)
    return Group(
        title, document.description, rows[:MAX_ROWS], document.sources, max(0, len(rows) - MAX_ROWS)
    )


def _rows(document: Document, part: BaseModel, prefix: str) -> Iterator[Row]:
    for name, field in type(part).model_fields.items():
        if part is document and name in _NOT_DATA:
            continue
        unit = find_unit(field)
        yield from _value_rows(
            document, getattr(part, name), f"{prefix}{field.alias or name}", unit
        )


def _value_rows(document: Document, value: Any, path: str, unit: Unit | None) -> Iterator[Row]:
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


def _row(document: Document, value: Any, path: str, unit: Unit | None) -> Row:
    shown = "" if unit is None or unit.unit == "1" else unit.label
    text = _text(value, shown)
    typed = _typed(document, value, path, unit)
    if isinstance(value, str) and isinstance(document, Scenario) and path in _TAKEN:
        taken = _text(_TAKEN[path](document), shown)
        text += f" ({taken})" if taken != text else ""
    origin = _origin(document, path)
    return Row(
        path,
        typed or text,
        text if typed and typed != text else "",
        document.is_given(path) is False,
        origin.mark or "",
        origin.source or "",
        origin.note or "",
        value,
    )


def _typed(document: Document, value: Any, path: str, unit: Unit | None) -> str:
    """Return a quantity, or a list of some, as it was typed; empty where a number was given.

    It must mean the value: a text that was kept and does not is left out.
    """
    if unit is None:
        return ""
    if isinstance(value, tuple):
        items = [
            _typed(document, item, f"{path}.{place}", unit) for place, item in enumerate(value)
        ]
        plain = [_text(item, unit.label) for item in value]
        found = [item or text for item, text in zip(items, plain, strict=True)]
        return _cut(", ".join(found)) if any(items) else ""
    text = (document.as_typed(path) or "").strip()
    has_unit = text[-1:].isalpha() or text[-1:] in "°²³)" or (text[-1:].isdigit() and "/" in text)
    if not text or not has_unit or not isinstance(value, float):
        return ""
    try:
        return _cut(text) if to_si(text, unit.unit) == value else ""
    except ModelError:
        return ""


def _cut(text: str) -> str:
    return text if len(text) <= MAX_TEXT else text[:MAX_TEXT] + " …"


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
    return f"{_cut(text)} {unit}".rstrip()
