"""Layers of a figure → glyphs and annotations of Bokeh's script."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

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
    Tip,
)
from arcless.figures.description.tokens import tokens
from arcless.report.drawing.bokeh_objects import Columns, Field, Model, Token, Value

FONT: str = tokens()["font"]["text"]
_DASHES: Mapping[str, tuple[int, ...]] = {"solid": (), "dashed": (7, 4), "dotted": (2, 3)}
_SHAPES = {
    "circle": "circle", "tick": "dash", "triangle": "triangle", "down": "inverted_triangle",
    "diamond": "diamond", "cross": "x",
}  # fmt: skip
# Steps of a scale that a map distinguishes: finer than a screen shows, and small in a file.
_STEPS = 250
_UNSELECTED = 0.12
# Columns that are rounded, and the parts of their range: finer than a figure of 4000 px shows.
_LONG, _PARTS = 200, 4000 * 4


@dataclass
class Sources:
    """Columns of a page: those of a selection, and those that curves over the same places share."""

    selections: dict[str, Columns] = field(default_factory=dict)
    # The places are kept with their columns, so that no others have the same identity.
    by_place: dict[int, tuple[Any, Columns]] = field(default_factory=dict)

    def of_selection(self, name: str) -> Columns:
        """Return the columns of a selection; figures and a table draw from the same."""
        return self.selections.setdefault(name, Columns())

    def over(self, x: Any) -> tuple[Columns, str]:
        """Return the columns of curves over these places, and the name of the places in them."""
        if id(x) not in self.by_place:
            self.by_place[id(x)] = x, Columns()
        source = self.by_place[id(x)][1]
        return source, column(source, x, _single)


@dataclass(frozen=True)
class Canvas:
    """The plot that layers are added to, the colours of its scale, and the page's columns."""

    plot: Model
    mapper: Model | None
    sources: Sources

    def add(self, layer: Layer) -> Model:
        """Add a layer; return the object that shows and hides it."""
        made = _DRAWN_BY[type(layer)](self, layer)
        made.visible = not layer.hidden
        return made

    def glyph(
        self,
        layer: Layer,
        source: Columns,
        kind: str,
        look: dict[str, Any],
        **places: str,
    ) -> Model:
        """Add a glyph, its places given as names of columns, with what the pointer shows."""
        glyph = Model(kind, **{place: Field(name) for place, name in places.items()}, **look)
        made = Model("GlyphRenderer", data_source=source, glyph=glyph)
        self.plot.renderers.append(made)
        if layer.tips:
            tips = [(plain(tip.label), _tip(source, tip, places)) for tip in layer.tips]
            hover = Model("HoverTool", renderers=[made], tooltips=tips, visible=False)
            if kind == "Line":
                hover.line_policy = "nearest"
            self.plot.toolbar.tools.append(hover)
        return made


def plain(text: str) -> str:
    """Return text that a figure shows as it is: Bokeh reads dollar pairs as formulas."""
    for opening in ("$$", r"\(", r"\["):
        text = text.replace(opening, opening[0] + "\u200b" + opening[1])
    return text


def _single(values: Any) -> Any:
    """Return numbers in single precision: half the size in the file, finer than a pixel."""
    return np.asarray(values, dtype=np.float32)


def _rounded(values: Any) -> Any:
    """Return numbers in single precision, long ones rounded to a part in `_PARTS` of their range.

    The last bits are zeros then, which makes a file smaller by a quarter; places keep all.
    """
    numbers = _single(values)
    if numbers.size < _LONG:
        return numbers
    extent = float(np.nanmax(numbers) - np.nanmin(numbers))
    if not np.isfinite(extent) or extent <= 0.0:
        return numbers
    step = np.float32(2.0 ** np.floor(np.log2(extent / _PARTS)))
    return np.round(numbers / step) * step


def column(source: Columns, values: Any, write: Callable[[Any], Any] = _rounded) -> str:
    """Return the name of the column with these values, which is added where there is none.

    Parameters
    ----------
    source
        The columns.
    values
        Numbers or texts; the same object is the same column.
    write
        Change of numbers to those that are written.
    """
    name = source.name_of(values)
    if source.data[name] is values:
        texts = isinstance(values, list | tuple) and values and isinstance(values[0], str)
        source.data[name] = [plain(text) for text in values] if texts else write(values)
    return name


def _tip(source: Columns, tip: Tip, places: Mapping[str, str]) -> str:
    """Return a template, in which data are names of columns alone: a mark in it takes raw HTML."""
    name = places[tip.values] if isinstance(tip.values, str) else column(source, tip.values)
    form = f"{{{tip.form}}}" if tip.form else ""
    return f"@{name}{form} {tip.unit}".rstrip()


def _line(layer: Any) -> dict[str, Any]:
    look = {"line_color": Token(layer.colour), "line_alpha": layer.alpha, "line_width": layer.width}
    dash = _DASHES[getattr(layer, "dash", "solid")]
    return {**look, "line_dash": dash} if dash else look


def _fill(layer: Layer) -> dict[str, Any]:
    return {"fill_color": Token(layer.colour), "fill_alpha": layer.alpha}


