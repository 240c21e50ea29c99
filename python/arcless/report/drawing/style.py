"""Style of the figures: one place for colours, axes and tools."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from arcless.report.drawing.bokeh_objects import Model, Value
from arcless.report.drawing.figure import Figure

# Dark enough to print, told apart by people who see red and green alike.
COLOURS = ("#1f5a92", "#d0652a", "#3b8a5a", "#8a4f9e", "#a88a1c", "#4aa3b5", "#b03a5b", "#666666")
GREY, LIGHT, INK = "#8d949c", "#c9ced4", "#2b2f33"
SECTION_FILL = "#1f5a92"
FADED = 0.1  # opacity of what is not selected while something is
LEGEND_COLUMNS, LEGEND_LETTERS = 5, 22
HEIGHT = 290  # px
DASHES: tuple[int, ...] = (6,)  # px; what the script calls dashed is shorter


def colour(index: int) -> str:
    """Return the colour of the pantograph with this index."""
    return COLOURS[index % len(COLOURS)]


def plain(text: str) -> str:
    """Return text that a figure shows as it is: bokeh reads dollar pairs as formulas."""
    for opening in ("$$", r"\(", r"\["):
        text = text.replace(opening, opening[0] + "\u200b" + opening[1])
    return text


def single(values: Any) -> Any:
    """Return values in single precision: half the size in the file, finer than a pixel."""
    return np.asarray(values, dtype=np.float32)


def figure(
    title: str,
    x_label: str,
    y_label: str,
    *,
    logarithmic: bool = False,
    names: Sequence[str] = (),
    selects: bool = False,
    **attributes: Any,
) -> Figure:
    """Return an empty figure in the style of the report.

    Parameters
    ----------
    title, x_label, y_label
        What it says.
    logarithmic
        Whether the axis upwards is.
    names
        What stands along the axis upwards in place of numbers, the lowest first.
    selects
        Whether what is drawn can be selected, by a box or one by one.
    **attributes
        Others of the figure, such as its height in px or a range that figures share.
    """
    kind = "Categorical" if names else "Log" if logarithmic else "Linear"
    fig = Figure(
        _axis("LinearAxis", x_label),
        _axis(f"{kind}Axis", y_label),
        _tools(selects=selects),
        title=Model("Title", text=title, text_color=INK),
        x_range=attributes.pop("x_range", None) or Model("DataRange1d"),
        y_range=attributes.pop("y_range", None) or Model("DataRange1d"),
        y_scale=Model(f"{kind}Scale"),
        sizing_mode="stretch_width",
        outline_line_color=None,
        min_border_left=72,  # the frames of all figures begin at the same place
        min_border_right=16,
        **{"height": HEIGHT, **attributes},
    )
    if names:
        fig.y_range = Model("FactorRange", factors=list(names))
    for grid in fig.center:
        grid.grid_line_color = "#eceef0"
    return fig


def _axis(kind: str, label: str) -> Model:
    axis = Model(
        kind,
        axis_label=label or None,
        axis_label_text_font_style="normal",
        axis_label_text_font_size="12px",
        axis_label_text_color=INK,
        major_label_text_color="#555b61",
        axis_line_color=LIGHT,
        major_tick_line_color=LIGHT,
        minor_tick_line_color=None,
    )
    if kind == "LogAxis":
        axis.ticker = Model("LogTicker", num_minor_ticks=10)
    return axis


def _tools(*, selects: bool) -> list[Model]:
    """Return the tools of a figure; the first one is what a drag does."""
    tools = [Model("BoxSelectTool"), Model("TapTool")] if selects else []
    tools += [Model("BoxZoomTool", dimensions="both"), Model("PanTool")]
    tools += [Model("WheelZoomTool", dimensions="width"), Model("ResetTool"), Model("SaveTool")]
    return tools


def add_section(fig: Figure, begin: float, end: float) -> None:
    """Shade the section assessed, given in the numbers of the horizontal axis."""
    shade = {"fill_color": SECTION_FILL, "fill_alpha": 0.05, "level": "image"}
    fig.center.append(Model("BoxAnnotation", left=begin, right=end, **shade))


def add_legend(fig: Figure, entries: list[tuple[str, list[Model]]]) -> None:
    """Put a legend above the plot, where it hides no data; a click hides its series."""
    if not entries:
        return
    legend = Model(
        "Legend",
        items=[
            Model("LegendItem", label=Value(_short(label)), renderers=drawn)
            for label, drawn in entries
        ],
        orientation="horizontal",
        ncols=LEGEND_COLUMNS,
        click_policy="hide",
        border_line_color=None,
        label_text_font_size="12px",
        label_text_color=INK,
        padding=0,
        spacing=10,
        margin=4,
        glyph_width=18,
    )
    fig.above.append(legend)


def _short(label: str) -> str:
    cut = label if len(label) <= LEGEND_LETTERS else label[: LEGEND_LETTERS - 1] + "…"
    return plain(cut)


def add_hover(
    fig: Figure, drawn: list[Model], tooltips: list[tuple[str, str]], **options: Any
) -> None:
    """Show values under the pointer."""
    hover = Model("HoverTool", renderers=drawn, tooltips=tooltips, visible=False, **options)
    fig.toolbar.tools.append(hover)
