"""Figures drawn by matplotlib and by Bokeh: the same ranges, numbers, colours and words."""

from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_hex

from arcless.figures.description import (
    Area,
    Bars,
    Curve,
    Figure,
    Map,
    Points,
    Rules,
    Segments,
    Strip,
    Texts,
)
from arcless.figures.description.layers import Layer
from arcless.figures.description.tokens import colour
from arcless.report.drawing.bokeh_objects import Field, Model, Token
from tests.unit.figures.paper.conftest import Both

KINDS = {"Strip", "Curve", "Area", "Points", "Segments", "Bars", "Rules", "Map", "Texts"}
# Bokeh's numbers are in single precision, with 24 bits.
SINGLE = 2.0**-23


def pairs(figure: Figure, plot: Model, axes: Any) -> list[tuple[Layer, Model, list[Any]]]:
    """Return each layer that is seen, with Bokeh's object and matplotlib's of it."""
    strips = iter([made for made in plot.center if made.kind == "BoxAnnotation"])
    others = iter(plot.renderers)
    found = []
    for layer in figure.layers:
        made = next(strips if isinstance(layer, Strip) else others)
        if layer.hidden:
            assert not made.visible
            continue
        gid = f"layer-{len(found)}"
        found.append((layer, made, [one for one in axes.get_children() if one.get_gid() == gid]))
    return found


def numbers_in_bokeh(made: Model) -> list[Any]:
    """Return the places of what Bokeh draws, by the names of its glyph; of a map none."""
    if made.kind == "BoxAnnotation":
        return [
            getattr(made, name) for name in ("left", "right", "bottom", "top") if name in vars(made)
        ]
    if made.glyph.kind == "Image":
        return []
    data = made.data_source.data
    names = ("x", "y", "x0", "y0", "x1", "y1", "y2", "left", "right", "bottom", "top")
    given = {name: vars(made.glyph).get(name) for name in names}
    return [data[place.name] for place in given.values() if isinstance(place, Field)]


def numbers_on_paper(layer: Layer, drawn: list[Any]) -> list[Any]:
    """Return the places of what matplotlib draws, in the order of Bokeh's; of a map none."""
    one = drawn[0]
    found: list[Any] = []
    match layer:
        case Texts():
            found = list(np.transpose([text.get_position() for text in drawn]))
        case Strip():
            ends = one.get_extents().transformed(one.axes.transData.inverted())
            found = list(getattr(ends, f"interval{layer.axis}"))
        case Rules():
            along = 0 if layer.axis == "x" else 1
            found = [[piece[0][along] for piece in one.get_segments()]]
        case Segments():
            found = list(np.transpose([np.ravel(piece) for piece in one.get_segments()]))
        case Bars():
            corners = np.array([path.vertices for path in one.get_paths()])
            left, right = corners[:, [0, 3], 0].max(axis=1), corners[:, [1, 2], 0].min(axis=1)
            low, high = corners[:, [0, 1], 1].max(axis=1), corners[:, [2, 3], 1].min(axis=1)
            found = [left, right, low, high]
        case Area():  # an outline: over the lower curve and back over the upper one
            outline, count = one.get_paths()[0].vertices, len(layer.x)
            lower, upper = outline[1 : count + 1], outline[count + 2 : 2 * count + 2][::-1]
            found = [lower[:, 0], lower[:, 1], upper[:, 1]]
        case Points() if layer.values is not None:
            found = list(np.transpose(one.get_offsets().filled(np.nan)))
        case Curve() | Points():
            found = [one.get_xdata(), one.get_ydata()]
    return found


def ink_in_bokeh(made: Model) -> str | None:
    """Return the colour of a glyph; None where its values have colours."""
    look = vars(made.glyph if made.kind == "GlyphRenderer" else made)
    for name in ("line_color", "fill_color", "text_color"):
        if isinstance(look.get(name), Token):
            return colour(look[name].name)
    return None


def opacity_in_bokeh(made: Model) -> float | None:
    look = vars(made.glyph if made.kind == "GlyphRenderer" else made)
    found = {value for name, value in look.items() if name.endswith("_alpha")}
    return found.pop() if len(found) == 1 else None


def ink_on_paper(one: Any) -> str:
    for name in ("get_facecolor", "get_color"):
        if hasattr(one, name):
            found = getattr(one, name)()
            if not isinstance(found, str) and np.ndim(found) > 1:
                found = found[0] if len(found) else one.get_edgecolor()[0]
            return to_hex(found)
    raise AssertionError(one)


def check_range(given: Model, ends: tuple[float, float], values: list[float]) -> None:
    """Fail where an axis does not show what Bokeh's range of it shows."""
    if given.kind == "Range1d":
        assert ends == pytest.approx((given.start, given.end))
        return
    for name, end in zip(("start", "end"), ends, strict=True):
        if hasattr(given, name):
            assert end == pytest.approx(getattr(given, name))
    assert ends[0] <= min(values) < max(values) <= ends[1]
    # An end that follows from the data is near them: of the whole range at most a tenth is empty.
    if not hasattr(given, "start") and not hasattr(given, "end"):
        assert max(values) - min(values) > 0.9 * (ends[1] - ends[0])


