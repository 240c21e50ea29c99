"""A figure on a sheet of its own, or in the axes of another one."""

from io import BytesIO
from typing import cast

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
# Pixels of a page in an inch; a figure is not higher than this part of its width.
_PX, _MOST_HEIGHT = 96.0, 0.72
# Between title, legend, axes and caption, and around all of them, in points.
_GAP, _EDGE = 3.0, 4.0
_LINE = 1.25  # height of a line of text over the size of its font
_SHOWN_DPI = 144


class Sheet(Drawing):
    """A drawn figure that notebooks show, whether or not pyplot was imported there."""

    def _repr_png_(self) -> bytes:
        written = BytesIO()
        with settings():
            self.savefig(written, format="png", dpi=_SHOWN_DPI)
        return written.getvalue()


def new_sheet(figure: Figure, scheme: Scheme, width_mm: float) -> Sheet:
    """Draw a figure on a sheet of its own, with its caption below."""
    width = width_mm / _INCH_MM
    plot = min(figure.height / _PX, _MOST_HEIGHT * width)
    with settings():
        sheet = Sheet(figsize=(width, plot), facecolor=colour("paper", scheme))
        room = {"w_pad": _EDGE / _POINTS, "h_pad": _EDGE / _POINTS}
        engine = ConstrainedLayoutEngine(**room)
        sheet.set_layout_engine(engine)
        axes = sheet.add_subplot()
        above = _draw(figure, axes, scheme)
        lines = _wrapped(figure.caption, CAPTION_PT, _POINTS * width - 2.0 * _EDGE)
        below = (len(lines) * _LINE * CAPTION_PT + _GAP) / _POINTS if lines else 0.0
        height = plot + above / _POINTS + below
        sheet.set_size_inches(width, height)
        engine.set(rect=(0.0, below / height, 1.0, 1.0 - below / height))
        if lines:
            made = sheet.text(
                _EDGE / _POINTS / width, _EDGE / _POINTS / height, "\n".join(lines), size=CAPTION_PT,
                color=colour("soft", scheme), va="bottom", linespacing=_LINE, parse_math=False,
            )  # fmt: skip
            made.set_in_layout(False)
        sheet.draw_without_rendering()
    return sheet


def draw_in(figure: Figure, axes: Axes, scheme: Scheme) -> Drawing:
    """Draw a figure in axes that somebody else made; return the figure that they belong to."""
    with settings():
        _draw(figure, axes, scheme)
    return cast(Drawing, axes.get_figure(root=True))


def _draw(figure: Figure, axes: Axes, scheme: Scheme) -> float:
    """Draw all but the caption; return the height of title and legend in points."""
    colours = None if figure.scale is None else ruled.mappable(figure.scale, scheme)
    layers.add(axes, ruled.shown(figure), scheme, colours)
    ruled.set_up(axes, figure, scheme)
    if figure.scale is not None:
        ruled.add_bar(axes, figure.scale, scheme)
    sheet = cast(Drawing, axes.get_figure(root=True))
    sheet.draw_without_rendering()
    frame = axes.get_window_extent()
    points = _POINTS / sheet.dpi
    made = legend.add(axes, figure, scheme, frame.width)
    taken = made.get_window_extent().height * points if made is not None else 0.0
    lines = _wrapped(figure.title, TITLE_PT, frame.width * points)
    axes.set_title(
        "\n".join(lines), loc="left", size=TITLE_PT, color=colour("ink", scheme), pad=taken + _GAP,
        weight="bold", parse_math=False, linespacing=_LINE,
    )  # fmt: skip
    return taken + _GAP + len(lines) * _LINE * TITLE_PT


def _wrapped(text: str, size: float, width: float) -> list[str]:
    """Return the lines of a text, not wider than a number of points; long words stay whole."""
    font = FontProperties(size=size)
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and text_to_path.get_text_width_height_descent(longer, font, False)[0] <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
