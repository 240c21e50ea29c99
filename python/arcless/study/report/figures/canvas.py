"""Parts that all figures of a study share: the variants drawn, axes, tips, limits, verdicts."""

from collections.abc import Callable
from functools import cached_property
from textwrap import fill
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import MET, NOT_JUDGED, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE
from arcless.assess.criteria import allowance
from arcless.figures.description import Area, Axis, Curve, Layer, Points, Rules, Scale, Tip
from arcless.figures.description.thinning import every
from arcless.study.report.data.judged import CODES, Judged, Verdicts
from arcless.study.report.data.numbers import digits, form
from arcless.study.report.data.record import Column, Floats, Record, shortened

# Bounds the size of the page whatever the number of variants.
MOST_POINTS = 4000
SELECTION = "variants"
SIGNS = {MET: "✔", NOT_MET: "✘", NOT_MET_UNVERIFIED: "?", TOO_CLOSE: "≈", NOT_JUDGED: "–"}
_FEW_POINTS = 200
# Lines under the pointer: more hide the figure.
_MOST_TIPS = 14
# Parts of the range beyond the first and last value of an axis; names along an axis.
_MARGIN, _MOST_NAMES = 0.06, 40
# Letters that fit along an axis.
_LETTERS = 34
# Relative difference of limits that one line stands for: not seen in a figure.
_SAME_LIMIT = 5e-3
# Verdict → token of its colour, shape.
_LOOKS: dict[str, tuple[str, Any]] = {
    MET: ("met", "circle"),
    NOT_MET: ("not_met", "triangle"),
    NOT_MET_UNVERIFIED: ("open", "down"),
    TOO_CLOSE: ("open", "diamond"),
    NOT_JUDGED: ("soft", "circle"),
}
RELATIONS = {"<=": "at most", ">=": "at least", ">": "above"}


def token_of(verdict: str) -> str:
    """Return the token of the colour of a verdict."""
    return _LOOKS[verdict][0]


