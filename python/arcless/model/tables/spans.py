"""Sheets of spans, droppers and hangers → types of spans, and their order along the line."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from arcless.errors import ModelError
from arcless.model.line.parts.spans import MAX_SPANS, SpanDroppers, SpanType
from arcless.model.tables.grids import Table

# Path below `span_types.NAME` → place of the cell that it came from.
Places = dict[tuple[str | int, ...], str]


@dataclass(frozen=True)
class Hung:
    """Droppers or hangers of a span: positions, and pre-sag or lengths, all in m."""

    positions: tuple[float, ...] = ()
    presag: tuple[float, ...] | None = None
    lengths: tuple[float, ...] | None = None

    @classmethod
    def of(cls, own: SpanDroppers) -> "Hung":
        """Return the droppers or hangers of a line; where nothing hangs, no list says anything."""
        if not own.positions:
            return cls()
        return cls(own.positions, own.presag, own.lengths)

    def to_data(self) -> dict[str, Any]:
        """Return plain data for a model file."""
        lists = {"positions": self.positions, "presag": self.presag, "lengths": self.lengths}
        return {
            name: [short(value) for value in values]
            for name, values in lists.items()
            if values is not None
        }


@dataclass(frozen=True)
class Span:
    """Content of a span, without its name; None where the line has nothing of that kind."""

    length: float
    droppers: Hung | None
    hangers: Hung | None

    @classmethod
    def of(cls, own: SpanType, *, has_droppers: bool, has_hangers: bool) -> "Span":
        """Return the content of a type of span."""
        return cls(
            own.length,
            Hung.of(own.droppers) if has_droppers else None,
            Hung.of(own.holders) if has_hangers else None,
        )

    def to_data(self) -> dict[str, Any]:
        """Return plain data for a model file."""
        made: dict[str, Any] = {"length": short(self.length)}
        for name, hung in (("droppers", self.droppers), ("hangers", self.hangers)):
            if hung is not None:
                made[name] = hung.to_data()
        return made


def short(value: float) -> float | int:
    """Return a number as one would type it: 60 for 60.0."""
    return int(value) if value.is_integer() else value


def spans_of(
    spans: Table, droppers: Table | None, hangers: Table | None
) -> tuple[list[Span], list[Places]]:
    """Return the spans of a line in order, and where each value of them stands.

    Raises
    ------
    ModelError
        Numbers are out of order, a dropper is in no span, or pre-sag and lengths are mixed.
    """
    if not len(spans):
        raise ModelError("no spans", where=spans.grid.where, got="a header without rows",
                         expected="a row for each span")  # fmt: skip
    spans.check_numbers("span")
    count = len(spans)
    if count > MAX_SPANS:
        raise ModelError("too many spans", where=spans.grid.where, got=str(count),
                         expected=f"at most {MAX_SPANS}")  # fmt: skip
    places: list[Places] = [{("length",): spans.at(index, "length")} for index in range(count)]
    hung = {
        name: _hung(table, name, count, places)
        for name, table in (("droppers", droppers), ("hangers", hangers))
        if table is not None
    }
    nothing: list[Hung | None] = [None] * count
    columns = (spans.columns["length"], hung.get("droppers", nothing), hung.get("hangers", nothing))
    return [Span(*values) for values in zip(*columns, strict=True)], places


def _hung(table: Table, name: str, count: int, places: list[Places]) -> list[Hung | None]:
    """Return what hangs in each span, and note where it stands."""
    number = name.removesuffix("s")
    rows: list[list[int]] = [[] for _ in range(count)]
    for index, span in enumerate(table.columns["span"]):
        if span > count:
            raise ModelError(f"{number} in no span", where=table.at(index, "span"),
                             got=f"span {span}", expected=f"a span from 1 to {count}")  # fmt: skip
        rows[span - 1].append(index)
    rows = [_in_order(table, number, span, own) for span, own in enumerate(rows, start=1)]
    for span, own in enumerate(rows):
        for place, index in enumerate(own):
            for column, field in (
                ("position", "positions"),
                ("presag",) * 2,
                ("length", "lengths"),
            ):
                places[span][name, field, place] = table.at(index, column)
    return [_of_span(table, number, own) for own in rows]


def _in_order(table: Table, number: str, span: int, rows: Sequence[int]) -> list[int]:
    """Return the rows of a span as they are numbered or, without numbers, by position."""
    numbers = [table.column(number)[index] for index in rows]
    if all(given is None for given in numbers):
        return sorted(rows, key=lambda index: table.columns["position"][index])
    for place, (index, given) in enumerate(zip(rows, numbers, strict=True), start=1):
        if given != place:
            got = "no number" if given is None else f"{number} {given}"
            raise ModelError(
                f"{number}s out of order", where=table.at(index, number),
                got=f"{got} of span {span}",
                expected=f"{place}: they count from 1 in each span, none left out or given twice",
                hint=f"number them again, or empty the cells of column {number} in this span: then"
                " they count by position",
            )  # fmt: skip
    return list(rows)


def _of_span(table: Table, number: str, rows: Sequence[int]) -> Hung:
    lists = {}
    for column in ("presag", "length"):
        values = [table.column(column)[index] for index in rows]
        filled = [index for index in rows if table.column(column)[index] is not None]
        if filled and len(filled) < len(rows):
            raise _of_some(table, number, rows, column)
        lists[column] = tuple(values) if filled else None
    if lists["presag"] is not None and lists["length"] is not None:
        raise ModelError(
            "both presag and length", where=table.at(rows[0], "length"), got="two values",
            expected="presag (design) or length (as built)",
        )  # fmt: skip
    positions = tuple(table.columns["position"][index] for index in rows)
    return Hung(positions, lists["presag"], lists["length"])


def _of_some(table: Table, number: str, rows: Sequence[int], column: str) -> ModelError:
    """Return the error of a column that is filled in some rows of a span, at the rarer kind."""
    values = table.column(column)
    filled = [index for index in rows if values[index] is not None]
    empty = [index for index in rows if values[index] is None]
    other = table.column("length" if column == "presag" else "presag")
    excluded = "presag (design) and length (as built) exclude each other in a span"
    is_stray = len(filled) <= len(empty)
    place = filled[0] if is_stray else empty[0]
    return ModelError(
        f"{column} of some {number}s only", where=table.at(place, column),
        got=f"{short(values[place])} m, and {len(empty)} empty cells of {len(rows)}"
        if is_stray else "an empty cell",
        expected=f"a {column} of every {number} of the span, or of none",
        hint=excluded if any(other[index] is not None for index in rows) else None,
    )  # fmt: skip


def named(
    spans: Sequence[Span],
    labels: Sequence[str | None],
    known: Mapping[str, Span],
    in_use: Collection[str],
) -> tuple[list[str], dict[str, Span]]:
    """Return the name of the type of each span, and the types by name.

    Spans of one name that are not alike become types of their own: the name is that of the type the
    line has by it, if some span is of that, otherwise of the first such span; the others have the
    number of the first of them behind it. Spans without a name have that of the type they are
    equal to, or are called after their number.

    Parameters
    ----------
    spans
        Spans in order.
    labels
        Name of each in the table.
    known
        Types of the line, by name.
    in_use
        Names of those that spans of the line have. One that no row names any more may get the
        content of such a span: tables that are read twice say the same.
    """
    pairs = list(zip(labels, spans, strict=True))
    types = {label: known[label] for label, span in pairs
             if label is not None and known.get(label) == span}  # fmt: skip
    found: dict[tuple[str | None, Span], str] = {(name, span): name for name, span in types.items()}
    for label, span in pairs:
        if label is not None and label not in types:
            types[label] = span
            found[label, span] = label
    names_of = {span: name for name, span in reversed({**known, **types}.items())}
    for number, (label, span) in enumerate(pairs, start=1):
        if (label, span) in found:
            continue
        if label is None and span in names_of and _is_free(names_of[span], span, types):
            name = names_of[span]
        else:
            kept = {name for name in known if name not in in_use and known[name] != span}
            taken = {name for name, own in types.items() if own != span} | kept | set(labels)
            name = _free(f"{label or 'span'}-{number}", taken)
        types[name] = span
        found[label, span] = name
    names = [found[pair] for pair in pairs]
    return names, {name: types[name] for name in names}


def _is_free(name: str, span: Span, types: Mapping[str, Span]) -> bool:
    return types.get(name, span) == span


def _free(name: str, taken: Collection[str | None]) -> str:
    found, count = name, 1
    while found in taken:
        count += 1
        found = f"{name}-{count}"
    return found


def runs(names: Sequence[str]) -> list[dict[str, Any]]:
    """Return names in order as runs of equal spans, as a model file has them."""
    counted = [(name, len(list(group))) for name, group in groupby(names)]
    return [{"type": name, "count": count} for name, count in counted]
