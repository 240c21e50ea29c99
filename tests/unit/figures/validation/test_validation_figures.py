"""Places of values in their ranges, and what the overview counts."""

import numpy as np
import pytest

from arcless.figures.description import Points, Segments
from arcless.figures.validation import in_range, overview
from arcless.figures.validation.ranges import HIGH, LOW
from arcless.validate import Range, Row

FORCE = Range("f", "force", "N", 110.0, 120.0, "A")
LOSS = Range("l", "loss", "%", 0.0, 0.0, "A")
REMEMBERED = Range("r", "deviation", "N", 30.0, 40.0, "C*")
OPEN = Range("g", "gap", "mm", 0.0, None, "A", strict=True)


def row(case: str, allowed: Range, value: float | None, sure: float | None = None) -> Row:
    return Row.of(case, allowed, value, sure)


@pytest.mark.parametrize(
    ("allowed", "value", "place"),
    [
        (FORCE, 110.0, 0.0), (FORCE, 120.0, 1.0), (FORCE, 117.5, 0.75), (FORCE, None, None),
        (LOSS, 0.0, 0.5), (LOSS, 0.1, HIGH), (LOSS, -0.1, LOW), (OPEN, 1.0, None),
    ],
)  # fmt: skip
def test_places(allowed: Range, value: float | None, place: float | None) -> None:
    assert in_range(row("a", allowed, value), value) == place


def test_the_overview_has_a_row_for_each_case_and_a_colour_for_each_verdict() -> None:
    rows = [
        row("a", FORCE, 115.0, 1.0), row("a", FORCE, 400.0), row("b", REMEMBERED, 50.0),
        row("c", OPEN, 1.0),
    ]  # fmt: skip
    figure = overview(rows, [True, True, False, True])
    assert figure is not None
    assert figure.y.categories == ("b", "a")
    marks = {
        (layer.colour, layer.shape): list(layer.x)
        for layer in figure.layers
        if isinstance(layer, Points)
    }
    # What is far outside stands at the edge.
    assert marks == {
        ("met", "circle"): [0.5], ("not_met", "circle"): [HIGH], ("open", "diamond"): [HIGH],
    }  # fmt: skip
    (whiskers,) = (layer for layer in figure.layers if isinstance(layer, Segments))
    assert np.array([whiskers.x0, whiskers.x1]).ravel() == pytest.approx([0.4, 0.6])
    assert "1 are outside of a verified range" in figure.alt


def test_no_overview_of_ranges_with_one_bound() -> None:
    assert overview([row("c", OPEN, 1.0)], [True]) is None
