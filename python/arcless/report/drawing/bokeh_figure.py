"""Descriptions of figures → plots of Bokeh's script, with a legend that the page shows itself."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from arcless.figures.description import (
    Area,
    Axis,
    Bars,
    Curve,
    Figure,
    Layer,
    Map,
    Points,
    Rules,
    Scale,
    Segments,
    Strip,
    Texts,
)
from arcless.figures.description.tokens import shades, tokens
from arcless.report.drawing.bokeh_objects import Columns, Field, Model, Token, Value

_DASHES: Mapping[str, tuple[int, ...]] = {"solid": (), "dashed": (7, 4), "dotted": (2, 3)}
_SHAPES = {
    "circle": "circle", "tick": "dash", "triangle": "triangle", "down": "inverted_triangle",
    "diamond": "diamond", "cross": "x",
}  # fmt: skip
_SWATCHES: Mapping[type, str] = {
    Curve: "line", Segments: "line", Rules: "line", Points: "dot", Texts: "dot",
}  # fmt: skip
# Steps of a scale that a map distinguishes: finer than a screen shows, and small in a file.
_STEPS = 250
_UNSELECTED = 0.12
FONT: str = tokens()["font"]["text"]
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
    """

    name: str
    colour: str
    swatch: str
    hidden: bool = False
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
        self._selections: dict[str, Columns] = {}
        # Columns by the places that curves share; the places are kept, so that no other has the id.
        self._sources: dict[int, tuple[Any, Columns]] = {}

    def source_of(self, selection: str) -> Columns:
        """Return the columns of a selection; figures and a table draw from the same."""
        return self._selections.setdefault(selection, Columns())

    def selections(self) -> dict[str, Columns]:
        """Return the columns of each selection."""
        return self._selections

    def groups(self) -> dict[str, dict[str, Model]]:
        """Return the range and the cross hair of each group of axes."""
        return {
            group: {"range": made, "cross": self._spans[group]}
            for group, made in self._ranges.items()
            if group in self._spans
        }

    def draw(self, figure: Figure) -> Drawn:
        """Draw a figure."""
        plot = self._empty(figure)
        legend: dict[str, Entry] = {}
        mapper = None if figure.scale is None else _mapper(figure.scale)
        for layer in figure.layers:
            made = self._layer(plot, layer, mapper)
            made.visible = not layer.hidden
            if layer.name:
                entry = legend.setdefault(
                    layer.name, Entry(layer.name, layer.colour, _swatch(layer), layer.hidden)
                )
                entry.drawn.append(made)
        if figure.scale is not None:
            plot.right = [_bar(figure.scale, mapper)]
        if any(isinstance(layer, Map) for layer in figure.layers):
            plot.center = [one for one in plot.center if one.kind != "Grid"]
            for made in plot.renderers:
                if made.glyph.kind in ("VSpan", "HSpan"):
                    made.level = "annotation"
        # What was drawn last lies on top and is the subject: it stands first.
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
                Model("Grid", axis=x, grid_line_color=Token("grid")),
                Model("Grid", axis=y, dimension=1, grid_line_color=Token("grid")),
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
            return Model(
                "CrosshairTool", dimensions="both", line_color=Token("soft"), line_width=1
            )
        if axis.group not in self._spans:
            self._spans[axis.group] = Model("Span", dimension="height", **look)
        across = Model("Span", dimension="width", **look, line_alpha=0.4)
        return Model("CrosshairTool", overlay=[across, self._spans[axis.group]])

    def _layer(self, plot: Model, layer: Layer, mapper: Model | None) -> Model:
        """Add a layer to a plot; return the object that shows and hides it."""
        line = {"line_color": Token(layer.colour), "line_alpha": layer.alpha}
        fill = {"fill_color": Token(layer.colour), "fill_alpha": layer.alpha}
        match layer:
            case Strip(axis="x"):
                return _annotation(plot, {"left": layer.low, "right": layer.high, **fill})
            case Strip():
                return _annotation(plot, {"bottom": layer.low, "top": layer.high, **fill})
            case Rules():
                kind, place = ("VSpan", "x") if layer.axis == "x" else ("HSpan", "y")
                look = {**line, "line_width": layer.width, "line_dash": _DASHES[layer.dash]}
                source = Columns({place: _single(layer.at)})
                return _glyph(plot, layer, source, kind, look, "underlay", **{place: place})
            case Curve():
                source, x = self._shared(layer.x)
                look = {**line, "line_width": layer.width, "line_dash": _DASHES[layer.dash]}
                return _glyph(plot, layer, source, "Line", look, x=x, y=_column(source, layer.y))
            case Area():
                source, x = self._shared(layer.x)
                ends = {"y1": _column(source, layer.low), "y2": _column(source, layer.high)}
                return _glyph(plot, layer, source, "VArea", fill, x=x, **ends)
            case Points():
                return self._points(plot, layer, mapper)
            case Segments():
                ends = {name: _single(getattr(layer, name)) for name in ("x0", "y0", "x1", "y1")}
                look = {**line, "line_width": layer.width}
                names = dict(zip(ends, ends, strict=True))
                return _glyph(plot, layer, Columns(ends), "Segment", look, **names)
            case Bars():
                edges = {
                    "left": _single(layer.left), "right": _single(layer.right),
                    "bottom": _single(layer.low), "top": _single(layer.high),
                }  # fmt: skip
                names = dict(zip(edges, edges, strict=True))
                return _glyph(plot, layer, Columns(edges), "Quad", {**fill, "line_color": None},
                              **names)  # fmt: skip
            case Map():
                return _map(plot, layer, mapper)
            case Texts():
                data = {
                    "x": _single(layer.x), "y": _single(layer.y),
                    "text": [plain(text) for text in layer.texts],
                }  # fmt: skip
                look = {
                    "text_color": Token(layer.colour), "text_alpha": layer.alpha,
                    "text_font": Value(FONT), "text_font_size": f"{layer.size:g}px", "text_align": layer.align,
                    "text_baseline": layer.baseline,
                }  # fmt: skip
                return _glyph(plot, layer, Columns(data), "Text", look, x="x", y="y", text="text")

    def _points(self, plot: Model, layer: Points, mapper: Model | None) -> Model:
        source = self.source_of(layer.selection) if layer.selection else Columns()
        x, y = _column(source, layer.x), _column(source, layer.y)
        colour: Any = Token(layer.colour)
        if layer.values is not None:
            colour = Field(_column(source, layer.values), mapper)
        look: dict[str, Any] = {"marker": Value(_SHAPES[layer.shape]), "size": layer.size}
        look |= {"fill_color": colour, "fill_alpha": layer.alpha}
        lined = layer.shape in ("tick", "cross")
        look |= {"line_color": colour if lined else None, "line_alpha": layer.alpha}
        if layer.shape == "tick":
            look["angle"] = np.pi / 2
        made = _glyph(plot, layer, source, "Scatter", look, x=x, y=y)
        if layer.selection:
            faded = {"fill_alpha": _UNSELECTED, "line_alpha": _UNSELECTED}
            made.nonselection_glyph = Model("Scatter", **{**vars(made.glyph), **faded})
        return made

    def _shared(self, x: Any) -> tuple[Columns, str]:
        """Return the columns of curves over these places, and the name of the places in them."""
        if id(x) not in self._sources:
            self._sources[id(x)] = x, Columns()
        source = self._sources[id(x)][1]
        return source, _column(source, x)


