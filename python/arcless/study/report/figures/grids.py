"""Figures of a study of two variables on a grid: lines, one for each value, and a map of cells."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import MET, NOT_JUDGED
from arcless.figures.description import (
    Area,
    Axis,
    Curve,
    Figure,
    Layer,
    Map,
    Points,
    Segments,
    Texts,
)
from arcless.figures.description.thinning import every
from arcless.figures.description.tokens import of_series
from arcless.study.designs import Grid
from arcless.study.report.data.judged import CODES, VERDICTS, Judged
from arcless.study.report.data.numbers import column_texts, digits
from arcless.study.report.data.record import Column, Floats, shortened
from arcless.study.report.figures.canvas import SELECTION, SIGNS, Canvas, token_of
from arcless.study.report.figures.contours import contour
from arcless.study.report.figures.scatters import range_words, sentence, verdict_words
from arcless.study.report.figures.speeds import FIELD, SpeedMarks

# Curves that are told apart in one figure; cells along an axis that have a sign, and a number.
MOST_CURVES = 8
_MOST_SIGNS, _MOST_NUMBERS, _MOST_NAMES = 40, 12, 24
_SHAPES: tuple[Any, ...] = ("circle", "triangle", "diamond", "down")
_CURVES_HEIGHT, _CELL, _LOW_CELL, _BARE_CELL, _LEAST, _MOST = 320, 50, 19, 13, 240, 640
# Part of the order of colours from which on dark text is read better than light text.
_BRIGHT = 0.62


@dataclass(frozen=True)
class Factor:
    """A variable on the grid: its values, and the place of each variant's value among them."""

    column: Column
    levels: Floats
    places: NDArray[np.intp]

    @property
    def names(self) -> list[str]:
        """The values as they are typed, with the unit."""
        if self.column.words is not None:
            words = shortened(self.column.words)
            return [words[int(code)] for code in self.levels]
        return [f"{digits(float(value))} {self.column.unit}".rstrip() for value in self.levels]

    @property
    def axis(self) -> Axis:
        """The axis of a map: cells of equal size, named by their values."""
        names = [name.removesuffix(f" {self.column.unit}") for name in self.names]
        step = -(-len(names) // _MOST_NAMES)
        names = ["" if place % step else name for place, name in enumerate(names)]
        unit = self.column.unit
        return Axis(self.column.heading, unit, -0.5, len(names) - 0.5, categories=tuple(names))


def factor(column: Column, given: tuple[Any, ...]) -> Factor:
    """Return a variable as a factor of all its values in SI, also those that have no outcome."""
    if column.words is not None:
        return Factor(column, np.arange(len(column.words), dtype=float), column.values.astype(int))
    levels = np.unique(np.array(given, dtype=float) / column.scale)
    return Factor(column, levels, np.searchsorted(levels, column.values))


def factors(canvas: Canvas) -> tuple[Factor, Factor] | None:
    """Return the factor along the axis and the one of the curves; None where there are not two.

    The speed is along the axis, otherwise the number with more values.
    """
    study, varied = canvas.record.study, canvas.varied
    if not isinstance(study.design, Grid) or len(varied) != 2:  # noqa: PLR2004 - two factors
        return None
    fields = {axis.name: axis.field for axis in study.axes}
    levels = {axis.name: axis.levels or () for axis in study.axes}
    found = sorted(
        (factor(one, levels[one.name]) for one in varied),
        key=lambda one: (
            one.column.words is None, fields[one.column.name] == FIELD, one.levels.size
        ),
    )  # fmt: skip
    return found[1], found[0]


class Grids:
    """Figures of a study of two factors.

    Parameters
    ----------
    canvas
        The study.
    along, other
        The factors.
    speeds
        Resonance speeds, drawn where the speed is the axis.
    """

    def __init__(
        self, canvas: Canvas, along: Factor, other: Factor, speeds: SpeedMarks | None = None
    ) -> None:
        self.canvas, self.along, self.other, self.speeds = canvas, along, other, speeds

    def figures(self, output: Column) -> list[Figure]:
        """Return the map and the curves of an output."""
        found = [self.map(output)]
        return [*found, self.curves(output)] if self.along.column.words is None else found

    def curves(self, output: Column) -> Figure:
        """Return an output over one factor, a curve for each value of the other."""
        canvas, x, other = self.canvas, self.along.column, self.other
        axis = canvas.output_axis(output)
        layers, words = canvas.limits(x, output)
        of_curves = any(isinstance(layer, Area) for layer in layers)
        layers = [layer for layer in layers if not isinstance(layer, Area)]
        judged = canvas.main(output) if of_curves else None
        if judged is not None:
            words.append("Dotted: the limit of each curve.")
        marked = self.speeds is not None and x is self.speeds.column
        if marked and self.speeds is not None:
            layers = [*self.speeds.layers(axis), *layers]
        computed = np.unique(other.places)
        shown = computed[every(computed.size, MOST_CURVES)]
        drawn = other.places[canvas.drawn]
        pieces: list[Layer] = []
        for place, level in enumerate(shown):
            name = f"{other.column.heading}: {other.names[level]}"
            rows = np.flatnonzero(other.places == level)
            rows = rows[np.argsort(x.values[rows], kind="stable")]
            look: dict[str, Any] = {"colour": of_series(place), "name": name}
            if judged is not None:
                limit = judged.limits[rows]
                pieces.append(Curve(x.values[rows], limit, dash="dotted", width=1.4, **look))
            pieces += [
                Curve(x.values[rows], output.values[rows], width=1.8, **look),
                canvas.points(x, output, chosen=drawn == level, alpha=1.0,
                              shape=_SHAPES[place % len(_SHAPES)], **look),
            ]  # fmt: skip
        if shown.size < computed.size:
            words.append(f"{shown.size} of {computed.size} values of {other.column.name} are"
                         " drawn; the map has all.")  # fmt: skip
        return Figure(
            f"{canvas.key(output)}-curves", f"{output.heading} over {x.heading}",
            canvas.axis(x), axis, [*layers, *reversed(pieces)],
            caption=" ".join([f"A curve for each value of {other.column.heading}.", *words]),
            alt=f"{range_words(output)}, over {x.heading}, a curve for each value of"
            f" {other.column.heading}: {', '.join(other.names[i] for i in shown)}.",
            height=_CURVES_HEIGHT,
        )  # fmt: skip

    def map(self, output: Column) -> Figure:
        """Return an output as a map of cells, with the verdict in each."""
        canvas, along, other = self.canvas, self.along, self.other
        judged = canvas.main(output)
        values = self._cells(output.values)
        rows, columns = values.shape
        known = values[np.isfinite(values)]
        low, high = float(known.min()), float(known.max())
        layers: list[Layer] = [Map((-0.5, columns - 0.5), (-0.5, rows - 0.5), values, name="")]
        if judged is not None:
            layers += self._contour(judged)
        layers += self._signs(judged, values, (low, high))
        signs = "" if judged is None else f"Signs: verdict on {judged.title}. "
        limit = "" if judged is None else self.canvas.limits(along.column, output)[1][0]
        about = "" if output.about in (output.title, output.name) else f"{sentence(output.about)} "
        return Figure(
            f"{canvas.key(output)}-map",
            f"{output.heading} by {along.column.heading} and {other.column.heading}",
            along.axis, other.axis, layers,
            caption=f"{about}{signs}{limit}".strip(),
            alt=f"{range_words(output)}, as a map over {along.column.heading} and"
            f" {other.column.heading}. {verdict_words(judged)}".rstrip(),
            height=self._height(rows, columns, signed=judged is not None),
            scale=canvas.scale(output),
        )  # fmt: skip

    @staticmethod
    def _height(rows: int, columns: int, *, signed: bool) -> int:
        numbered = max(rows, columns) <= _MOST_NUMBERS
        cell = _CELL if numbered else _LOW_CELL if signed else _BARE_CELL
        return min(max(cell * rows + 70, _LEAST), _MOST)

    def _cells(self, values: Any) -> Floats:
        """Return values of the variants by row and column of the map; NaN for none."""
        cells = np.full((self.other.levels.size, self.along.levels.size), np.nan)
        cells[self.other.places, self.along.places] = values
        return cells

    def _contour(self, judged: Judged) -> list[Layer]:
        """Return the line along which value and limit are equal."""
        fields = {axis.name: axis.levels or () for axis in self.canvas.record.study.axes}
        if any(
            isinstance(level, str)
            for one in (self.along, self.other) for level in fields[one.column.name]
        ):  # fmt: skip
            return []  # words have no order
        found = contour(self._cells(judged.values - judged.limits))
        if not found.size:
            return []
        x0, y0, x1, y1 = found.T
        return [
            Segments(x0, y0, x1, y1, colour="paper", width=6.0, alpha=0.8),
            Segments(x0, y0, x1, y1, colour="limit", width=2.6,
                     name=f"value at the limit, {judged.title}"),
        ]  # fmt: skip

    def _signs(
        self, judged: Judged | None, values: Floats, ends: tuple[float, float]
    ) -> list[Layer]:
        """Return the sign of the verdict and the number of each cell, as far as there is room."""
        rows, columns = values.shape
        numbered = columns <= _MOST_NUMBERS and rows <= _MOST_NUMBERS
        signed = max(rows, columns) <= _MOST_SIGNS
        raised = 0.18 if numbered else 0.0
        backs = judged is not None and signed
        layers: list[Layer] = [self._handles(raised, backs=backs)]
        if judged is not None and signed:
            codes = np.full(values.shape, CODES[NOT_JUDGED])
            codes[self.other.places, self.along.places] = judged.codes
            for code, verdict in enumerate(VERDICTS):
                y, x = np.nonzero(codes == code)
                if x.size:
                    layers.append(
                        Texts(x.astype(float), y + raised, [SIGNS[verdict]] * x.size, size=13.0,
                              colour=token_of(verdict), name=_legend(verdict, x.size))
                    )  # fmt: skip
        if numbered:
            layers += _numbers(values, ends, raised - 0.4)
        return layers

    def _handles(self, raised: float, *, backs: bool) -> Points:
        """Return a mark in each cell that shows its numbers, can be selected, and backs a sign."""
        drawn = self.canvas.drawn
        x = self.along.places[drawn].astype(float)
        y = self.other.places[drawn] + raised
        return Points(x, y, size=17.0 if backs else 4.0, colour="paper" if backs else "on_dark",
                      alpha=0.92, tips=self.canvas.tips, selection=SELECTION)  # fmt: skip


def _legend(verdict: str, count: int) -> str:
    word = "no value" if verdict == NOT_JUDGED else verdict
    return f"{SIGNS[verdict]} {word}, {count}" if verdict != MET else f"{SIGNS[MET]} met, {count}"


def _numbers(values: Floats, ends: tuple[float, float], raised: float) -> list[Layer]:
    """Return the number of each cell, light on dark colours and dark on bright ones."""
    y, x = np.nonzero(np.isfinite(values))
    found = values[y, x]
    texts = np.array(column_texts(found))
    bright = found > ends[0] + _BRIGHT * (ends[1] - ends[0])
    return [
        Texts(x[chosen].astype(float), y[chosen] + raised, list(map(str, texts[chosen])),
              size=11.0, colour=colour)
        for colour, chosen in (("on_bright", bright), ("on_dark", ~bright))
        if chosen.any()
    ]  # fmt: skip
