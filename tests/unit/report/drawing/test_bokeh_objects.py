"""Figures as Bokeh's script reads them: what its own classes make of our objects."""

import json
from typing import Any

import numpy as np
import pytest

from arcless.figures.description.tokens import colour
from arcless.report.drawing.bokeh_objects import Columns, Field, Model, Token, Value, document
from tests.support.bokeh_pages import document_of, mistakes_of


def read(*roots: Model) -> Any:
    """Our objects, written as text and read again."""
    written = document(roots).roots
    return document_of(json.loads(json.dumps(written, allow_nan=False))).roots


@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.int32, np.int64])
def test_columns_come_back_as_they_were(dtype: Any) -> None:
    values = np.arange(5).astype(dtype)
    (source,) = read(Columns({"x": values, "word": [*"abcde"], "y": values[::-1]}))
    assert list(source.data["x"]) == [0, 1, 2, 3, 4]
    assert list(source.data["y"]) == [4, 3, 2, 1, 0]  # backwards in memory
    assert list(source.data["word"]) == [*"abcde"]


def test_what_json_has_no_numbers_for() -> None:
    (source,) = read(Columns({"x": [np.nan, np.inf, -np.inf, np.float32(0.5), np.int64(3)]}))
    assert np.array_equal(source.data["x"], [np.nan, np.inf, -np.inf, 0.5, 3], equal_nan=True)


def test_what_is_shared_is_written_once() -> None:
    track = Model("Range1d", start=0.0, end=1.0)
    one, other = read(Model("Plot", x_range=track), Model("Plot", x_range=track))
    assert one.x_range is other.x_range
    assert one.y_range is not other.y_range


def test_the_same_values_are_one_column() -> None:
    source, values = Columns(), np.arange(3.0)
    assert source.name_of(values) == source.name_of(values)
    assert source.name_of(values) != source.name_of(values.copy())
    assert len(source.data) == 2


def test_a_token_is_its_light_colour_and_is_listed() -> None:
    written = document([Model("Span", line_color=Token("limit"))])
    assert written.roots[0]["attributes"]["line_color"] == colour("limit")
    assert written.colours == {"limit": [[written.names[0], "line_color"]]}


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
