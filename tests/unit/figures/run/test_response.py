"""The line under the train: uplift at supports and forces of droppers, which pass as bells."""

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.description import Curve, Map, Points, Rules
from arcless.figures.run import response
from arcless.figures.run.run_data import RunData
from tests.support.synthetic import DROPPERS_PER_SPAN, scenario_data, synthetic_dataset


def run_of(**more) -> RunData:
    dataset = synthetic_dataset(**more)
    return RunData(dataset, assess(dataset))


def test_uplift_is_drawn_at_each_support_with_its_limit() -> None:
    (figure,) = response.uplift(run_of())
    (dots,) = [layer for layer in figure.layers if layer.name == "maximum uplift"]
    assert isinstance(dots, Points)
    np.testing.assert_allclose(dots.x, 50.0 * np.arange(13))
    np.testing.assert_allclose(dots.y, 40.0)
    (limit,) = [layer for layer in figure.layers if "space for uplift" in layer.name]
    assert isinstance(limit, Rules)
    assert limit.at == [50.0]  # of 100 mm that the drawing provides, for twice the uplift
    assert "at most 40.0 mm" in figure.alt


def test_no_limit_where_the_drawing_gives_no_space() -> None:
    data = scenario_data(line__design={"uplift_space": None})
    (figure,) = response.uplift(run_of(scenario=data))
    assert not [layer for layer in figure.layers if "space for uplift" in layer.name]


def test_passages_lie_over_each_other() -> None:
    (figure,) = response.uplift_passages(run_of())
    others, largest = (layer for layer in figure.layers if isinstance(layer, Curve))
    # The bell of the record: 40 mm, 5 m wide. Single samples 0.1 m apart, thinned to peaks.
    np.testing.assert_allclose(largest.y, 40.0 * np.exp(-((largest.x / 5.0) ** 2)), atol=1e-9)
    assert largest.y.max() == pytest.approx(40.0, rel=1e-3)
    assert np.isnan(others.y).sum() == 4  # supports at 200 to 400 m, the largest drawn by itself


def test_droppers_that_go_slack_are_marked() -> None:
    run = run_of()
    dataset = run.dataset
    dataset["dropper_force_min"].values[:] = 5.0
    dataset["dropper_force_min"].values[7] = 0.0
    (figure,) = response.dropper_range(RunData(dataset, run.assessment))
    (slack,) = [layer for layer in figure.layers if layer.name == "slack at some time"]
    assert [*slack.x] == [dataset["dropper_x"].values[7]]
    assert "1 of 60 droppers" in figure.alt


def test_the_map_has_a_row_for_each_dropper_of_the_section() -> None:
    (figure,) = response.dropper_map(run_of())
    (grid,) = [layer for layer in figure.layers if isinstance(layer, Map)]
    assert grid.values.shape[0] == 4 * DROPPERS_PER_SPAN
    x = np.linspace(*grid.x, grid.values.shape[1], endpoint=False)
    x = x + 0.5 * (x[1] - x[0])
    expected = np.maximum(50.0 * (1.0 - 1.2 * np.exp(-((x / 5.0) ** 2))), 0.0)
    # Straight pieces between samples 0.1 m apart: h²/8 times the curvature, 0.005 N, and the kinks.
    for row in grid.values:
        np.testing.assert_allclose(row, expected, atol=0.3)
    assert figure.scale is not None
    # What is slack lies below the scale, and has the colour of slack droppers.
    assert (figure.scale.under, figure.scale.low > 0.0) == ("slack", True)
    assert np.nanmin(grid.values) < figure.scale.low
    assert [name for name in figure.y.categories if name] == [f"span {n}" for n in (5, 6, 7, 8)]
    assert f"{4 * DROPPERS_PER_SPAN} of them go slack" in figure.alt


def test_a_long_section_keeps_whole_spans_around_its_middle() -> None:
    run = run_of(duration_s=120.0, section=(200.0, 2200.0))
    (figure,) = response.dropper_map(run)
    (grid,) = [layer for layer in figure.layers if isinstance(layer, Map)]
    rows = grid.values.shape[0]
    assert rows <= response.ROWS < rows + DROPPERS_PER_SPAN
    assert rows % DROPPERS_PER_SPAN == 0
    assert "span 24" in figure.y.categories  # at 1150 to 1200 m, the middle


def test_each_pantograph_of_a_train_is_marked() -> None:
    (figure,) = response.dropper_map(run_of(pantographs=("a", "b"), distance_m=80.0))
    (marks,) = [layer for layer in figure.layers if isinstance(layer, Rules)]
    np.testing.assert_allclose(marks.at, [0.0, 80.0])
    assert figure.x.high == pytest.approx(response.AFTER_M + 80.0)


def test_a_record_without_places_has_no_such_figures() -> None:
    bare = ("support_x", "support_uplift", "support_uplift_max", "dropper_x", "dropper_force",
            "dropper_span", "dropper_force_min", "dropper_force_max")  # fmt: skip
    run = run_of(without=bare)
    for make in (response.uplift, response.dropper_range, response.dropper_map):
        assert make(run) == []
