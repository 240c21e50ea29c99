"""Legend of a figure: above the axes, in as many columns as there is room for."""

from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.legend import Legend
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from arcless.figures.description import Curve, Figure, Layer, Points, Rules, Segments, Texts
from arcless.figures.description.tokens import Scheme, colour
from arcless.figures.paper.axes import shown
from arcless.figures.paper.layers import dash, mark
from arcless.figures.paper.settings import LINE, TICK_PT

_LEAST_PT = 0.9  # width of a line in a legend: a thin one would not be seen there


def entries(figure: Figure) -> dict[str, Layer]:
    """Return name and layer of each entry, as in a page: the layer on top stands first."""
    found: dict[str, Layer] = {}
    for layer in shown(figure):
        if layer.name:
            found.setdefault(layer.name, layer)
    return dict(reversed(found.items()))


def add(axes: Axes, figure: Figure, scheme: Scheme, width: float) -> Legend | None:
    """Draw the legend above axes, no wider than a number of pixels; return None for no entry."""
    signs: list[tuple[str, Artist]] = [
        (name, _sign(layer, scheme)) for name, layer in entries(figure).items()
    ]
    scale = figure.scale
    if scale is not None and scale.under_label:
        signs.append((scale.under_label, Patch(facecolor=colour(scale.under, scheme))))
    if not signs:
        return None
    for columns in range(len(signs), 0, -1):
        made = _made(axes, signs, columns, scheme)
        if columns == 1 or made.get_window_extent().width <= width:
            break
    return made


def _made(axes: Axes, signs: list[tuple[str, Artist]], columns: int, scheme: Scheme) -> Legend:
    names, handles = zip(*_by_rows(signs, columns), strict=True)
    made = axes.legend(
        handles, names, ncols=columns, loc="lower left", bbox_to_anchor=(0.0, 1.0), frameon=False,
        fontsize=TICK_PT, labelcolor=colour("ink", scheme), borderaxespad=0.0, borderpad=0.3,
        handlelength=1.6, handleheight=0.7, handletextpad=0.5, columnspacing=1.2, labelspacing=0.3,
    )  # fmt: skip
    for text in made.get_texts():
        text.set_parse_math(False)
    made.set_in_layout(False)  # the title, which stands above it, has its room
    return made


def _by_rows(signs: list[Any], columns: int) -> list[Any]:
    """Return entries so that columns, filled from the left, read along the rows.

    Matplotlib fills columns, the first ones with one entry more where they are not equal.
    """
    return [sign for column in range(columns) for sign in signs[column::columns]]


def _sign(layer: Layer, scheme: Scheme) -> Artist:
    """Return the sign of a layer: a line, a mark, or a patch."""
    ink = colour(layer.colour, scheme)
    look: dict[str, Any] = {"alpha": layer.alpha, "color": ink}
    if isinstance(layer, Curve | Rules | Segments):
        look["linewidth"] = max(LINE * layer.width, _LEAST_PT)
    match layer:
        case Curve() | Rules():
            return Line2D([], [], linestyle=dash(layer.dash), **look)
        case Segments():
            return Line2D([], [], **look)
        case Points():
            return Line2D([], [], **{**mark(layer, ink), **look})
        case Texts():
            return Line2D([], [], marker="o", markersize=4.0, linestyle="none", **look)
        case _:
            return Patch(linewidth=0.0, **look)
