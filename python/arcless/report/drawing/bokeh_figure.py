"""Descriptions of figures → plots of Bokeh's script, with a legend that the page shows itself."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from arcless.figures.description import (
    Axis,
    Curve,
    Figure,
    Layer,
    Map,
    Points,
    Rules,
    Scale,
    Segments,
    Texts,
)
from arcless.figures.description.tokens import shades
from arcless.report.drawing.bokeh_layers import FONT, Canvas, Sources, plain
from arcless.report.drawing.bokeh_objects import Columns, Model, Token

_SWATCHES: Mapping[type, str] = {
    Curve: "line", Segments: "line", Rules: "line", Points: "dot", Texts: "dot",
}  # fmt: skip
_MARKS = {"dot", "tick", "triangle", "diamond"}
# The frames of all figures begin at the same place, in px.
_LEFT, _RIGHT = 66, 14


@dataclass
class Entry:
    """Entry of a legend, and what it shows and hides.

    Attributes
    ----------
    name
        Its text.
    colour
        Token of the colour.
    swatch
        Kind of its sign: line, dashed, dotted, dot or area.
    drawn
        Objects of the script.
    hidden
        True for an entry that is not shown at first.
    alpha
        Opacity.
    """

    name: str
    colour: str
    swatch: str
    hidden: bool = False
    alpha: float = 1.0
    drawn: list[Model] = field(default_factory=list)


@dataclass
class Drawn:
    """A figure that was drawn: the plot, and the legend next to it."""

    figure: Figure
    plot: Model
    legend: list[Entry]


class Drawing:
    """The figures of one page, which share ranges, cross hairs, columns and selections."""

    def __init__(self) -> None:
        self._ranges: dict[str, Model] = {}
        self._spans: dict[str, Model] = {}
        self._sources = Sources()

    def source_of(self, selection: str) -> Columns:
        """Return the columns of a selection; figures and a table draw from the same."""
        return self._sources.of_selection(selection)

    def selections(self) -> dict[str, Columns]:
        """Return the columns of each selection."""
        return self._sources.selections

    def groups(self) -> dict[str, dict[str, Model]]:
        """Return the range and the cross hair of each group of axes."""
        return {
            group: {"range": self._ranges[group], "cross": span}
            for group, span in self._spans.items()
        }

    def draw(self, figure: Figure) -> Drawn:
        """Draw a figure."""
        plot = self._empty(figure)
        mapper = None if figure.scale is None else _mapper(figure.scale)
        canvas, legend = Canvas(plot, mapper, self._sources), dict[str, Entry]()
        for layer in figure.layers:
            made = canvas.add(layer)
            if layer.name:
                kind = _swatch(layer)
                new = Entry(layer.name, layer.colour, kind, layer.hidden, layer.alpha)
                entry = legend.setdefault(layer.name, new)
                if {entry.swatch, kind} <= _MARKS and entry.swatch != kind:
                    entry.swatch = "dot"  # marks of several shapes have the colour in common
                entry.drawn.append(made)
        if any(isinstance(layer, Map) for layer in figure.layers):  # a grid would lie on the map
            plot.center = [one for one in plot.center if one.kind != "Grid"]
        # The layer on top is the subject: it stands first.
        return Drawn(figure, plot, list(reversed(legend.values())))

    def _empty(self, figure: Figure) -> Model:
        x, y = _axis(figure.x), _axis(figure.y)
        chosen = any(isinstance(layer, Points) and layer.selection for layer in figure.layers)
        tools = _tools(selects=chosen)
        tools.append(self._cross(figure.x))
        return Model(
            "Plot",
            height=figure.height,
            sizing_mode="stretch_width",
            x_range=self._range(figure.x),
            y_range=self._range(figure.y),
            x_scale=Model("LogScale" if figure.x.logarithmic else "LinearScale"),
            y_scale=Model("LogScale" if figure.y.logarithmic else "LinearScale"),
            below=[x],
            left=[y],
            right=[],
            center=[
                Model("Grid", axis=axis, dimension=dimension, grid_line_color=Token("grid"))
                for dimension, axis in enumerate((x, y))
            ],
            renderers=[],
            toolbar=Model(
                "Toolbar", tools=tools, active_drag=tools[0], active_scroll=None, logo=None
            ),
            toolbar_location=None,
            outline_line_color=None,
            background_fill_color=None,
            border_fill_color=None,
            min_border_left=_LEFT,
            min_border_right=_RIGHT,
            min_border_top=6,
        )

    def _range(self, axis: Axis) -> Model:
        if axis.group and axis.group in self._ranges:
            return self._ranges[axis.group]
        if axis.low is not None and axis.high is not None:
            made = Model("Range1d", start=axis.low, end=axis.high)
            if axis.bounds is not None:
                made.bounds = axis.bounds
        else:
            made = Model("DataRange1d", range_padding=0.04)
            if axis.low is not None:
                made.start = axis.low
            if axis.high is not None:
                made.end = axis.high
        if axis.group:
            self._ranges[axis.group] = made
        return made

    def _cross(self, axis: Axis) -> Model:
        """Return the cross hair: upright the same line in all figures of a group."""
        look = {"level": "overlay", "line_color": Token("soft"), "line_width": 1}
        if not axis.group:
            return Model("CrosshairTool", dimensions="both", line_color=Token("soft"), line_width=1)
        if axis.group not in self._spans:
            self._spans[axis.group] = Model("Span", dimension="height", **look)
        across = Model("Span", dimension="width", **look, line_alpha=0.4)
        return Model("CrosshairTool", overlay=[across, self._spans[axis.group]])


def _mapper(scale: Scale) -> Model:
    made = Model(
        "LinearColorMapper",
        palette=list(shades(scale.colours)),
        low=scale.low,
        high=scale.high,
        nan_color="rgba(0, 0, 0, 0)",
    )
    if scale.under:
        made.low_color = Token(scale.under)
    return made


def _axis(axis: Axis) -> Model:
    made = Model(
        "LogAxis" if axis.logarithmic else "LinearAxis",
        axis_label=plain(axis.title) or None,
        axis_label_text_font=FONT,
        major_label_text_font=FONT,
        axis_label_text_font_style="normal",
        axis_label_text_font_size="12px",
        axis_label_text_color=Token("ink"),
        axis_label_standoff=6,
        major_label_text_color=Token("soft"),
        axis_line_color=Token("rule"),
        major_tick_line_color=Token("rule"),
        minor_tick_line_color=None,
    )
    if axis.logarithmic:
        made.ticker = Model("LogTicker", num_minor_ticks=10)
    if axis.form:
        made.formatter = Model("NumeralTickFormatter", format=axis.form)
    if axis.categories:
        names = {place: plain(name) for place, name in enumerate(axis.categories) if name}
        made.ticker = Model("FixedTicker", ticks=list(names))
        made.major_label_overrides = names
    return made


def _tools(*, selects: bool) -> list[Model]:
    """Return the tools of a figure; the first one is what a drag does."""
    tools = [Model("BoxSelectTool"), Model("TapTool")] if selects else []
    return [*tools, Model("BoxZoomTool"), Model("PanTool"), Model("WheelZoomTool")]


def _swatch(layer: Layer) -> str:
    if isinstance(layer, Curve | Rules) and layer.dash != "solid":
        return layer.dash
    if isinstance(layer, Points) and layer.shape in ("tick", "triangle", "diamond"):
        return layer.shape
    return _SWATCHES.get(type(layer), "area")
