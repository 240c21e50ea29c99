"""Layers of a figure: curves, areas, points, pieces, bars, strips, rules, maps and texts.

Colours are tokens (`tokens.colour`): the meaning of a thing decides how it looks, in light, dark
and print. A layer with a name stands in the legend; layers of one name are one entry.
"""

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Dash = Literal["solid", "dashed", "dotted"]
Numbers = NDArray[np.floating[Any]]


@dataclass(frozen=True, eq=False)
class Tip:
    """A line under the pointer.

    Attributes
    ----------
    label
        Name of the quantity; empty for a line that is a name itself.
    values
        A number or a text for each thing drawn, or ``"x"`` or ``"y"`` for its place.
    unit
        Unit of numbers.
    form
        Decimals of numbers, as in ``"0.00"``; empty for texts.
    """

    label: str
    values: Any
    unit: str = ""
    form: str = "0.0"


@dataclass(frozen=True, eq=False, kw_only=True)
class Look:
    """Look of a layer, which all have.

    Attributes
    ----------
    colour
        Token of the colour.
    name
        Entry of the legend; empty for none.
    alpha
        Opacity, from 0 to 1.
    tips
        Lines under the pointer.
    hidden
        True for a layer that is not shown until its entry of the legend is chosen.
    """

    colour: str = "ink"
    name: str = ""
    alpha: float = 1.0
    tips: tuple[Tip, ...] = ()
    hidden: bool = False


@dataclass(frozen=True, eq=False)
class Curve(Look):
    """A line through points; NaN leaves a gap. `width` in px."""

    x: Numbers
    y: Numbers
    width: float = 1.5
    dash: Dash = "solid"


@dataclass(frozen=True, eq=False)
class Area(Look):
    """The area between two curves over the same places."""

    x: Numbers
    low: Numbers
    high: Numbers


@dataclass(frozen=True, eq=False)
class Points(Look):
    """Marks at points. `size` in px.

    With `values` their colours are those of the figure's scale. Points of a `selection` are chosen
    by a box or one by one, in all figures that have this selection, and in its table.
    """

    x: Numbers
    y: Numbers
    size: float = 6.0
    shape: Literal["circle", "tick", "triangle", "down", "diamond", "cross"] = "circle"
    values: Numbers | None = None
    selection: str = ""


@dataclass(frozen=True, eq=False)
class Segments(Look):
    """Straight pieces between pairs of points. `width` in px."""

    x0: Numbers
    y0: Numbers
    x1: Numbers
    y1: Numbers
    width: float = 1.0


@dataclass(frozen=True, eq=False)
class Bars(Look):
    """Rectangles, given by their edges."""

    left: Numbers
    right: Numbers
    low: Numbers
    high: Numbers


@dataclass(frozen=True, eq=False)
class Strip(Look):
    """The part of the figure between two values of one axis, from edge to edge."""

    axis: Literal["x", "y"]
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Rules(Look):
    """Lines across the whole figure at values of one axis. `width` in px."""

    axis: Literal["x", "y"]
    at: Numbers
    width: float = 1.0
    dash: Dash = "solid"


@dataclass(frozen=True, eq=False)
class Map(Look):
    """A grid of equal cells, coloured by the figure's scale; NaN stays empty.

    Attributes
    ----------
    x, y
        Edges of the whole grid along the two axes, in their units.
    values
        Shape (rows, columns), the first row at the lower edge.
    """

    x: tuple[float, float]
    y: tuple[float, float]
    values: Numbers


@dataclass(frozen=True, eq=False)
class Texts(Look):
    """Texts at points. `size` in px.

    Attributes
    ----------
    align, baseline
        Part of a text that stands at its point.
    backed
        True for texts on a patch of the page's colour, which are read above lines. On paper all
        texts are.
    """

    x: Numbers
    y: Numbers
    texts: list[str]
    size: float = 11.0
    align: Literal["left", "center", "right"] = "center"
    baseline: Literal["top", "middle", "bottom"] = "middle"
    backed: bool = False


Layer = Curve | Area | Points | Segments | Bars | Strip | Rules | Map | Texts
