"""A figure on a sheet of its own, or in the axes of another one."""

from io import BytesIO
from typing import Any, cast

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing
from matplotlib.font_manager import FontProperties
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.textpath import text_to_path

from arcless.figures.description import Figure
from arcless.figures.description.tokens import Scheme, colour
from arcless.figures.paper import axes as ruled
from arcless.figures.paper import layers, legend
from arcless.figures.paper.settings import CAPTION_PT, TITLE_PT, settings

_INCH_MM, _POINTS = 25.4, 72.0
# Pixels of a page in an inch; axes are not higher than this part of the sheet's width.
_PX, _MOST_HEIGHT = 96.0, 0.72
# Between title, legend, axes and caption, and around all of them, in points.
_GAP, _EDGE = 4.0, 4.0
_LINE = 1.25  # height of a line of text over the size of its font
_SHOWN_DPI = 144


class Sheet(Drawing):
    """A drawn figure, the same whatever settings hold where it is shown or saved."""

    def draw(self, renderer: Any) -> None:
        """Draw with the settings that the figure was laid out with."""
        with settings():
            super().draw(renderer)

    def _repr_png_(self) -> bytes:
        """Return the picture that a notebook shows, whether or not pyplot was imported there."""
        written = BytesIO()
        self.savefig(written, format="png", dpi=_SHOWN_DPI)
        return written.getvalue()


def new_sheet(figure: Figure, scheme: Scheme, width_mm: float) -> Sheet:
    """Draw a figure on a sheet of its own, with its caption below."""
    width = width_mm / _INCH_MM
    plot = min(figure.height / _PX, _MOST_HEIGHT * width)
    with settings():
        sheet = Sheet(figsize=(width, plot), facecolor=colour("paper", scheme))
        engine = ConstrainedLayoutEngine(w_pad=_EDGE / _POINTS, h_pad=_EDGE / _POINTS)
        sheet.set_layout_engine(engine)
        axes = sheet.add_subplot()
        above = _draw(figure, axes, scheme)
        lines = _wrapped(figure.caption, CAPTION_PT, _width(axes))
        below = (len(lines) * _LINE * CAPTION_PT + _GAP) / _POINTS if lines else 0.0
        height = plot + above / _POINTS + below
        sheet.set_size_inches(width, height)
        engine.set(rect=(0.0, below / height, 1.0, 1.0 - below / height))
        sheet.draw_without_rendering()
        if lines:
            corner = axes.get_position().x0, _EDGE / _POINTS / height
            ink = colour("soft", scheme)
            look: dict[str, Any] = {"size": CAPTION_PT, "color": ink, "linespacing": _LINE}
            made = sheet.text(*corner, "\n".join(lines), va="bottom", parse_math=False, **look)
            made.set_in_layout(False)
    return sheet


def draw_in(figure: Figure, axes: Axes, scheme: Scheme) -> Drawing:
    """Draw a figure in axes that somebody else made; return the figure that they belong to."""
    with settings():
        _draw(figure, axes, scheme)
    return _sheet_of(axes)


def _draw(figure: Figure, axes: Axes, scheme: Scheme) -> float:
    """Draw all but the caption; return the height of title and legend in points."""
    colours = None if figure.scale is None else ruled.mappable(figure.scale, scheme)
    ruled.set_up(axes, figure, scheme)
    layers.add(axes, ruled.shown(figure), scheme, colours)
    if figure.scale is not None:
        ruled.add_bar(axes, figure.scale, scheme)
    sheet = _sheet_of(axes)
    sheet.draw_without_rendering()
    width, dots = _width(axes), sheet.dpi / _POINTS
    made = legend.add(axes, figure, scheme, width * dots)
    taken = made.get_window_extent().height / dots if made is not None else 0.0
    if not figure.title:
        if made is not None:
            made.set_in_layout(True)  # no title above it has its room
        return taken
    lines = _wrapped(figure.title, TITLE_PT, width, weight="bold")
    axes.set_title(
        "\n".join(lines), loc="left", size=TITLE_PT, color=colour("ink", scheme), pad=taken + _GAP,
        weight="bold", parse_math=False, linespacing=_LINE,
    )  # fmt: skip
    return taken + _GAP + len(lines) * _LINE * TITLE_PT


def _sheet_of(axes: Axes) -> Drawing:
    return cast(Drawing, axes.get_figure(root=True))


def _width(axes: Axes) -> float:
    """Return the width of axes in points."""
    return axes.get_window_extent().width * _POINTS / _sheet_of(axes).dpi


def _wrapped(text: str, size: float, width: float, **look: Any) -> list[str]:
    """Return the lines of a text, broken at spaces, as wide as a number of points."""
    font = FontProperties(size=size, **look)
    lines: list[str] = []
    for word in filter(None, text.split(" ")):
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and text_to_path.get_text_width_height_descent(longer, font, False)[0] <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
