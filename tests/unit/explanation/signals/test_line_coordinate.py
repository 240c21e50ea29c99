"""Positions counted in spans and in dropper intervals."""

import numpy as np

from arcless.explanation.signals.line_coordinate import LineCoordinate
from arcless.model import load
from tests.support.passages import EQUAL, UNEQUAL, line_of
from tests.support.synthetic import scenario_data


def test_supports_and_droppers_are_whole_numbers() -> None:
    line = line_of(UNEQUAL)
    np.testing.assert_allclose(line.spans(line.supports), np.arange(11.0), atol=1e-12)  # rounding
    np.testing.assert_allclose(
        line.intervals(line.droppers), np.arange(float(line.droppers.size)), atol=1e-12
    )


def test_between_and_beyond_the_supports_a_span_has_its_own_length() -> None:
    line = LineCoordinate(np.array([0.0, 40.0, 100.0]), np.empty(0))
    np.testing.assert_allclose(
        line.spans(np.array([-20.0, 10.0, 70.0, 130.0])), [-0.5, 0.25, 1.5, 2.5]
    )


def test_intervals_in_a_span_are_those_of_the_stretch() -> None:
    assert np.isclose(line_of(EQUAL).intervals_per_span(120.0, 480.0), 10.0)
    assert line_of(EQUAL, None).intervals_per_span(0.0, 600.0) is None
    # One dropper in a span repeats as the span does.
    assert line_of(EQUAL, 60.0).intervals_per_span(0.0, 600.0) is None


def test_spans_hang_alike_by_the_parts_of_the_span() -> None:
    assert line_of(EQUAL).hangs_alike(0.0, 600.0)
    assert not line_of(UNEQUAL).hangs_alike(0.0, 570.0)
    stretched = LineCoordinate(np.array([0.0, 40.0, 100.0]), np.array([10.0, 30.0, 55.0, 85.0]))
    assert stretched.hangs_alike(0.0, 100.0)
    moved = LineCoordinate(np.array([0.0, 40.0, 100.0]), np.array([10.0, 30.0, 55.0, 88.0]))
    assert not moved.hangs_alike(0.0, 100.0)
    assert moved.hangs_alike(0.0, 40.0)


def test_a_line_of_a_scenario_has_its_supports_and_droppers() -> None:
    line = LineCoordinate.of(load(scenario_data()).line)
    np.testing.assert_array_equal(line.supports, 50.0 * np.arange(13))
    np.testing.assert_array_equal(line.droppers[:3], [5.0, 45.0, 55.0])
