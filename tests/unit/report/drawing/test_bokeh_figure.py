"""Descriptions of figures, drawn: Bokeh's own classes read what is written."""

import json
from typing import Any

import numpy as np
import pytest

from arcless.figures.description import (
    Area,
    Axis,
    Bars,
    Curve,
    Figure,
    Map,
    Points,
    Rules,
    Scale,
    Segments,
    Strip,
    Texts,
    Tip,
)
from arcless.figures.description.tokens import colour, shades
from arcless.report.drawing.bokeh_figure import Drawing
from arcless.report.drawing.bokeh_objects import document
from tests.support.bokeh_pages import document_of, mistakes_of

X = np.array([0.0, 1.0, 2.0])
Y = np.array([1.0, 3.0, 2.0])
AXES = Axis("distance", "m"), Axis("force", "N")


def read(drawing: Drawing, *figures: Figure) -> list[Any]:
    """Drawn, written as text and read again."""
    written = document([drawing.draw(figure).plot for figure in figures])
    found = document_of(json.loads(json.dumps(written.roots, allow_nan=False)))
    assert not mistakes_of(found)
    return found.roots


def one(*layers: Any, **more: Any) -> Any:
    (plot,) = read(Drawing(), Figure("key", "title", *AXES, layers, **more))
    return plot


def column(renderer: Any, field: str) -> Any:
    return renderer.data_source.data[getattr(renderer.glyph, field).field]


def test_axes_have_names_and_units() -> None:
    plot = one(Curve(X, Y))
    assert plot.below[0].axis_label == "distance, m"
    assert plot.left[0].axis_label == "force, N"
    assert plot.toolbar_location is None  # the page has one for all


@pytest.mark.parametrize(
    ("axis", "start", "end"),
    [(Axis("x", low=1.0, high=4.0), 1.0, 4.0), (Axis("x", low=1.0), 1.0, None)],
)
def test_ranges(axis: Axis, start: float, end: float | None) -> None:
    (plot,) = read(Drawing(), Figure("key", "title", axis, AXES[1], [Curve(X, Y)]))
    assert plot.x_range.start == start
    assert end is None or plot.x_range.end == end


def test_a_range_has_bounds() -> None:
    axis = Axis("x", low=1.0, high=4.0, bounds=(0.0, 9.0))
    (plot,) = read(Drawing(), Figure("key", "title", axis, AXES[1], [Curve(X, Y)]))
    assert list(plot.x_range.bounds) == [0.0, 9.0]


def test_logarithmic_axes_and_categories() -> None:
    y = Axis("density", "N²/Hz", 1.0, 100.0, logarithmic=True)
    words = Axis("dropper", categories=("span 1", "", "span 2"))
    first, second = read(
        Drawing(),
        Figure("a", "a", AXES[0], y, [Curve(X, Y)]),
        Figure("b", "b", AXES[0], words, [Curve(X, Y)]),
    )
    assert type(first.y_scale).__name__ == "LogScale"
    assert type(first.left[0]).__name__ == "LogAxis"
    assert second.left[0].major_label_overrides == {0: "span 1", 2: "span 2"}
    assert second.left[0].ticker.ticks == [0, 2]


def test_figures_of_a_group_share_range_and_cross_hair() -> None:
    axis = Axis("x", low=0.0, high=2.0, group="track")
    figures = [Figure(key, key, axis, AXES[1], [Curve(X, Y)]) for key in ("a", "b")]
    alone = Figure("c", "c", AXES[0], AXES[1], [Curve(X, Y)])
    first, second, third = read(Drawing(), *figures, alone)
    assert first.x_range is second.x_range is not third.x_range
    spans = [
        {span.id for tool in plot.tools if type(tool).__name__ == "CrosshairTool"
         for span in (tool.overlay if tool.overlay != "auto" else ())}
        for plot in (first, second, third)
    ]  # fmt: skip
    assert len(spans[0] & spans[1]) == 1
    assert spans[2] == set()


def test_curves_over_the_same_places_share_their_columns() -> None:
    first, second = Curve(X, Y), Curve(X, 2.0 * Y)
    other = Curve(X.copy(), Y)
    sources = [renderer.data_source for renderer in one(first, second, other).renderers]
    assert sources[0] is sources[1] is not sources[2]
    assert len(sources[0].data) == 3


def test_every_kind_of_layer_has_its_numbers() -> None:
    plot = one(
        Strip(axis="x", low=0.5, high=1.5, colour="section"),
        Rules(axis="y", at=np.array([2.5]), colour="limit", dash="dashed"),
        Curve(X, Y, colour="pantograph_1", width=2.0),
        Area(X, Y, Y + 1.0),
        Points(X, Y, shape="diamond", size=9.0),
        Segments(X, Y, X, Y + 1.0),
        Bars(X, X + 0.5, 0.0 * Y, Y),
        Texts(X, Y, ["a", "b", "c"], align="left", baseline="top"),
    )
    rules, line, area, dots, pieces, bars, texts = plot.renderers
    (strip,) = [each for each in plot.center if type(each).__name__ == "BoxAnnotation"]
    assert (strip.left, strip.right) == (0.5, 1.5)
    assert (column(rules, "y") == [2.5]).all()
    assert list(rules.glyph.line_dash) == [7, 4]
    assert (column(line, "y") == Y).all()
    assert (line.glyph.line_color, line.glyph.line_width) == (colour("pantograph_1"), 2.0)
    assert (column(area, "y2") == Y + 1.0).all()
    assert dots.glyph.size == 9.0
    assert (column(pieces, "y1") == Y + 1.0).all()
    assert (column(bars, "top") == Y).all()
    assert list(column(texts, "text")) == ["a", "b", "c"]
    assert (texts.glyph.text_align, texts.glyph.text_baseline) == ("left", "top")


