"""Figures of a study: outputs over variables, variables over each other, outputs over each other.

All draw from one source of columns: what is selected in one of them is so in all, and in the table.
"""

from typing import Any

import numpy as np

from arcless.report.drawing.bokeh_objects import Field, Model, columns
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import FADED, INK, add_hover, colour, figure, plain, single
from arcless.report.drawing.thinning import every
from arcless.study.report.effects import effect
from arcless.study.report.record import Column, Record, shortened
from arcless.study.report.speeds import SpeedMarks

# Bounds the size of the page whatever the number of variants, variables and outputs.
MOST_POINTS = 4000
MOST_VARIABLES, MOST_OUTPUTS = 6, 6
PAIRED_VARIABLES, PAIRED_OUTPUTS = 4, 3
_MOST_TICKS = 40
_FEW_POINTS = 200
# Letters that fit side by side under a figure.
_LETTERS = 36


class Drawing:
    """The figures of a study.

    Parameters
    ----------
    record
        At least one row must be done.
    speeds
        Resonance speeds, drawn where the speed is an axis.
    """

    def __init__(self, record: Record, speeds: SpeedMarks | None = None) -> None:
        self.record, self.speeds = record, speeds
        self.outputs = [out for out in record.outputs if np.isfinite(out.values).any()]
        self.drawn = every(len(record.done), MOST_POINTS)
        self.source = columns(self._columns())
        self._ranges: dict[str, Model] = {}

    def effects(self) -> list[tuple[Column, list[Figure]]]:
        """Return, for each output, a figure over each variable; the stronger ones of many."""
        found = []
        for output in self.outputs[:MOST_OUTPUTS]:
            varied = self._strongest(output, MOST_VARIABLES)
            figures = [self._effect(variable, output) for variable in varied]
            if figures:
                found.append((output, figures))
        return found

    def pairs(self) -> list[tuple[Column, list[Figure]]]:
        """Return, for each output, figures of two variables each, coloured by the output."""
        found = []
        for output in [out for out in self.outputs if out.varies][:PAIRED_OUTPUTS]:
            chosen = self._strongest(output, PAIRED_VARIABLES)
            figures = [
                self._pair(one, other, output)
                for place, one in enumerate(chosen)
                for other in chosen[place + 1 :]
            ]
            if figures:
                found.append((output, figures))
        return found

    def fronts(self) -> list[Figure]:
        """Return figures of two outputs each."""
        chosen = [out for out in self.outputs if out.varies][:PAIRED_VARIABLES]
        return [
            self._scatter(one, other, f"{other.name} against {one.name}")[0]
            for place, one in enumerate(chosen)
            for other in chosen[place + 1 :]
        ]

    def _strongest(self, output: Column, most: int) -> list[Column]:
        """Return the variables that explain most of an output, in the order of the file."""
        varied = [one for one in self.record.variables if one.varies and not one.is_drawn]
        if len(varied) <= most:
            return varied
        strongest = sorted(varied, key=lambda one: -_share(one, output))[:most]
        return [one for one in varied if one in strongest]

    def _columns(self) -> dict[str, Any]:
        data: dict[str, Any] = {"variant": self.record.variants[self.drawn].astype(np.int32)}
        for column in (*self.record.variables, *self.outputs):
            data[self.key(column)] = single(column.values[self.drawn])
            if column.words is not None:
                words = shortened(column.words)
                data[f"{self.key(column)} word"] = [
                    plain(words[int(code)]) for code in column.values[self.drawn]
                ]
        return data

    def key(self, column: Column) -> str:
        """Return the name of a column in the source; an output may have that of a variable."""
        for kind, those in (("v", self.record.variables), ("o", self.outputs)):
            for place, one in enumerate(those):
                if one is column:
                    return f"{kind}{place}"
        raise KeyError(column.name)

    def shown(self, column: Column) -> tuple[str, str]:
        """Return name and value of a column as a tooltip shows them.

        The value is a template, whose marks take raw HTML from the data: no word of a user may
        stand in it. The name is plain text.
        """
        key = self.key(column)
        value = f"@{key}{{0.[00000]}}" if column.words is None else f"@{{{key} word}}"
        return plain(column.label), value

    def _effect(self, variable: Column, output: Column) -> Figure:
        fig, _ = self._scatter(variable, output, f"{output.name} over {variable.name}")
        if self.speeds is not None and variable is self.speeds.column:
            self.speeds.draw(fig, self._range(output))
        found = effect(variable, output)
        if is_path(self.record.variables):
            ends = (self.key(variable), self.key(output))
            fig.draw("Line", self.source, *ends, unselected=0.3, color=colour(0), line_width=1.5)
        elif found is not None:
            error = {"low": found.mean - found.error, "high": found.mean + found.error}
            means = columns({"x": found.x, "mean": found.mean, **error})
            style: Any = {"color": colour(1), "unselected": FADED}
            fig.draw("Segment", means, "x", "low", "x", "high", line_width=2, **style)
            if variable.words is None:
                fig.draw("Line", means, "x", "mean", line_width=2, **style)
            dots = fig.draw("Scatter", means, "x", "mean", size=7, **style)
            name = f"mean, {output.unit}" if output.unit else "mean"
            add_hover(fig, [dots], [(plain(name), "@mean{0.[00000]}")])
        return fig

    def _pair(self, one: Column, other: Column, output: Column) -> Figure:
        from bokeh.palettes import Viridis256

        known = output.values[np.isfinite(output.values)]
        mapper = Model(
            "LinearColorMapper",
            palette=Viridis256,
            low=float(known.min()),
            high=float(known.max()),
            nan_color="#d7dade",
        )
        mapped = Field(self.key(output), mapper)
        title = f"{output.name} by colour"
        fig, _ = self._scatter(one, other, title, color=mapped, alpha=0.9, size=7)
        bar = Model(
            "ColorBar",
            color_mapper=mapper,
            width=10,
            padding=4,
            label_standoff=6,
            title=plain(output.unit) or None,
            title_text_font_style="normal",
            major_label_text_font_size="11px",
        )
        fig.right.append(bar)
        return fig

    def _scatter(self, x: Column, y: Column, title: str, **style: Any) -> tuple[Figure, Model]:
        fig = figure(
            plain(title),
            plain(x.label),
            plain(y.label),
            height=270,
            selects=True,
            x_range=self._range(x),
            y_range=self._range(y),
        )
        fig.toolbar.autohide = True
        few = len(self.drawn) <= _FEW_POINTS
        plainly = {"color": colour(0), "alpha": 0.7 if few else 0.35, "size": 6 if few else 4}
        dots = fig.draw(
            "Scatter", self.source, self.key(x), self.key(y), line_color=None,
            unselected=0.08, **{**plainly, **style},
        )  # fmt: skip
        tips = dict([self.shown(column) for column in (*self.record.variables, *self.outputs)][:14])
        add_hover(fig, [dots], [("variant", "@variant"), *tips.items()], limit=3)
        _words_at(fig.xaxis, x)
        _words_at(fig.yaxis, y)
        return fig, dots

    def _range(self, column: Column) -> Model:
        """Return the range that all figures share in which a column is an axis."""
        key = self.key(column)
        if key not in self._ranges:
            known = column.values[np.isfinite(column.values)]
            low, high = float(known.min()), float(known.max())
            if column.words is not None:
                margin = 0.5
            else:
                margin = 0.06 * (high - low) or 0.05 * abs(high) or 1.0
            self._ranges[key] = Model("Range1d", start=low - margin, end=high + margin)
        return self._ranges[key]


def is_path(variables: list[Column]) -> bool:
    """Return whether all variables rise from variant to variant: a sweep, drawn as a line."""
    varied = [variable for variable in variables if variable.varies]
    return bool(varied) and all(
        variable.words is None and bool((np.diff(variable.values) > 0.0).all())
        for variable in varied
    )


def _share(variable: Column, output: Column) -> float:
    found = effect(variable, output)
    return 0.0 if found is None else found.share


def _words_at(axis: Model, column: Column) -> None:
    """Write words at an axis in place of numbers."""
    if column.words is None:
        return
    words = [plain(word) for word in shortened(column.words)]
    kept = [int(place) for place in every(len(words), _MOST_TICKS)]
    axis.ticker = Model("FixedTicker", ticks=kept)
    axis.major_label_overrides = {place: words[place] for place in kept}
    axis.major_label_text_color = INK
    if sum(map(len, words)) > _LETTERS:
        axis.major_label_orientation = 0.6
