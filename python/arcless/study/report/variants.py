"""Table of all variants: plain HTML, sorted and selected by the page's script."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup, escape

from arcless.assess import MET, NOT_JUDGED, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE
from arcless.report.drawing.bokeh_figure import Drawing
from arcless.study.report.commands import Commands
from arcless.study.report.data.judged import VERDICTS
from arcless.study.report.data.numbers import column_texts, digits
from arcless.study.report.data.record import Column, shortened
from arcless.study.report.figures.canvas import RELATIONS, SELECTION, SIGNS, Canvas, extremes
from arcless.study.report.tables import values_of

# Class of a cell, short as there are thousands.
_CLASSES = {MET: "m", NOT_MET: "n", NOT_MET_UNVERIFIED: "o", TOO_CLOSE: "o", NOT_JUDGED: ""}
# Rows that are printed; a page has some sixty.
PRINTED = 300


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


def table(canvas: Canvas, drawing: Drawing) -> Table:
    """Return the table of the variants that are drawn, in the order of their columns of data."""
    record, source = canvas.record, drawing.source_of(SELECTION)
    numbers = record.variants[canvas.drawn].astype(np.int32)
    heads = [Head("variant", "", source.name_of(numbers))]
    cells: list[Sequence[str]] = [[f"<td>{number}" for number in numbers.tolist()]]
    if any(one.count(MET, NOT_MET) for one in canvas.verdicts.items) or canvas.verdicts.whole:
        codes = canvas.verdicts.codes[canvas.drawn].astype(np.int32)
        heads.append(Head("verdict", "", source.name_of(codes), is_number=False))
        cells.append([_verdict(int(code)) for code in codes])
    for column in record.variables:
        heads.append(_head(column, source.name_of(canvas.of(column)), ""))
        cells.append(_variable(canvas, column))
    for column in canvas.outputs:
        heads.append(_head(column, source.name_of(canvas.of(column)), _limits(canvas, column)))
        cells.append(_output(canvas, column))
    rows = "\n".join(f"<tr>{''.join(row)}" for row in zip(*cells, strict=True))
    return Table(heads, Markup(rows), len(numbers), _marked(canvas))


def _head(column: Column, sort: str, limits: str) -> Head:
    below = ", ".join(part for part in (column.of, column.unit, limits) if part)
    return Head(column.title or column.name, below, sort, column.words is None)


def _limits(canvas: Canvas, column: Column) -> str:
    """Return the limit of an output where it is the same for all variants."""
    judged = canvas.main(column)
    if judged is None:
        return ""
    known = np.unique(judged.limits[np.isfinite(judged.limits)])
    if np.ptp(known) > 1e-9 * max(float(np.abs(known).max()), 1.0):  # not rounding alone
        return "limit by variant"
    return f"{RELATIONS[judged.relation]} {digits(float(known[0]))}"


def _variable(canvas: Canvas, column: Column) -> list[str]:
    values = canvas.of(column)
    if column.words is None:
        return [f"<td>{text}" for text in column_texts(values)]
    words = [escape(word) for word in shortened(column.words)]
    return [f"<td class=w><bdi>{words[int(code)]}</bdi>" for code in values]


def _output(canvas: Canvas, column: Column) -> list[str]:
    judged, ends = canvas.main(column), extremes(column)
    codes = np.zeros(len(column.values), dtype=int) if judged is None else judged.codes
    texts = column_texts(canvas.of(column))
    found = []
    for place, text in zip(canvas.drawn.tolist(), texts, strict=True):
        verdict = VERDICTS[int(codes[place])]
        kind = _CLASSES[verdict]
        sign = f"{SIGNS[verdict]} " if kind else ""
        end = f"<small>{('lowest', 'highest')[ends.index(place)]}</small>" if place in ends else ""
        found.append(f"<td{f' class={kind}' if kind else ''}>{sign}{text}{end}")
    return found


def _verdict(code: int) -> str:
    verdict = VERDICTS[code]
    word = "no verdict" if verdict == NOT_JUDGED else verdict
    return f'<td class="w {_CLASSES[verdict]}">{SIGNS[verdict]} {word}'


def _marked(canvas: Canvas) -> list[Marked]:
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
