"""Table of all variants: as texts, and as plain HTML that the page's script sorts and selects."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from markupsafe import Markup, escape
from numpy.typing import NDArray

from arcless.assess import MET, NOT_JUDGED, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE
from arcless.report.drawing.bokeh_figure import Drawing
from arcless.study.report.commands import Commands
from arcless.study.report.data.judged import VERDICTS
from arcless.study.report.data.numbers import column_texts, digits
from arcless.study.report.data.record import Column, shortened
from arcless.study.report.figures.canvas import (
    RELATIONS,
    SELECTION,
    SIGNS,
    Canvas,
    extremes,
    limits_of,
)
from arcless.study.report.tables import values_of

# Class of a cell, short as there are thousands.
_CLASSES = {MET: "m", NOT_MET: "n", NOT_MET_UNVERIFIED: "o", TOO_CLOSE: "o", NOT_JUDGED: ""}
# Rows that are printed; a page has some sixty.
PRINTED = 300


@dataclass(frozen=True)
class Entry:
    """One cell: its text, the verdict on it, and whether it is the lowest or highest of all."""

    text: str
    verdict: str = NOT_JUDGED
    end: str = ""

    @property
    def sign(self) -> str:
        """Sign of the verdict; empty for none."""
        return "" if self.verdict == NOT_JUDGED else SIGNS[self.verdict]


@dataclass(frozen=True)
class VariantColumn:
    """One column: name, what stands below it, the values that sort it, entries as texts."""

    name: str
    below: str
    values: NDArray[Any]
    entries: Sequence[Entry]
    kind: Literal["number", "word", "verdict"] = "number"


@dataclass(frozen=True)
class Head:
    """A title of the table: name, what stands below it, the column of the data that sorts it."""

    name: str
    below: str
    sort: str
    is_number: bool = True


@dataclass(frozen=True)
class Marked:
    """A variant that has the lowest or the highest value of an output."""

    variant: int
    why: str
    values: str
    command: str


@dataclass(frozen=True)
class Table:
    """All that is drawn: titles, rows as HTML, and the variants that are marked."""

    heads: list[Head]
    rows: Markup
    count: int
    marked: list[Marked]


def columns(canvas: Canvas) -> list[VariantColumn]:
    """Return the columns of the variants that are drawn."""
    record = canvas.record
    numbers = record.variants[canvas.drawn].astype(np.int32)
    found = [VariantColumn("variant", "", numbers, [Entry(str(n)) for n in numbers.tolist()])]
    if any(one.count(MET, NOT_MET) for one in canvas.verdicts.items) or canvas.verdicts.whole:
        codes = canvas.verdicts.codes[canvas.drawn].astype(np.int32)
        entries = [_verdict(int(code)) for code in codes]
        found.append(VariantColumn("verdict", "", codes, entries, "verdict"))
    for column in record.variables:
        found.append(_column(canvas, column, "", _variable(canvas, column)))
    for column in canvas.outputs:
        found.append(_column(canvas, column, _limits(canvas, column), _output(canvas, column)))
    return found


def table(canvas: Canvas, drawing: Drawing) -> Table:
    """Return the table of the variants that are drawn, in the order of their columns of data."""
    source, found = drawing.source_of(SELECTION), columns(canvas)
    heads = [
        Head(one.name, one.below, source.name_of(one.values), one.kind == "number") for one in found
    ]
    cells = [[_html(entry, one.kind) for entry in one.entries] for one in found]
    rows = "\n".join(f"<tr>{''.join(row)}" for row in zip(*cells, strict=True))
    return Table(heads, Markup(rows), len(canvas.drawn), marked(canvas))


def _html(entry: Entry, kind: str) -> str:
    judged = _CLASSES[entry.verdict]
    if kind == "word":
        return f"<td class=w><bdi>{escape(entry.text)}</bdi>"
    if kind == "verdict":
        return f'<td class="w {judged}">{SIGNS[entry.verdict]} {entry.text}'
    sign = f"{entry.sign} " if judged else ""
    end = f"<small>{entry.end}</small>" if entry.end else ""
    return f"<td{f' class={judged}' if judged else ''}>{sign}{entry.text}{end}"


def _column(canvas: Canvas, column: Column, limits: str, entries: Sequence[Entry]) -> VariantColumn:
    below = ", ".join(part for part in (column.of, column.unit, limits) if part)
    kind: Literal["number", "word"] = "number" if column.words is None else "word"
    return VariantColumn(column.title or column.name, below, canvas.of(column), entries, kind)


def _limits(canvas: Canvas, column: Column) -> str:
    """Return the limit of an output where it is the same for all variants."""
    judged = canvas.main(column)
    if judged is None:
        return ""
    known = np.unique(judged.limits[np.isfinite(judged.limits)])
    if np.ptp(known) > 1e-9 * max(float(np.abs(known).max()), 1.0):  # not rounding alone
        beyond = f", tolerance {judged.tolerance:g}" if judged.tolerance else ""
        return f"limit by variant{beyond}"
    return f"{RELATIONS[judged.relation]} {limits_of(judged, unit=False)}"


def _variable(canvas: Canvas, column: Column) -> list[Entry]:
    values = canvas.of(column)
    if column.words is None:
        return [Entry(text) for text in column_texts(values)]
    words = shortened(column.words)
    return [Entry(words[int(code)]) for code in values]


def _output(canvas: Canvas, column: Column) -> list[Entry]:
    judged, ends = canvas.main(column), extremes(column)
    codes = np.zeros(len(column.values), dtype=int) if judged is None else judged.codes
    texts = column_texts(canvas.of(column))
    found = []
    for place, text in zip(canvas.drawn.tolist(), texts, strict=True):
        verdict = NOT_JUDGED if judged is None else VERDICTS[int(codes[place])]
        end = ("lowest", "highest")[ends.index(place)] if place in ends else ""
        found.append(Entry(text, verdict, end))
    return found


def _verdict(code: int) -> Entry:
    verdict = VERDICTS[code]
    return Entry("no verdict" if verdict == NOT_JUDGED else verdict, verdict)


def marked(canvas: Canvas) -> list[Marked]:
    """Return the variants at the ends of outputs, with the command that computes each again."""
    commands, why = Commands(canvas.record.study), dict[int, list[str]]()
    for output in canvas.outputs:
        for word, place in zip(("lowest", "highest"), extremes(output), strict=True):
            if place is not None:
                text = f"{word} {output.heading}, {digits(float(output.values[place]))}"
                why.setdefault(place, []).append(f"{text} {output.unit}".rstrip())
    record = canvas.record
    return [
        Marked(
            int(record.variants[place]), "; ".join(words), values_of(record, place),
            commands.again(int(record.variants[place])),
        )
        for place, words in sorted(why.items())
    ]  # fmt: skip