def plain(text: str) -> str:
    """Return text that a figure shows as it is: Bokeh reads dollar pairs as formulas."""
    for opening in ("$$", r"\(", r"\["):
        text = text.replace(opening, opening[0] + "\u200b" + opening[1])
    return text


def _single(values: Any) -> Any:
    """Return numbers in single precision: half the size in the file, finer than a pixel."""
    return np.asarray(values, dtype=np.float32)


def _column(source: Columns, values: Any) -> str:
    """Return the name of a column with these values, written as a page has them."""
    name = source.name_of(values)
    if source.data[name] is values:
        texts = isinstance(values, list | tuple) and values and isinstance(values[0], str)
        source.data[name] = [plain(text) for text in values] if texts else _single(values)
    return name


def _glyph(
    plot: Model,
    layer: Layer,
    source: Columns,
    kind: str,
    look: dict[str, Any],
    level: str = "glyph",
    **places: str,
) -> Model:
    """Add a glyph, its places given as names of columns, with what the pointer shows."""
    glyph = Model(kind, **{place: Field(name) for place, name in places.items()}, **look)
    made = Model("GlyphRenderer", data_source=source, glyph=glyph)
    if level != "glyph":
        made.level = level
    plot.renderers.append(made)
    if layer.tips:
        tips = [(plain(tip.label), _tip(source, tip, places)) for tip in layer.tips]
        hover = Model("HoverTool", renderers=[made], tooltips=tips, visible=False)
        if kind == "Line":
            hover.line_policy = "nearest"
        plot.toolbar.tools.append(hover)
    return made


