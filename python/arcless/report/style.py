"""How the figures look: one place for colours, axes and tools."""

from typing import Any

import numpy as np

# Dark enough to print, told apart by people who see red and green alike.
COLOURS = ("#1f5a92", "#d0652a", "#3b8a5a", "#8a4f9e", "#a88a1c", "#4aa3b5", "#b03a5b", "#666666")
GREY, LIGHT, INK = "#8d949c", "#c9ced4", "#2b2f33"
SECTION_FILL = "#1f5a92"
LEGEND_COLUMNS, LEGEND_LETTERS = 5, 22
TOOLS = "box_zoom,pan,xwheel_zoom,reset,save"


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


def models() -> Any:
    """Return bokeh's models; untyped, since its own type hints leave most of them out."""
    import bokeh.models

    return bokeh.models


def figure(
    title: str,
    x_label: str,
    y_label: str,
    *,
    height: int = 290,
    tools: str = TOOLS,
    drag: str = "box_zoom",
    **options: Any,
) -> Any:
    """Return an empty figure in the style of the report."""
    from bokeh.plotting import figure as bokeh_figure

    fig: Any = bokeh_figure(
        title=title,
        x_axis_label=x_label,
        y_axis_label=y_label,
        height=height,
        sizing_mode="stretch_width",
        tools=tools,
        active_drag=drag,
        active_scroll=None,
        output_backend="canvas",
        **options,
    )
    fig.toolbar.logo = None
    fig.toolbar.autohide = False
    fig.outline_line_color = None
    fig.title.text_font_size = "13px"
    fig.title.text_color = INK
    fig.grid.grid_line_color = "#eceef0"
    fig.axis.axis_line_color = LIGHT
    fig.axis.major_tick_line_color = LIGHT
    fig.axis.minor_tick_line_color = None
    fig.axis.axis_label_text_font_style = "normal"
    fig.axis.axis_label_text_font_size = "12px"
    fig.axis.axis_label_text_color = INK
    fig.axis.major_label_text_color = "#555b61"
    fig.min_border_left = 72  # the frames of all figures begin at the same place
    fig.min_border_right = 16
    return fig


def add_legend(fig: Any, entries: list[tuple[str, list[Any]]]) -> None:
    """Put a legend above the plot, where it hides no data; a click hides its series."""
    if not entries:
        return
    legend = models().Legend(
        items=[
            models().LegendItem(label={"value": _short(label)}, renderers=drawn)
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
    fig.add_layout(legend, "above")


def _short(label: str) -> str:
    cut = label if len(label) <= LEGEND_LETTERS else label[: LEGEND_LETTERS - 1] + "…"
    return plain(cut)


def add_hover(fig: Any, drawn: list[Any], tooltips: list[tuple[str, str]], **options: Any) -> None:
    """Show values under the pointer."""
    hover = models().HoverTool(renderers=drawn, tooltips=tooltips, visible=False, **options)
    fig.add_tools(hover)
