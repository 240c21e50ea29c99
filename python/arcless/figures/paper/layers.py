"""Layers of a figure as what matplotlib draws."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection

from arcless.figures.description import (
    Area,
    Bars,
    Curve,
    Layer,
    Map,
    Points,
    Rules,
    Segments,
    Strip,
    Texts,
)
from arcless.figures.description.tokens import Scheme, colour
from arcless.figures.paper.settings import LINE, MARK, TEXT

SHAPES = {"circle": "o", "tick": "|", "triangle": "^", "down": "v", "diamond": "d", "cross": "x"}
_LINED = ("tick", "cross")
_DASHES = {"dashed": (7.0, 4.0), "dotted": (2.0, 3.0)}
_BASELINES = {"top": "top", "middle": "center", "bottom": "bottom"}
# Order of drawing: strips below the grid, which is at 0.5, rules above it, other layers in turn.
_STRIPS, _RULES, _FIRST, _STEP = 0.4, 1.0, 2.0, 0.01
_MAPS, _OVER_MAPS = 0.2, 3.0
_ON_COLOURS = ("on_dark", "on_bright")
_PATCH = 0.7  # opacity of the paper below a text


def add(axes: Axes, layers: list[Layer], scheme: Scheme, colours: ScalarMappable | None) -> None:
    """Draw layers into axes, the first one lowest.

    Strips lie below the grid and rules below what is drawn with numbers, whatever their place among
    the layers; over a map both lie above, where they are seen.
    """
    mapped = any(isinstance(layer, Map) for layer in layers)
    for place, layer in enumerate(layers):
        order = _FIRST + _STEP * place
        if isinstance(layer, Strip | Rules):
            low = _STRIPS if isinstance(layer, Strip) else _RULES
            order = _OVER_MAPS if mapped else low
        look = {"zorder": order, "alpha": layer.alpha, "gid": f"layer-{place}"}
        _add(axes, layer, colour(layer.colour, scheme), look, colours)


def dash(name: str) -> Any:
    """Return a dash as matplotlib has it, in points."""
    return (0.0, tuple(LINE * part for part in _DASHES[name])) if name in _DASHES else "solid"


def mark(layer: Points, ink: str) -> dict[str, Any]:
    """Return the look of points as markers of a line, in a figure and in its legend."""
    size = MARK * layer.size
    lined = layer.shape in _LINED
    return {
        "marker": SHAPES[layer.shape], "markersize": size, "color": ink,
        "markeredgewidth": LINE if lined else 0.0, "linestyle": "none",
    }  # fmt: skip


def _add(
    axes: Axes, layer: Layer, ink: str, look: dict[str, Any], colours: ScalarMappable | None
) -> None:
    match layer:
        case Strip():
            span = axes.axvspan if layer.axis == "x" else axes.axhspan
            span(layer.low, layer.high, facecolor=ink, edgecolor="none", **look)
        case Rules():
            _rules(axes, layer, ink, look)
        case Curve():
            look |= {"linewidth": LINE * layer.width, "linestyle": dash(layer.dash)}
            axes.plot(layer.x, layer.y, color=ink, **look)
        case Area():
            look |= {"facecolor": ink, "edgecolor": "none"}
            axes.fill_between(layer.x, layer.low, layer.high, **look)
        case Points(values=None):
            axes.plot(layer.x, layer.y, **mark(layer, ink), **look)
        case Points() | Map():
            assert colours is not None, "colours of values need the figure's scale"
            look |= {"cmap": colours.cmap, "norm": colours.norm}
            (_points if isinstance(layer, Points) else _map)(axes, layer, look)
        case Segments():
            ends = np.stack([layer.x0, layer.y0, layer.x1, layer.y1], axis=1).reshape(-1, 2, 2)
            look |= {"colors": ink, "linewidths": LINE * layer.width}
            axes.add_collection(LineCollection(list(ends), **look), autolim=False)
        case Bars():
            _bars(axes, layer, ink, look)
        case Texts():
            _texts(axes, layer, ink, look)


def _points(axes: Axes, layer: Any, look: dict[str, Any]) -> None:
    """Draw points whose colours tell values."""
    edge = LINE if layer.shape in _LINED else 0.0
    look |= {"c": layer.values, "s": (MARK * layer.size) ** 2, "marker": SHAPES[layer.shape]}
    axes.scatter(layer.x, layer.y, linewidths=edge, **look)


def _map(axes: Axes, layer: Any, look: dict[str, Any]) -> None:
    look |= {"zorder": _MAPS, "aspect": "auto", "interpolation": "nearest", "origin": "lower"}
    axes.imshow(np.ma.masked_invalid(layer.values), extent=(*layer.x, *layer.y), **look)


def _texts(axes: Axes, layer: Texts, ink: str, look: dict[str, Any]) -> None:
    """Draw texts on a patch of paper, which keeps lines below from striking them through.

    A text whose colour is for a colour below it, as on a map, has none: it would not be read there.
    """
    patch = {"facecolor": axes.get_facecolor(), "edgecolor": "none", "alpha": _PATCH, "pad": 0.0}
    bbox = None if layer.colour in _ON_COLOURS else patch
    look |= {"color": ink, "size": TEXT * layer.size, "bbox": bbox, "clip_on": True}
    look |= {"ha": layer.align, "va": _BASELINES[layer.baseline]}
    for x, y, text in zip(layer.x, layer.y, layer.texts, strict=True):
        axes.text(x, y, text, parse_math=False, **look)


def _rules(axes: Axes, layer: Rules, ink: str, look: dict[str, Any]) -> None:
    look |= {"colors": ink, "linewidths": LINE * layer.width, "linestyles": [dash(layer.dash)]}
    if layer.axis == "x":
        axes.vlines(layer.at, 0.0, 1.0, transform=axes.get_xaxis_transform(), **look)
    else:
        axes.hlines(layer.at, 0.0, 1.0, transform=axes.get_yaxis_transform(), **look)


def _bars(axes: Axes, layer: Bars, ink: str, look: dict[str, Any]) -> None:
    """Draw rectangles as one object: a bar of its own each would be slow to draw."""
    xs = np.stack([layer.left, layer.right, layer.right, layer.left], axis=1)
    ys = np.stack([layer.low, layer.low, layer.high, layer.high], axis=1)
    corners = np.stack([xs, ys], axis=2)
    axes.add_collection(PolyCollection(list(corners), facecolors=ink, edgecolors="none", **look),
                        autolim=False)  # fmt: skip
