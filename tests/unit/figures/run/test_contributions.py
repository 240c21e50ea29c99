"""Figures of an explanation: bars that add up, and what does not repeat along the track."""

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.description import Bars, Curve, Figure, Points, Rules
from arcless.figures.run import contributions
from arcless.figures.run.run_data import RunData
from tests.support.synthetic import SPAN_M, scenario_data, synthetic_dataset

SPEED = 20.0
WAVE = 2.0 * np.pi * SPEED / SPAN_M
# As many droppers as the synthetic line draws, 10 m apart.
SCENARIO = scenario_data(
    line__span_types={
        "all": {"length": SPAN_M, "droppers": {"positions": [5.0, 15.0, 25.0, 35.0, 45.0]}}
    }
)


def force(t: np.ndarray) -> np.ndarray:
    kick = 60.0 * np.exp(-(((SPEED * t - 275.0) / 2.0) ** 2))
    return 100.0 + 30.0 * np.sin(WAVE * t) + 10.0 * np.sin(5.0 * WAVE * t) + kick


def run_of(**more) -> RunData:
    given = {"force": force, "section": (100.0, 500.0), "scenario": SCENARIO, **more}
    dataset = synthetic_dataset(**given)
    return RunData(dataset, assess(dataset))


def of_kind(figure: Figure, kind: type) -> list:
    return [each for each in figure.layers if isinstance(each, kind)]


def test_bars_add_up_to_the_variance_and_stand_at_their_orders() -> None:
    (figure,) = contributions.contributions(run_of())
    bars = of_kind(figure, Bars)
    heights = [bar.high - bar.low for bar in bars]
    # 100 % but for the rounding of sums.
    assert sum(float(height.sum()) for height in heights) == pytest.approx(100.0, rel=1e-9)
    span, dropper = bars[0], bars[1]
    assert span.name.startswith("span passing")
    assert dropper.name.startswith("dropper passing")
    middle = 0.5 * (span.left + span.right)
    assert middle[int(np.argmax(heights[0]))] == 1.0
    assert middle[int(np.argmax(heights[1]))] == 5.0


def test_droppers_and_natural_frequencies_are_marked() -> None:
    run = run_of()
    (figure,) = contributions.contributions(run)
    dropper, mode = of_kind(figure, Rules)
    np.testing.assert_allclose(dropper.at[:2], [5.0, 10.0])
    assert dropper.name.startswith("dropper passing, 10.00 m")
    (own,) = [one.frequency_Hz for one in run.explanation.pantographs[0].modes]
    np.testing.assert_allclose(mode.at, own * SPAN_M / SPEED)
    assert f"{own:.2f}\u00a0Hz" in figure.caption


def test_a_kick_stands_out_where_it_is() -> None:
    (figure,) = contributions.irregular(run_of())
    (points,) = of_kind(figure, Points)
    assert points.x[0] == pytest.approx(275.0, abs=0.1)
    (curve,) = of_kind(figure, Curve)
    # A kick of 60 N in one of eight spans: an eighth of it repeats, by the mean.
    assert curve.y.max() == pytest.approx(60.0 * 7 / 8, rel=0.05)
    assert "275" in figure.alt


def test_two_pantographs_have_a_figure_each_on_one_scale() -> None:
    first = SCENARIO["pantographs"][0]
    both = [{**first, "name": "front"}, {**first, "name": "rear", "distance": 100.0}]
    run = run_of(pantographs=("front", "rear"), scenario={**SCENARIO, "pantographs": both})
    front, rear = contributions.contributions(run)
    assert (front.y.high, front.x.high) == (rear.y.high, rear.x.high)
    assert "rear" in rear.title


def test_without_an_explanation_there_is_no_figure() -> None:
    short = run_of(section=(100.0, 180.0))
    assert contributions.contributions(short) == []
    assert contributions.irregular(short) == []
    assert contributions.contributions(run_of(force=lambda t: np.full_like(t, 100.0))) == []
