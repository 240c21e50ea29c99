"""Figures of a study: outputs over variables, two variables at a time, outputs over each other.

All draw from one source of columns: variants selected in one are so in all, and in the table.
"""

from typing import Any

import numpy as np

from arcless.figures.description import Curve, Figure, Layer, Points, Segments, Tip
from arcless.study.designs.samples import Sample
from arcless.study.report.data.effects import effect
from arcless.study.report.data.judged import VERDICTS, Judged
from arcless.study.report.data.numbers import form
from arcless.study.report.data.record import Column
from arcless.study.report.figures.canvas import Canvas, span_of
from arcless.study.report.figures.speeds import SpeedMarks

# Bounds the size of the page whatever the number of variables and outputs.
MOST_VARIABLES, MOST_OUTPUTS = 6, 6
PAIRED_VARIABLES, PAIRED_OUTPUTS = 4, 3
HEIGHT = 300


class Scatters:
    """The figures of a study whose variants are points.

    Parameters
    ----------
    canvas
        The study.
    speeds
        Resonance speeds, drawn where the speed is an axis.
    """

    def __init__(self, canvas: Canvas, speeds: SpeedMarks | None = None) -> None:
        self.canvas, self.speeds = canvas, speeds
        self._sampled = isinstance(canvas.record.study.design, Sample)

    def effects(self) -> list[tuple[Column, list[Figure]]]:
        """Return, for each output, a figure over each variable; the stronger ones of many."""
        found = []
        for output in self.canvas.outputs[:MOST_OUTPUTS]:
            varied = self._strongest(output, MOST_VARIABLES)
            if varied:
                found.append((output, [self._effect(variable, output) for variable in varied]))
        return found

    def pairs(self) -> list[tuple[Column, list[Figure]]]:
        """Return, for each output, figures of two variables each, coloured by the output."""
        found: list[tuple[Column, list[Figure]]] = []
        if self.canvas.swept:
            return found  # all variables rise together
        for output in [out for out in self.canvas.outputs if out.varies][:PAIRED_OUTPUTS]:
            chosen = self._strongest(output, PAIRED_VARIABLES)
            figures = [self._pair(one, other, output) for one, other in _two_of(chosen)]
            if figures:
                found.append((output, figures))
        return found

    def fronts(self) -> list[Figure]:
        """Return figures of two outputs each."""
        chosen = [out for out in self.canvas.outputs if out.varies][:PAIRED_VARIABLES]
        return [
            Figure(
                f"front-{place}", f"{other.heading} against {one.heading}",
                self.canvas.axis(one), self.canvas.axis(other),
                [self.canvas.points(one, other, colour="series_1")],
                alt=f"{range_words(other)} against {range_words(one)}, a point for each variant.",
                height=HEIGHT,
            )
            for place, (one, other) in enumerate(_two_of(chosen))
        ]  # fmt: skip

    def _strongest(self, output: Column, most: int) -> list[Column]:
        """Return the variables that explain most of an output; of a sample the strongest first."""
        varied = self.canvas.varied
        ordered = sorted(varied, key=lambda one: -_share(one, output))[:most]
        return ordered if self._sampled else [one for one in varied if one in ordered]

    def _effect(self, variable: Column, output: Column) -> Figure:
        canvas = self.canvas
        judged = canvas.main(output)
        limits, words = canvas.limits(variable, output)
        axis = canvas.output_axis(output)
        layers: list[Layer] = [*limits]
        marked = self.speeds is not None and variable is self.speeds.column
        if marked and self.speeds is not None:
            layers += self.speeds.layers(axis)
        if canvas.swept:
            layers.append(Curve(variable.values, output.values, colour="series_1", width=1.6))
        elif self._sampled:
            layers += _means(variable, output)
        layers += canvas.by_verdict(variable, output, judged)
        about = [] if output.about in (output.title, output.name) else [sentence(output.about)]
        return Figure(
            f"{canvas.key(output)}-over-{canvas.key(variable)}",
            f"{output.heading} over {variable.heading}",
            canvas.axis(variable), axis, layers,
            caption=" ".join([*about, *words]),
            alt=f"{range_words(output)}, over {_range_of(variable)}. {verdict_words(judged)}".rstrip(),
            height=HEIGHT + 60 if marked else HEIGHT,
        )  # fmt: skip

    def _pair(self, one: Column, other: Column, output: Column) -> Figure:
        key = self.canvas.key
        points = self.canvas.points(one, other, values=self.canvas.of(output), alpha=0.9, size=8.0)
        return Figure(
            f"{key(output)}-by-{key(one)}-and-{key(other)}",
            f"{output.heading} by colour",
            self.canvas.axis(one), self.canvas.axis(other), [points],
            alt=f"{range_words(output)}, by colour over {one.heading} and {other.heading}.",
            height=HEIGHT,
            scale=self.canvas.scale(output),
        )  # fmt: skip


def _range_of(variable: Column) -> str:
    if variable.words is not None:
        return f"{len(variable.words)} values of {variable.heading}"
    return range_words(variable)


def verdict_words(judged: Judged | None) -> str:
    """Return how many variants meet a criterion, in a sentence; empty without one."""
    if judged is None:
        return ""
    counts = [f"{judged.count(one)} {one}" for one in VERDICTS if judged.count(one)]
    return f"{judged.title}: {', '.join(counts)}."


def _means(variable: Column, output: Column) -> list[Layer]:
    """Return the means of a sample at each value, or in each part, with their standard errors."""
    found = effect(variable, output)
    if found is None:
        return []
    name = "mean of the variants ± standard error"
    look: dict[str, Any] = {"colour": "series_2", "name": name}
    error = np.nan_to_num(found.error)
    layers: list[Layer] = [
        Segments(found.x, found.mean - error, found.x, found.mean + error, width=2.0, **look)
    ]
    if variable.words is None:
        layers.append(Curve(found.x, found.mean, width=2.0, **look))
    tip = Tip(f"mean of {output.label}", found.mean, form=form(found.mean))
    layers.append(Points(found.x, found.mean, size=7.0, shape="diamond", tips=(tip,), **look))
    return layers


def _two_of(columns: list[Column]) -> list[tuple[Column, Column]]:
    return [(one, other) for place, one in enumerate(columns) for other in columns[place + 1 :]]


def _share(variable: Column, output: Column) -> float:
    found = effect(variable, output)
    return 0.0 if found is None else found.share


def range_words(output: Column) -> str:
    """Return an output with its range, in words."""
    return f"{output.heading} from {span_of(output.values, output.unit)}"


def sentence(text: str) -> str:
    """Return a text as a sentence."""
    return text[:1].upper() + text[1:] + ("" if text.endswith((".", "!", "?")) else ".")
