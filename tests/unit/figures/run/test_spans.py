"""The force by span: folded over the span, and its deviation in each."""

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.description import Area, Bars, Curve, Figure, Rules
from arcless.figures.run import spans
from arcless.figures.run.run_data import RunData
from tests.support.synthetic import SPAN_M, synthetic_dataset

SPEED, SECTION = 20.0, (200.0, 400.0)
# One wave in each span, 0.4 Hz: the low-pass leaves it.
WAVE = 2.0 * np.pi * SPEED / SPAN_M


def run_of(**more) -> RunData:
    dataset = synthetic_dataset(section=SECTION, **more)
    return RunData(dataset, assess(dataset))


def one(figure: Figure, kind: type, name: str):
    (found,) = [each for each in figure.layers if isinstance(each, kind) and each.name == name]
    return found


def test_a_wave_of_the_span_folds_onto_itself() -> None:
    run = run_of(force=lambda t: 100.0 + 30.0 * np.sin(WAVE * t))
    (figure,) = spans.folded(run)
    mean, area = one(figure, Curve, "mean of the spans"), figure.layers[-2]
    assert (figure.x.low, figure.x.high, figure.x.unit) == (0.0, SPAN_M, "m")
    expected = 100.0 + 30.0 * np.sin(2.0 * np.pi * mean.x / SPAN_M)
    # Spans are compared at places between samples 0.02 m apart: (2π·0.02/50)²/8 of the wave.
    np.testing.assert_allclose(mean.y, expected, atol=30.0 * 1e-5)
    assert isinstance(area, Area)
    np.testing.assert_allclose(area.high - area.low, 0.0, atol=2 * 30.0 * 1e-5)
    assert "from 70 to 130 N" in figure.alt


def test_spans_that_differ_have_a_deviation() -> None:
    # Every other span 10 N higher: deviation 5 N at each place but near supports.
    run = run_of(force=lambda t: 100.0 + 5.0 * np.sign(np.sin(WAVE / 2.0 * t)))
    (figure,) = spans.folded(run)
    middle = spans.PLACES // 2
    assert one(figure, Curve, "mean of the spans").y[middle] == pytest.approx(100.0, abs=0.01)
    area = figure.layers[-2]
    # The low-pass rings at the steps 25 m away; there it has died down to a thousandth.
    assert (area.high - area.low)[middle] == pytest.approx(2 * 5.0, rel=1e-3)


def test_the_deviation_of_each_span_is_that_of_its_wave() -> None:
    amplitude = np.array([10.0, 20.0, 30.0, 20.0])  # of spans 5 to 8

    def force(t):
        number = np.clip((SPEED * t // SPAN_M).astype(int) - 4, 0, 3)
        return 100.0 + amplitude[number] * np.sin(WAVE * t)

    run = run_of(force=force)
    (figure,) = spans.by_span(run)
    bars = one(figure, Bars, "σ in the span")
    assert [*(bars.left + 0.4)] == [5.0, 6.0, 7.0, 8.0]
    # The kinks at the supports are rounded by the low-pass: some parts in a thousand.
    np.testing.assert_allclose(bars.high, amplitude / np.sqrt(2.0), rtol=5e-3)
    (limit,) = [layer for layer in figure.layers if layer.name.startswith("limit of σ")]
    assert isinstance(limit, Rules)
    assert limit.at[0] == pytest.approx(0.3 * run.assessment.pantographs[0].mean_force_N)
    assert "largest in span 7" in figure.alt


def test_droppers_are_marked_where_all_spans_have_the_same() -> None:
    run = run_of()
    (figure,) = spans.folded(run)
    np.testing.assert_allclose(one(figure, Rules, "dropper").at, [5.0, 15.0, 25.0, 35.0, 45.0])
    dataset = synthetic_dataset(section=SECTION)
    dataset["dropper_x"].values[dataset["dropper_span"].values == 6] += 1.0
    (other,) = spans.folded(RunData(dataset, assess(dataset)))
    assert not [layer for layer in other.layers if layer.name == "dropper"]


def test_spans_of_different_lengths_are_compared_by_their_parts() -> None:
    dataset = synthetic_dataset(section=(200.0, 400.0))
    x = dataset["support_x"].values
    x[x == 300.0] = 290.0
    (figure,) = spans.folded(RunData(dataset, assess(dataset)))
    assert (figure.x.high, figure.x.unit) == (100.0, "% of the span")


def test_a_section_without_two_whole_spans_has_no_such_figure() -> None:
    dataset = synthetic_dataset(section=(210.0, 290.0))
    run = RunData(dataset, assess(dataset))
    assert spans.folded(run) == []
    assert spans.by_span(run) == []
