"""A line → its tables, with every digit: read back, they give the same line."""

from collections.abc import Iterable, Sequence
from typing import Any

from arcless.model.line.line import Line
from arcless.model.line.parts.spans import SpanDroppers
from arcless.model.tables.sheets import (
    DROPPERS,
    HANGERS,
    LISTS,
    SPANS,
    SUPPORTS,
    Sheet,
)
from arcless.storage.csv_files import Column
from arcless.units import spell

Rows = Sequence[Sequence[Any]]


def tables_of(line: Line) -> dict[str, list[Column]]:
    """Return the tables of a line by name of sheet, in SI units.

    A sheet without rows says that there is nothing of it; sheets and columns of wires that the line
    does not have are left out.
    """
    made = {"spans": _columns(SPANS, _spans(line)), "supports": _supports(line)}
    spans = line.span_list()
    if line.messenger_wire is not None:
        made["droppers"] = _hung(DROPPERS, [span.droppers for span in spans])
    if line.auxiliary_wire is not None:
        made["hangers"] = _hung(HANGERS, [span.holders for span in spans])
    for path, sheet in LISTS.items():
        made[sheet.name] = _columns(sheet, rows_of(line, path, sheet))
    return made


def staggers(line: Line, wire: str, count: int) -> list[float | None]:
    """Return the stagger of a wire in m at so many supports; None where another wire says it."""
    pattern = getattr(line.geometry, f"stagger_{wire}")
    if pattern is None:
        return [None] * count
    return [pattern[index % len(pattern)] for index in range(count)]


def rows_of(line: Line, path: str, sheet: Sheet) -> list[list[Any]]:
    """Return the items of a list of the line as rows; None where a field is not given."""
    place: Any = line
    for part in path.split("."):
        place = getattr(place, part)
    items = [item.model_dump(by_alias=True) for item in place or ()]
    names = [column.name for column in sheet.columns]
    return [[None if item[name] == "" else item[name] for name in names] for item in items]


def _spans(line: Line) -> Iterable[Sequence[Any]]:
    names = (run.type for run in line.spans for _ in range(run.count))
    pairs = zip(names, line.span_list(), strict=True)
    return ((number, name, span.length) for number, (name, span) in enumerate(pairs, start=1))


def _supports(line: Line) -> list[Column]:
    heights = line.contact_wire_heights()
    columns: list[Sequence[Any]] = [range(1, len(heights) + 1), heights]
    wires = ("contact_wire", "messenger_wire", "auxiliary_wire")
    columns += [staggers(line, wire, len(heights)) for wire in wires]
    made = _columns(SUPPORTS, zip(*columns, strict=True))
    there = {"stagger_messenger_wire": line.messenger_wire is not None}
    there["stagger_auxiliary_wire"] = line.auxiliary_wire is not None
    return [column for column in made if there.get(column.name, True)]


def _hung(sheet: Sheet, spans: Sequence[SpanDroppers]) -> list[Column]:
    rows = []
    for span, own in enumerate(spans, start=1):
        nothing = (None,) * len(own.positions)
        values = zip(own.positions, own.presag or nothing, own.lengths or nothing, strict=True)
        rows += [(span, number, *each) for number, each in enumerate(values, start=1)]
    return _columns(sheet, rows)


def _columns(sheet: Sheet, rows: Iterable[Sequence[Any]]) -> list[Column]:
    """Return rows as columns; of no rows, empty columns."""
    table = list(rows)
    return [
        Column(column.name, spell(column.unit), [row[place] for row in table])
        for place, column in enumerate(sheet.columns)
    ]