def test_both_drawings_hold_the_same(everything: list[Both]) -> None:
    kinds: set[str] = set()
    for both in everything:
        figure, drawn, axes = both.figure, both.bokeh, both.axes
        assert axes.get_xlabel() == (drawn.plot.below[0].axis_label or "").replace("\u200b", "")
        assert axes.get_ylabel() == (drawn.plot.left[0].axis_label or "").replace("\u200b", "")
        for which in ("x", "y"):
            scale = getattr(drawn.plot, f"{which}_scale").kind
            assert getattr(axes, f"get_{which}scale")() == scale.removesuffix("Scale").lower()
        for layer, made, found in pairs(figure, drawn.plot, axes):
            kinds.add(type(layer).__name__)
            assert found, (figure.key, layer)
            numbers = zip(numbers_on_paper(layer, found), numbers_in_bokeh(made), strict=True)
            for one, other in numbers:
                # Single precision; pages round long columns to a part in 16 000 of their range.
                rounded = np.nanmax(one, initial=0.0) - np.nanmin(one, initial=0.0)
                least = SINGLE + 0.5 * rounded / 16_000
                np.testing.assert_allclose(one, other, rtol=SINGLE, atol=least, err_msg=figure.key)
            opacity = {one.get_alpha() for one in found}
            assert opacity == {opacity_in_bokeh(made)} or isinstance(layer, Map)
            ink = ink_in_bokeh(made)
            if ink is not None:
                assert {ink_on_paper(one) for one in found} == {ink}, (figure.key, layer)
    assert kinds == KINDS


def test_legends_have_the_same_entries_in_the_same_order(everything: list[Both]) -> None:
    for both in everything:
        figure = both.figure
        expected = [one.name for one in both.bokeh.legend if not one.hidden]
        if figure.scale is not None and figure.scale.under_label:
            expected.append(figure.scale.under_label)  # which a page has in its caption
        legend = both.axes.get_legend()
        found = [] if legend is None else [text.get_text() for text in legend.get_texts()]
        assert sorted(found) == sorted(expected)
        columns = 1 if legend is None else legend._ncols
        # Read along the rows: matplotlib goes down the columns, the first of them are the longer.
        rows = -(-len(found) // columns)
        longer = len(found) - (rows - 1) * columns
        starts = np.cumsum([0, *(rows - (place >= longer) for place in range(columns))])
        read = [found[starts[place % columns] + place // columns] for place in range(len(found))]
        assert read == expected


def test_ranges_are_the_same(everything: list[Both]) -> None:
    for both in everything:
        figure, drawn, axes = both.figure, both.bokeh, both.axes
        for which in ("x", "y"):
            values = [
                float(value)
                for layer in figure.layers
                if not layer.hidden
                for value in np.ravel(places(layer, which))
                if np.isfinite(value)
            ]
            ends = getattr(axes, f"get_{which}lim")()
            check_range(getattr(drawn.plot, f"{which}_range"), ends, values)


def places(layer: Layer, which: str) -> Any:
    """Return the places of a layer along an axis, of those that have some of their own."""
    names = {
        "x": ("x", "x0", "x1", "left", "right"),
        "y": ("y", "y0", "y1", "low", "high"),
    }[which]
    if isinstance(layer, Strip):
        return []
    return np.concatenate(
        [np.empty(0), *(np.ravel(getattr(layer, name)) for name in names if hasattr(layer, name))]
    )


def test_colours_of_a_map_are_those_of_bokeh(everything: list[Both]) -> None:
    both = next(one for one in everything if one.figure.key == "mapped")
    (image,) = both.bokeh.plot.renderers[1:]
    mapper = image.glyph.color_mapper
    (drawn,) = both.axes.get_images()
    assert drawn.get_extent() == [0.0, 3.0, -0.5, 1.5]
    assert drawn.norm.vmin == mapper.low
    assert drawn.norm.vmax == mapper.high
    assert to_hex(drawn.to_rgba(mapper.high)) == mapper.palette[-1]
    assert to_hex(drawn.to_rgba(mapper.low)) == mapper.palette[0]
    assert to_hex(drawn.to_rgba(0.5 * mapper.low)) == colour(mapper.low_color.name)
    # The hole is empty, and the numbers are those of the description.
    assert np.ma.getmaskarray(drawn.get_array()).tolist() == [[False] * 3, [False, True, False]]
    held = image.data_source.data["image"][0]
    # Bokeh's values are rounded to steps of a 250th of the scale.
    np.testing.assert_allclose(
        drawn.get_array().filled(np.nan), held, atol=(mapper.high - mapper.low) / 250 + SINGLE
    )


def test_texts_stay_as_they_are(everything: list[Both]) -> None:
    axes = next(one for one in everything if one.figure.key == "made-up").axes
    texts = [*axes.texts, axes._left_title, *axes.get_legend().get_texts(), *axes.get_xticklabels()]
    assert len(texts) > 10
    assert not any(text.get_parse_math() for text in texts)
