"""Tables laid over a line: what of it is another one then, and where each value came from."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from arcless.errors import ModelError
from arcless.model.line.line import Line
from arcless.model.line.parts.heights import heights_at
from arcless.model.tables.grids import Table
from arcless.model.tables.of_line import rows_of, staggers
from arcless.model.tables.sheets import DROPPERS, HANGERS, LISTS, SPANS, SUPPORTS, Sheet
from arcless.model.tables.spans import Places, Span, named, runs, short, spans_of
from arcless.model.tables.supports import check_supports, pattern, stretches

Tables = Mapping[str, Table]


@dataclass(frozen=True)
class Laid:
    """Changes that tables make to a line, as values for its file; what is equal is left out.

    Attributes
    ----------
    changes
        New values by dotted path; None: the field goes.
    span_types
        New content by name of type; None: the type goes.
    places
        Place in the tables by path of a field, whether changed or not.
    """

    changes: dict[str, Any]
    span_types: dict[str, dict[str, Any] | None]
    places: dict[tuple[str | int, ...], str]


def laid(tables: Tables, line: Line) -> Laid:
    """Return what tables change of a line.

    A part of the line whose sheet is missing stays as it is. Spans and what hangs in them are one
    part.

    Raises
    ------
    ModelError
        A sheet is missing, or rows do not fit one another.
    """
    _check_sheets(tables, line)
    found = Laid({}, {}, {})
    lengths = _lay_spans(tables, line, found)
    positions = [0.0]
    for length in lengths:
        positions.append(positions[-1] + length)
    if SUPPORTS.name in tables:
        check_supports(tables[SUPPORTS.name], len(positions))
        _lay_heights(tables[SUPPORTS.name], line, positions, found)
        _lay_staggers(tables[SUPPORTS.name], line, found)
    for path, sheet in LISTS.items():
        if sheet.name in tables:
            _lay_list(tables[sheet.name], line, path, sheet, found)
    return found


def _check_sheets(tables: Tables, line: Line) -> None:
    """Raise `ModelError` for a sheet that is missing, or that the line has no use for."""
    needs = {
        SPANS.name: (True, "every line has spans"),
        DROPPERS.name: (line.messenger_wire is not None, "the line has a messenger wire"),
        HANGERS.name: (line.auxiliary_wire is not None, "the line has an auxiliary wire"),
    }
    for name, (is_needed, why) in needs.items():
        if is_needed and name not in tables:
            raise ModelError(
                f"no sheet {name}", got=", ".join(tables) or "none of the sheets of a line",
                expected=f"a sheet {name}: {why}",
                hint=f"a header without rows says that there are no {name}",
            )  # fmt: skip
        table = tables.get(name)
        if not is_needed and table is not None and len(table):
            where = why.partition(" has ")[2]
            raise ModelError(
                f"{name} without {where}", where=table.grid.where, got=f"{len(table)} rows",
                expected=f"a line with {where}, or no rows",
            )  # fmt: skip


def _lay_spans(tables: Tables, line: Line, found: Laid) -> list[float]:
    """Note spans and their types; return the lengths of the spans in m."""
    has = {"has_droppers": line.messenger_wire is not None,
           "has_hangers": line.auxiliary_wire is not None}  # fmt: skip
    table = tables[SPANS.name]
    hung = [
        tables.get(name) if is_there else None
        for name, is_there in zip(("droppers", "hangers"), has.values(), strict=True)
    ]
    spans, places = spans_of(table, *hung)
    known = {name: Span.of(own, **has) for name, own in line.span_types.items()}
    before = [run.type for run in line.spans for _ in range(run.count)]
    names, types = named(spans, table.column("type"), known, set(before))
    if names != before:
        found.changes["spans"] = runs(names)
    for name, span in types.items():
        if known.get(name) != span:
            found.span_types[name] = span.to_data()
    found.span_types.update({name: None for name in before if name not in types})
    _note_spans(names, places, found)
    return [span.length for span in spans]


def _note_spans(names: list[str], places: list[Places], found: Laid) -> None:
    """Note where types of spans came from: from the first span of each."""
    run = -1
    for index, (name, own) in enumerate(zip(names, places, strict=True)):
        if index == 0 or name != names[index - 1]:
            run += 1
            found.places["spans", run] = own["length",]
        if ("span_types", name) not in found.places:
            found.places["span_types", name] = own["length",]
            found.places.update({("span_types", name, *path): at for path, at in own.items()})


def _lay_heights(table: Table, line: Line, supports: list[float], found: Laid) -> None:
    heights = table.columns["contact_wire_height"]
    own = line.geometry
    found.places["geometry", "contact_wire_height"] = table.at(0, "contact_wire_height")
    if heights[0] != own.contact_wire_height:
        found.changes["geometry.contact_wire_height"] = short(heights[0])
    is_inside = all(change.to_support <= len(supports) for change in own.height_changes)
    if is_inside and heights_at(heights[0], own.height_changes, supports) == heights:
        return
    made = stretches(heights, supports)
    found.changes["geometry.height_changes"] = made or None
    for index, change in enumerate(made):
        place = table.at(change["to_support"] - 1, "contact_wire_height")
        found.places["geometry", "height_changes", index] = place


def _lay_staggers(table: Table, line: Line, found: Laid) -> None:
    for wire in ("contact_wire", "messenger_wire", "auxiliary_wire"):
        name = f"stagger_{wire}"
        values = table.columns.get(name)
        if values is None:
            continue
        for index in range(len(values)):
            found.places["geometry", name, index] = table.at(index, name)
        if values == staggers(line, wire, len(values)):
            continue
        empty = [index for index, value in enumerate(values) if value is None]
        if empty and len(empty) < len(values):
            raise ModelError(
                "stagger of some supports only", where=table.at(empty[0], name),
                got="an empty cell", expected="a stagger at every support, or at none",
            )  # fmt: skip
        found.changes[f"geometry.{name}"] = None if empty else pattern(values)


def _lay_list(table: Table, line: Line, path: str, sheet: Sheet, found: Laid) -> None:
    parts = tuple(path.split("."))
    names = [column.name for column in sheet.columns]
    rows = [[table.column(name)[index] for name in names] for index in range(len(table))]
    for index in range(len(rows)):
        found.places[*parts, index] = table.at(index, names[0])
        for name in names:
            found.places[*parts, index, name] = table.at(index, name)
    if [_filled(row, sheet) for row in rows] == rows_of(line, path, sheet):
        return
    items = [
        {name: short(value) if isinstance(value, float) else value
         for name, value in zip(names, row, strict=True) if value is not None}
        for row in rows
    ]  # fmt: skip
    found.changes[path] = items or None


# Values that an empty cell stands for.
_DEFAULTS = {"wire": "contact_wire", "transition": 0.0, "cant": 0.0}


def _filled(row: list[Any], sheet: Sheet) -> list[Any]:
    """Return a row with the values that empty cells stand for."""
    names = [column.name for column in sheet.columns]
    return [_DEFAULTS.get(name) if value is None else value
            for name, value in zip(names, row, strict=True)]  # fmt: skip
