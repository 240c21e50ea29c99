"""Axes of a figure: ranges, ticks, grid, and the scale of colours."""

import numpy as np
from matplotlib import ticker
from matplotlib.axes import Axes
from matplotlib.axis import Axis as Drawn
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize

from arcless.display.numbers import real_minus
from arcless.figures.description import (
    Area,
    Axis,
    Bars,
    Curve,
    Figure,
    Layer,
    Map,
    Points,
    Scale,
    Segments,
    Texts,
)
from arcless.figures.description.tokens import Scheme, colour, shades
from arcless.figures.paper.settings import LABEL_PT, THIN_PT, TICK_PT

# Part of the range of the data that an end without a given value stays away from them.
PADDING = 0.02
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_MOST_TICKS = 8


def shown(figure: Figure) -> list[Layer]:
    """Return the layers that are drawn: not those that a page hides at first."""
    return [layer for layer in figure.layers if not layer.hidden]


def set_up(axes: Axes, figure: Figure, scheme: Scheme) -> None:
    """Give axes the ranges, ticks, titles and look of a figure."""
    layers = shown(figure)
    gridded = not any(isinstance(layer, Map) for layer in layers)
    for which, axis, drawn in (("x", figure.x, axes.xaxis), ("y", figure.y, axes.yaxis)):
        if axis.logarithmic:
            axes.set(**{f"{which}scale": "log"})
        axes.set(**{f"{which}lim": ends(axis, layers, which)})
        drawn.set_label_text(axis.title, size=LABEL_PT, color=colour("ink", scheme),
                             parse_math=False)  # fmt: skip
        _ticks(drawn, axis)
        drawn.set_tick_params(
            labelsize=TICK_PT, labelcolor=colour("soft", scheme), color=colour("rule", scheme),
            width=THIN_PT, length=3.0,
        )  # fmt: skip
        if gridded:
            drawn.grid(which="major", color=colour("grid", scheme), linewidth=THIN_PT)
    axes.set_axisbelow(True)
    axes.set_facecolor(colour("paper", scheme))
    for side, spine in axes.spines.items():
        spine.set(visible=side in ("left", "bottom"), color=colour("rule", scheme),
                  linewidth=THIN_PT)  # fmt: skip


def mappable(scale: Scale, scheme: Scheme) -> ScalarMappable:
    """Return the colours of a scale, with that of values below it."""
    order = shades(scale.colours)
    under = colour(scale.under, scheme) if scale.under else order[0]
    colours = ListedColormap(list(order)).with_extremes(bad=(0, 0, 0, 0), under=under)
    return ScalarMappable(Normalize(scale.low, scale.high), colours)


def add_bar(axes: Axes, scale: Scale, scheme: Scheme) -> None:
    """Draw the scale of colours to the right of axes."""
    figure = axes.get_figure(root=False)
    assert figure is not None
    bar = figure.colorbar(mappable(scale, scheme), ax=axes, pad=0.015, fraction=0.05, aspect=28)
    bar.set_label(scale.title, size=LABEL_PT, color=colour("ink", scheme), parse_math=False)
    bar.ax.tick_params(labelsize=TICK_PT, labelcolor=colour("soft", scheme), length=0)
    bar.outline.set_visible(False)


def ends(axis: Axis, layers: list[Layer], which: str) -> tuple[float, float]:
    """Return the ends of an axis: those given, else around the data."""
    if axis.low is not None and axis.high is not None:
        return axis.low, axis.high
    values = np.concatenate(
        [np.empty(0), *(np.ravel(v) for one in layers for v in _data(one, which))]
    )
    values = values[np.isfinite(values) & (values > 0.0 if axis.logarithmic else True)]
    low, high = (float(values.min()), float(values.max())) if values.size else (1.0, 2.0)
    if axis.logarithmic:
        factor = (high / low) ** PADDING if high > low else 2.0
        low, high = low / factor, high * factor
    else:
        margin = PADDING * (high - low) or 0.5 * max(abs(high), 1.0)
        low, high = low - margin, high + margin
    return low if axis.low is None else axis.low, high if axis.high is None else axis.high


def _data(layer: Layer, which: str) -> list[np.ndarray]:
    """Return what a layer draws along an axis; strips and rules take the range that is there."""
    along = which == "x"
    match layer:
        case Curve() | Points() | Texts():
            found = [layer.x if along else layer.y]
        case Area():
            found = [layer.x] if along else [layer.low, layer.high]
        case Segments():
            found = [layer.x0, layer.x1] if along else [layer.y0, layer.y1]
        case Bars():
            found = [layer.left, layer.right] if along else [layer.low, layer.high]
        case Map():
            found = [np.array(layer.x if along else layer.y)]
        case _:
            found = []
    return [np.asarray(values, dtype=float) for values in found]


def _ticks(drawn: Drawn, axis: Axis) -> None:
    if axis.categories:
        named = [(place, name) for place, name in enumerate(axis.categories) if name]
        drawn.set_ticks([place for place, _ in named])
        drawn.set_ticklabels([name for _, name in named], parse_math=False)
    elif axis.logarithmic:
        drawn.set_major_locator(ticker.LogLocator(numticks=_MOST_TICKS))
        drawn.set_major_formatter(ticker.FuncFormatter(_power))
        drawn.set_minor_locator(ticker.NullLocator())
    else:
        whole = axis.form == "0"
        drawn.set_major_locator(ticker.MaxNLocator(_MOST_TICKS, steps=[1, 2, 5, 10], integer=whole))
        if axis.form:
            decimals = len(axis.form.partition(".")[2])
            drawn.set_major_formatter(
                ticker.FuncFormatter(lambda value, _: real_minus(f"{value:.{decimals}f}"))
            )
        else:
            drawn.set_major_formatter(ticker.ScalarFormatter(useOffset=False, useMathText=False))


def _power(value: float, _place: int | None = None) -> str:
    """Return a power of ten as text: formulas would not stay text in an SVG."""
    exponent = round(np.log10(value))
    if not np.isclose(value, 10.0**exponent):
        return f"{value:g}"
    return f"10{str(exponent).translate(_RAISED)}"