def _strip(canvas: Canvas, layer: Strip) -> Model:
    ends = ("left", "right") if layer.axis == "x" else ("bottom", "top")
    places = dict(zip(ends, (layer.low, layer.high), strict=True))
    made = Model("BoxAnnotation", level="image", line_color=None, **places, **_fill(layer))
    canvas.plot.center.append(made)
    return made


def _rules(canvas: Canvas, layer: Rules) -> Model:
    kind, place = ("VSpan", "x") if layer.axis == "x" else ("HSpan", "y")
    source = Columns({place: _single(layer.at)})
    return canvas.glyph(layer, source, kind, _line(layer), **{place: place})


def _curve(canvas: Canvas, layer: Curve) -> Model:
    source, x = canvas.sources.over(layer.x)
    # Rounded to a part of the range, small numbers of a logarithmic axis would be zero: no place.
    write = _single if canvas.plot.y_scale.kind == "LogScale" else _rounded
    y = column(source, layer.y, write)
    return canvas.glyph(layer, source, "Line", _line(layer), x=x, y=y)


def _area(canvas: Canvas, layer: Area) -> Model:
    source, x = canvas.sources.over(layer.x)
    ends = {"y1": column(source, layer.low), "y2": column(source, layer.high)}
    return canvas.glyph(layer, source, "VArea", _fill(layer), x=x, **ends)


def _points(canvas: Canvas, layer: Points) -> Model:
    chosen = layer.selection
    source = canvas.sources.of_selection(chosen) if chosen else Columns()
    colour: Any = Token(layer.colour)
    if layer.values is not None:
        colour = Field(column(source, layer.values), canvas.mapper)
    look: dict[str, Any] = {"marker": Value(_SHAPES[layer.shape]), "size": layer.size}
    look |= {"fill_color": colour, "fill_alpha": layer.alpha, "line_alpha": layer.alpha}
    look["line_color"] = colour if layer.shape in ("tick", "cross") else None
    if layer.shape == "tick":
        look["angle"] = np.pi / 2
    places = {"x": column(source, layer.x), "y": column(source, layer.y)}
    made = canvas.glyph(layer, source, "Scatter", look, **places)
    if chosen:
        faded = {"fill_alpha": _UNSELECTED, "line_alpha": _UNSELECTED}
        made.nonselection_glyph = Model("Scatter", **{**vars(made.glyph), **faded})
    return made


def _segments(canvas: Canvas, layer: Segments) -> Model:
    ends = {name: _single(getattr(layer, name)) for name in ("x0", "y0", "x1", "y1")}
    return canvas.glyph(layer, Columns(ends), "Segment", _line(layer), **_named(ends))


def _bars(canvas: Canvas, layer: Bars) -> Model:
    edges = {"left": layer.left, "right": layer.right, "bottom": layer.low, "top": layer.high}
    data = {name: _single(values) for name, values in edges.items()}
    look = {**_fill(layer), "line_color": None}
    return canvas.glyph(layer, Columns(data), "Quad", look, **_named(data))


def _texts(canvas: Canvas, layer: Texts) -> Model:
    data = {"x": _single(layer.x), "y": _single(layer.y), "text": [*map(plain, layer.texts)]}
    look = {
        "text_color": Token(layer.colour),
        "text_alpha": layer.alpha,
        "text_font": Value(FONT),
        "text_font_size": f"{layer.size:g}px",
        "text_align": layer.align,
        "text_baseline": layer.baseline,
    }
    if layer.backed:
        look |= {"background_fill_color": Token("paper"), "padding": 2}
    return canvas.glyph(layer, Columns(data), "Text", look, **_named(data))


def _map(canvas: Canvas, layer: Map) -> Model:
    """Draw a map, its values rounded to steps of the scale; those below the scale stay there."""
    mapper = canvas.mapper
    assert mapper is not None, "a map needs the figure's scale"
    step = (mapper.high - mapper.low) / _STEPS
    rounded = mapper.low + np.round((layer.values - mapper.low) / step) * step
    values = np.where(layer.values < mapper.low, layer.values, rounded)
    data = {
        "image": [_single(values)],
        "x": [layer.x[0]],
        "y": [layer.y[0]],
        "dw": [layer.x[1] - layer.x[0]],
        "dh": [layer.y[1] - layer.y[0]],
    }
    made = canvas.glyph(layer, Columns(data), "Image", {"color_mapper": mapper}, **_named(data))
    made.level = "image"  # below all others
    for tip in layer.tips[:1]:
        value = f"@image{{{tip.form}}} {tip.unit}".rstrip()
        place = (canvas.plot.below[0].axis_label or "x", "$x{0.0}")
        canvas.plot.toolbar.tools[-1].tooltips = [(plain(tip.label), value), place]
    return made


def _named(data: Mapping[str, Any]) -> dict[str, str]:
    return {name: name for name in data}


_DRAWN_BY: Mapping[type, Callable[[Canvas, Any], Model]] = {
    Area: _area,
    Bars: _bars,
    Curve: _curve,
    Map: _map,
    Points: _points,
    Rules: _rules,
    Segments: _segments,
    Strip: _strip,
    Texts: _texts,
}
