"""Drawing of figures by matplotlib: on paper and in notebooks.

The figures are those of the pages, `figures.description`. Matplotlib is imported at the first
drawing; it comes with ``arcless[plots]``.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from arcless.errors import FigureError
from arcless.figures.description import Figure, Layer, Rules
from arcless.figures.description.tokens import Scheme

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Drawing

# Width of the text of an A4 page in one column and in two, in mm.
PAGE_MM, COLUMN_MM = 160.0, 77.0
# Lines across a figure in a document: more are closer than 1.5 mm, and hide what is drawn.
MOST_RULES = 110


def draw(
    figure: Figure,
    axes: "Axes | None" = None,
    *,
    scheme: Scheme = "light",
    width_mm: float = PAGE_MM,
) -> "Drawing":
    """Draw a figure by matplotlib.

    Parameters
    ----------
    figure
        Its description, as in `Result.figures`.
    axes
        Axes of a figure of yours to draw in, with title and legend but without the caption;
        without them a new figure is made.
    scheme
        Colours: ``"light"`` or ``"dark"``.
    width_mm
        Width of a new figure in mm: `PAGE_MM`, `COLUMN_MM`, or another one.

    Returns
    -------
    matplotlib.figure.Figure
        The figure drawn in. No settings of matplotlib are changed.

    Raises
    ------
    FigureError
        Matplotlib is not installed.

    Notes
    -----
    A layer that a page hides until it is chosen in the legend is left out.
    """
    _needs_matplotlib()
    from arcless.figures.paper.sheet import draw_in, new_sheet

    if axes is None:
        return new_sheet(figure, scheme, width_mm)
    return draw_in(figure, axes, scheme)


def save(
    figure: Figure, path: str | Path, *, scheme: Scheme = "light", width_mm: float = PAGE_MM
) -> None:
    """Draw a figure into a file, whole or not at all; the same figure gives the same bytes.

    Parameters
    ----------
    figure
        Its description, as in `Result.figures`.
    path
        The file, which ends with ``.svg``, ``.pdf`` or ``.png``. Title and alternative text stand
        in it, in an SVG as `title` and `desc`.
    scheme, width_mm
        See `draw`.

    Raises
    ------
    FigureError
        Matplotlib is not installed, or the file has another ending.
    OutputError
        The file cannot be written.
    """
    _needs_matplotlib()
    from arcless.figures.paper.files import write

    write(figure, Path(path), scheme, width_mm)


def svg(figure: Figure, *, width_mm: float = PAGE_MM, factor: float = 1.0) -> str:
    """Draw a figure as an SVG without title, caption and alternative text.

    Parameters
    ----------
    figure
        Its description.
    width_mm
        Width in mm.
    factor
        Its height over that of a page.

    Returns
    -------
    str
        The SVG. Lines across the whole figure that are too many to be told apart, as those at the
        supports of 20 km, are left out: on a page one can zoom in to see them.

    Raises
    ------
    FigureError
        Matplotlib is not installed.
    """
    _needs_matplotlib()
    from arcless.figures.paper.files import picture

    height = round(factor * figure.height)
    layers = [one for one in figure.layers if not _paints_over(one)]
    bare = replace(figure, title="", caption="", alt="", height=height, layers=layers)
    return picture(bare, "svg", "light", width_mm).decode()


def _paints_over(layer: Layer) -> bool:
    return isinstance(layer, Rules) and layer.axis == "x" and layer.at.size > MOST_RULES


def plot(
    figures: Mapping[str, Sequence[Figure]],
    key: str,
    axes: "Axes | None" = None,
    *,
    scheme: Scheme = "light",
    width_mm: float | None = None,
) -> "Drawing":
    """Draw one of several figures.

    Parameters
    ----------
    figures
        Figures by their keys, as in `Result.figures`.
    key
        A key of theirs, for the first figure of that key, or the key of a single figure:
        ``"lead-2"`` is that of the second pantograph.
    axes, scheme
        See `draw`.
    width_mm
        Width of a new figure in mm; `PAGE_MM` without one.

    Raises
    ------
    FigureError
        There is no such figure, or matplotlib is not installed.
    """
    width = PAGE_MM if width_mm is None else width_mm
    return draw(choose(figures, key), axes, scheme=scheme, width_mm=width)


def choose(figures: Mapping[str, Sequence[Figure]], key: str) -> Figure:
    """Return one of several figures by a key as in `plot`.

    Raises
    ------
    FigureError
        There is no such figure.
    """
    single = {figure.key: figure for several in figures.values() for figure in several}
    for name in (key, key.replace("_", "-")):
        if name in single:
            return single[name]
    name = key.replace("-", "_")
    if figures.get(name):
        return figures[name][0]
    there = ", ".join(f"`{known}`" for known, several in figures.items() if several)
    if name in figures:
        what = "there is no figure of this key: nothing that it shows was recorded or is assessed"
    else:
        what = "unknown key of a figure"
    raise FigureError(what, got=f"`{key}`", expected=f"one of {there}" if there else None)


def _needs_matplotlib() -> None:
    from importlib.util import find_spec

    if find_spec("matplotlib") is None:
        raise FigureError(
            "drawing a figure needs the package matplotlib, which is not installed",
            hint="pip install 'arcless[plots]'",
        )


__all__ = ["COLUMN_MM", "PAGE_MM", "choose", "draw", "plot", "save", "svg"]