class Canvas:
    """A study as its figures draw it.

    Parameters
    ----------
    record
        At least one row must be done.
    verdicts
        Of its rows.
    """

    def __init__(self, record: Record, verdicts: Verdicts) -> None:
        self.record, self.verdicts = record, verdicts
        self.outputs = [out for out in record.outputs if np.isfinite(out.values).any()]
        self.varied = [one for one in record.variables if one.varies and not one.is_drawn]
        self.swept = is_path(record.variables)
        self.drawn = self._drawn()
        self._kept: dict[int, Floats] = {}

    def _drawn(self) -> NDArray[np.intp]:
        """Return the places of the variants that are drawn: evenly chosen, and all extremes."""
        count = len(self.record.done)
        if count <= MOST_POINTS:
            return np.arange(count)
        ends = [place for out in self.outputs for place in extremes(out) if place is not None]
        return np.union1d(every(count, MOST_POINTS - len(ends)), np.array(ends, dtype=np.intp))

    def of(self, column: Column) -> Floats:
        """Return the values of a column for the variants that are drawn, always the same array."""
        return self._kept.setdefault(id(column), column.values[self.drawn])

    def where(self, column: Column, chosen: NDArray[np.bool_]) -> Floats:
        """Return the values of a column for some of the variants drawn, NaN for the others."""
        return np.where(chosen, self.of(column), np.nan)

    def key(self, column: Column) -> str:
        """Return the name of a column in addresses; names in the file may be of any letters."""
        for kind, those in (("variable", self.record.variables), ("output", self.record.outputs)):
            for place, one in enumerate(those, start=1):
                if one is column:
                    return f"{kind}-{place}"
        raise KeyError(column.name)

    def axis(self, column: Column, *, shared: bool = True, include: Any = ()) -> Axis:
        """Return the axis of a column, from its lowest to its highest value."""
        group = self.key(column) if shared else ""
        if column.words is not None:
            names = shortened(column.words)
            ends = (-0.5, len(names) - 0.5)
            if len(names) > _MOST_NAMES:
                shown = set(every(len(names), _MOST_NAMES).tolist())
                names = [name if i in shown else "" for i, name in enumerate(names)]
            return Axis(
                fill(column.heading, _LETTERS), "", *ends, categories=tuple(names), group=group
            )
        known = np.append(column.values[np.isfinite(column.values)], include)
        low, high = float(known.min()), float(known.max())
        margin = _MARGIN * (high - low) or 0.05 * abs(high) or 1.0
        label = fill(column.heading, _LETTERS)
        return Axis(label, column.unit, low - margin, high + margin, group=group)

    def scale(self, output: Column) -> Scale:
        """Return the scale of colours of an output."""
        known = output.values[np.isfinite(output.values)]
        low, high = float(known.min()), float(known.max())
        label = fill(output.heading, _LETTERS)
        return Scale(label, output.unit, low, high if high > low else low + 1.0)

    def output_axis(self, output: Column) -> Axis:
        """Return the axis of an output, with its limits in it where they are not far away."""
        known = output.values[np.isfinite(output.values)]
        low, high = float(known.min()), float(known.max())
        size = max(high - low, 0.05 * abs(high))
        limits = [one.limits[np.isfinite(one.limits)] for one in self.verdicts.of(output)]
        ends = np.concatenate([*limits, known[:0]])
        near = ends[(ends > low - size) & (ends < high + size)]
        return self.axis(output, include=near)

    @cached_property
    def tips(self) -> tuple[Tip, ...]:
        """Lines under the pointer: the variant, its values, its outputs."""
        numbers = self.record.variants[self.drawn].astype(np.int32)
        lines = [Tip("variant", numbers, form="0")]
        for column in (*self.record.variables, *self.outputs):
            if column.words is None:
                lines.append(Tip(column.label, self.of(column), form=form(column.values)))
            else:
                words = shortened(column.words)
                texts = [words[int(code)] for code in self.of(column)]
                lines.append(Tip(column.label, texts, form=""))
        return tuple(lines[:_MOST_TIPS])

    def points(
        self, x: Column, y: Column, *, chosen: NDArray[np.bool_] | None = None, **look: Any
    ) -> Points:
        """Return variants as points that can be selected."""
        few = len(self.drawn) <= _FEW_POINTS
        given = {"size": 7.0 if few else 4.0, "alpha": 0.8 if few else 0.4, **look}
        values = self.of(y) if chosen is None else self.where(y, chosen)
        return Points(self.of(x), values, tips=self.tips, selection=SELECTION, **given)

    def by_verdict(self, x: Column, y: Column, judged: Judged | None) -> list[Layer]:
        """Return variants as points, told apart by the verdict on them where there is one."""
        if judged is None:
            return [self.points(x, y, colour="series_1")]
        codes = judged.codes[self.drawn]
        layers: list[Layer] = []
        for verdict, (colour, shape) in _LOOKS.items():
            chosen = codes == CODES[verdict]
            if chosen.any():
                layers.append(
                    self.points(x, y, chosen=chosen, colour=colour, shape=shape,
                                name=f"{verdict}, {int(chosen.sum())}")
                )  # fmt: skip
        return layers

    def main(self, output: Column) -> Judged | None:
        """Return the criterion of an output by which its variants are coloured."""
        return next(iter(self.verdicts.of(output)), None)

    def limits(self, x: Column, output: Column) -> tuple[list[Layer], list[str]]:
        """Return the limits of an output over a variable, and sentences about them."""
        layers: list[Layer] = []
        words = []
        for one in self.verdicts.of(output):
            found, text = self._limit(x, one)
            layers += found
            words.append(text)
        return layers, words

    def _limit(self, x: Column, judged: Judged) -> tuple[list[Layer], str]:
        """Return the limit of one criterion over a variable, and a sentence about it."""
        known = np.isfinite(judged.limits) & np.isfinite(x.values)
        limits, places = judged.limits[known], x.values[known]
        marks = ", ".join(judged.marks)
        name = f"limit, {judged.title}"
        name += f" (tolerance {judged.tolerance:g} {judged.unit})" if judged.tolerance else ""
        name += "" if judged.decides else f" (mark {marks}, decides nothing)"
        look: dict[str, Any] = {"colour": "limit", "name": name}
        line = {**look, "width": 1.6, "dash": "solid" if judged.decides else "dotted"}
        text = (
            f"Limit of {judged.heading}: {RELATIONS[judged.relation]}"
            f" {limits_of(judged)} ({judged.how}; mark {marks})."
        )
        size = max(float(np.abs(limits).max()), 1e-12)
        if np.ptp(limits) <= _SAME_LIMIT * size:
            return [Rules(axis="y", at=limits[:1], **line)], text
        levels, owners = np.unique(places, return_inverse=True)
        low, high = np.full(levels.size, np.inf), np.full(levels.size, -np.inf)
        np.minimum.at(low, owners, limits)
        np.maximum.at(high, owners, limits)
        repeats = x.words is None and levels.size < places.size
        single = np.max(high - low) <= _SAME_LIMIT * size
        if single and (repeats or self.swept or (x.words is None and _is_line(levels, low, size))):
            return [Curve(levels, 0.5 * (low + high), **line)], text
        if repeats:
            return [Area(levels, low, high, alpha=0.16, **look)], f"{text} It differs by variant."
        return [], f"{text} It differs by variant, and is not drawn."


def extremes(output: Column) -> tuple[int | None, int | None]:
    """Return the places of the lowest and the highest value; None where all are equal."""
    if not output.varies:
        return None, None
    return int(np.nanargmin(output.values)), int(np.nanargmax(output.values))


def span_of(values: Floats, unit: str, shown: Callable[[float], str] = digits) -> str:
    """Return the range of some values in words."""
    known = values[np.isfinite(values)]
    if not known.size:
        return "no value"
    low, high = shown(float(known.min())), shown(float(known.max()))
    return (low if low == high else f"{low} to {high}") + (f" {unit}" if unit else "")


def limits_of(judged: Judged, shown: Callable[[float], str] = digits, unit: bool = True) -> str:
    """Return the range of a criterion's limits in words, with the tolerance: ``116.9 + 1 N``."""
    known, label = span_of(judged.limits, "", shown), judged.unit if unit else ""
    beyond = allowance({"tolerance": judged.tolerance, "limit": known, "relation": judged.relation})
    if beyond and " " in known:  # the tolerance is of both ends
        known = f"({known})"
    return f"{known}{beyond} {label}".rstrip()


def is_path(variables: list[Column]) -> bool:
    """Return whether all variables rise from variant to variant: a sweep, drawn as a line."""
    varied = [variable for variable in variables if variable.varies]
    return bool(varied) and all(
        variable.words is None and bool((np.diff(variable.values) > 0.0).all())
        for variable in varied
    )


def _is_line(places: Floats, values: Floats, size: float) -> bool:
    """Return whether each value lies between its neighbours: a function of the place."""
    if values.size < 3:  # noqa: PLR2004 - two are always on a line
        return False
    part = (places[1:-1] - places[:-2]) / (places[2:] - places[:-2])
    between = values[:-2] + part * (values[2:] - values[:-2])
    return bool(np.max(np.abs(values[1:-1] - between)) <= _SAME_LIMIT * size)