def test_a_map_has_the_scale_and_keeps_what_lies_below_it() -> None:
    values = np.array([[0.0, 0.5], [1.0, np.nan]])
    scale = Scale("force", "N", 0.01, 1.0, under="slack")
    tips = (Tip("force", "x", "N"),)
    plot = one(Map((0.0, 2.0), (0.0, 2.0), values, tips=tips), scale=scale)
    (renderer,) = plot.renderers
    image = renderer.data_source.data["image"][0]
    assert image[0, 0] == 0.0 < scale.low
    # Rounded to a part in 250 of the scale, half of that at most.
    np.testing.assert_allclose(image[[0, 1], [1, 0]], [0.5, 1.0], atol=0.5 * 0.99 / 250)
    assert np.isnan(image[1, 1])
    mapper = renderer.glyph.color_mapper
    assert (mapper.low_color, tuple(mapper.palette)) == (colour("slack"), shades("sequential"))
    assert not plot.right  # the page shows the scale: frames of all figures have the same ends
    assert renderer.level == "image"
    assert not [each for each in plot.center if type(each).__name__ == "Grid"]


def test_points_of_a_selection_fade_together() -> None:
    drawing = Drawing()
    figures = [Figure(key, key, *AXES, [Points(X, Y, selection="variants")]) for key in ("a", "b")]
    first, second = read(drawing, *figures)
    dots = [plot.renderers[0] for plot in (first, second)]
    assert dots[0].data_source is dots[1].data_source
    assert dots[0].nonselection_glyph.fill_alpha < dots[0].glyph.fill_alpha
    assert type(first.toolbar.active_drag).__name__ == "BoxSelectTool"


def test_long_columns_are_rounded_finer_than_a_pixel_but_places_are_not() -> None:
    x = np.linspace(0.0, 50_000.0, 5000)
    y = np.random.default_rng(1).normal(size=x.size)
    (renderer,) = one(Curve(x, y)).renderers
    np.testing.assert_array_equal(column(renderer, "x"), x.astype(np.float32))
    # Half a step of at most a part in 16 000 of the range.
    assert np.abs(column(renderer, "y") - y).max() <= 0.5 * np.ptp(y) / 16_000


def test_small_numbers_of_a_logarithmic_axis_stay_as_they_are() -> None:
    y = Axis("density", "N²/Hz", 1e-3, 1e4, logarithmic=True)
    values = np.geomspace(1e-3, 1e4, 1000)
    x = np.arange(1000.0)
    (plot,) = read(Drawing(), Figure("a", "a", AXES[0], y, [Curve(x, values)]))
    (renderer,) = plot.renderers
    # Rounded to a part of their range most of them would be zero.
    np.testing.assert_array_equal(column(renderer, "y"), values.astype(np.float32))


def test_layers_lie_in_their_order() -> None:
    plot = one(Bars(X, X + 0.5, 0.0 * Y, Y), Rules(axis="y", at=np.array([2.5])), Curve(X, Y))
    assert {renderer.level for renderer in plot.renderers} == {"glyph"}


def test_the_subject_stands_first_in_the_legend() -> None:
    drawn = Drawing().draw(
        Figure("a", "a", *AXES, [
            Rules(axis="x", at=X, colour="support", name="support"),
            Curve(X, Y, name="force", colour="pantograph_1"),
            Curve(X, Y, name="force"),
            Curve(X, Y, name="other", hidden=True),
        ])
    )  # fmt: skip
    assert [entry.name for entry in drawn.legend] == ["other", "force", "support"]
    assert [len(entry.drawn) for entry in drawn.legend] == [1, 2, 1]
    assert [entry.hidden for entry in drawn.legend] == [True, False, False]
    assert [made.visible for made in drawn.legend[0].drawn] == [False]


def test_a_mark_stands_in_the_legend_with_its_shape_unless_there_are_several() -> None:
    def swatch(*layers: Any) -> str:
        (entry,) = Drawing().draw(Figure("a", "a", *AXES, layers)).legend
        return entry.swatch

    diamonds = Points(X, Y, shape="diamond", name="inside")
    assert swatch(diamonds) == "diamond"
    assert swatch(diamonds, Points(X, Y, name="inside")) == "dot"
    assert swatch(diamonds, Curve(X, Y, name="inside")) == "diamond"


def test_texts_are_no_formulas_and_tips_no_markup() -> None:
    tips = (Tip("$$x$$", ["@y", "<b>", "$$z$$"], form=""), Tip("force", "y", "N"))
    plot = one(Curve(X, Y, tips=tips), Texts(X, Y, ["$$a$$", r"\(b\)", "c"]))
    assert "$$" not in json.dumps(list(column(plot.renderers[1], "text")))
    (hover,) = [tool for tool in plot.tools if type(tool).__name__ == "HoverTool"]
    (label, name), (_, value) = hover.tooltips
    assert "$$" not in label
    assert name.startswith("@c")  # the name of a column, and no text of a user
    assert value.endswith("{0.0} N")


def test_colours_are_listed_by_their_tokens() -> None:
    drawing = Drawing()
    written = document([drawing.draw(Figure("a", "a", *AXES, [Curve(X, Y, colour="limit")])).plot])
    ((_, attribute),) = written.colours["limit"]
    assert attribute == "line_color"
    assert {"ink", "soft", "rule", "grid"} <= written.colours.keys()
