"""Figures as Bokeh's script reads them: what its own classes make of our objects."""

import json
from typing import Any

import numpy as np
import pytest

from arcless.report.drawing.bokeh_objects import Field, Model, Value, columns, document
from arcless.report.drawing.style import figure
from tests.support.bokeh_pages import document_of, mistakes_of


def read(*roots: Model) -> Any:
    """Our objects, written as text and read again."""
    written, _ = document(roots)
    return document_of(json.loads(json.dumps(written, allow_nan=False))).roots


@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.int32, np.int64])
def test_columns_come_back_as_they_were(dtype: Any) -> None:
    values = np.arange(5).astype(dtype)
    (source,) = read(columns({"x": values, "word": [*"abcde"], "y": values[::-1]}))
    assert list(source.data["x"]) == [0, 1, 2, 3, 4]
    assert list(source.data["y"]) == [4, 3, 2, 1, 0]  # backwards in memory
    assert list(source.data["word"]) == [*"abcde"]


def test_what_json_has_no_numbers_for() -> None:
    (source,) = read(columns({"x": [np.nan, np.inf, -np.inf, np.float32(0.5), np.int64(3)]}))
    assert np.array_equal(source.data["x"], [np.nan, np.inf, -np.inf, 0.5, 3], equal_nan=True)


def test_what_is_shared_is_written_once() -> None:
    track = Model("Range1d", start=0.0, end=1.0)
    one, other = read(figure("a", "x", "y", x_range=track), figure("b", "x", "y", x_range=track))
    assert one.x_range is other.x_range
    assert one.y_range is not other.y_range


def test_columns_colours_and_values() -> None:
    fig = figure("title", "x", "y", selects=True)
    mapper = Model("LinearColorMapper", palette=["#000000", "#ffffff"], low=0.0, high=1.0)
    data = {"x": np.zeros(2), "y": np.ones(2), "c": np.ones(2)}
    fig.draw("Scatter", data, color=Field("c", mapper), line_color=None, unselected=0.1)
    fig.draw("Segment", data, "x", "y", "x", "c", alpha=0.5, name="pieces", level="underlay")
    (made,) = read(fig)
    dots, pieces = made.renderers
    assert dots.glyph.fill_color.transform.palette == ["#000000", "#ffffff"]
    assert dots.glyph.line_color is None
    assert dots.nonselection_glyph.fill_alpha == 0.1
    assert dots.nonselection_glyph.x == dots.glyph.x
    assert (pieces.glyph.y1.field, pieces.glyph.line_alpha) == ("c", 0.5)
    assert (pieces.name, pieces.level) == ("pieces", "underlay")
    assert type(made.toolbar.active_drag).__name__ == "BoxSelectTool"


def test_axes() -> None:
    logarithmic, words = read(
        figure("a", "x", "y", logarithmic=True), figure("b", "x", "", names=["low", "high"])
    )
    assert type(logarithmic.y_scale).__name__ == "LogScale"
    assert type(logarithmic.left[0]).__name__ == "LogAxis"
    assert words.y_range.factors == ["low", "high"]
    assert words.left[0].axis_label is None


def test_a_value_is_no_column() -> None:
    (item,) = read(Model("LegendItem", label=Value("x")))
    assert item.label.value == "x"


def test_bokeh_refuses_what_it_does_not_know() -> None:
    """That is what the tests of pages rely on."""
    with pytest.raises(AssertionError, match="colour"):
        read(Model("Line", colour="red"))
    with pytest.raises(KeyError, match="Lime"):
        read(Model("Lime"))
    with pytest.raises(ValueError, match="line_width"):
        read(Model("Line", line_width="wide", x=Field("x"), y=Field("y")))
    assert not mistakes_of(document_of([]))


def test_what_was_not_given_is_told() -> None:
    with pytest.raises(AttributeError, match="Line was given no line_color"):
        _ = Model("Line").line_color