def _tip(source: Columns, tip: Any, places: Mapping[str, str]) -> str:
    """Return what stands behind a label: a template, in which data are names of columns alone."""
    if isinstance(tip.values, str):
        name = places[tip.values]
    else:
        name = _column(source, tip.values)
    form = f"{{{tip.form}}}" if tip.form else ""
    return f"@{name}{form} {tip.unit}".rstrip()


def _annotation(plot: Model, places: dict[str, Any]) -> Model:
    made = Model("BoxAnnotation", level="image", line_color=None, **places)
    plot.center.append(made)
    return made


def _map(plot: Model, layer: Map, mapper: Model | None) -> Model:
    assert mapper is not None, "a map needs the figure's scale"
    step = (mapper.high - mapper.low) / _STEPS
    values = np.asarray(np.round(layer.values / step) * step, dtype=np.float32)
    data = {
        "image": [values], "x": [layer.x[0]], "y": [layer.y[0]],
        "dw": [layer.x[1] - layer.x[0]], "dh": [layer.y[1] - layer.y[0]],
    }  # fmt: skip
    names = dict(zip(data, data, strict=True))
    made = _glyph(plot, layer, Columns(data), "Image", {"color_mapper": mapper}, **names)
    if layer.tips:
        tip = layer.tips[0]
        value = f"@image{{{tip.form}}} {tip.unit}".rstrip()
        places = [(axis.axis_label, f"${name}{{0.0}}") for axis, name in
                  ((plot.below[0], "x"),)]  # fmt: skip
        plot.toolbar.tools[-1].tooltips = [(plain(tip.label), value), *places]
    return made


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


def _bar(scale: Scale, mapper: Model | None) -> Model:
    return Model(
        "ColorBar",
        color_mapper=mapper,
        width=10,
        padding=6,
        label_standoff=6,
        title=plain(scale.title),
        title_text_font=FONT,
        major_label_text_font=FONT,
        title_text_font_style="normal",
        title_text_font_size="12px",
        title_text_color=Token("ink"),
        major_label_text_color=Token("soft"),
        background_fill_color=None,
        major_tick_line_color=None,
        bar_line_color=None,
    )


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
        made.ticker = Model("FixedTicker", ticks=list(range(len(axis.categories))))
        names = {place: plain(name) for place, name in enumerate(axis.categories)}
        made.major_label_overrides = names
    return made


def _tools(*, selects: bool) -> list[Model]:
    """Return the tools of a figure; the first one is what a drag does."""
    tools = [Model("BoxSelectTool"), Model("TapTool")] if selects else []
    return [*tools, Model("BoxZoomTool"), Model("PanTool"), Model("WheelZoomTool")]


def _swatch(layer: Layer) -> str:
    if isinstance(layer, Curve | Rules) and layer.dash != "solid":
        return layer.dash
    if isinstance(layer, Points) and layer.shape == "tick":
        return "tick"
    return _SWATCHES.get(type(layer), "area")


def draw_all(figures: Iterable[Figure]) -> tuple[Drawing, Sequence[Drawn]]:
    """Draw the figures of one page."""
    drawing = Drawing()
    return drawing, [drawing.draw(figure) for figure in figures]
