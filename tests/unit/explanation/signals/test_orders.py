"""Orders of forces whose shares are known: they add up, and each has its own."""

import numpy as np
import pytest

from arcless.explanation.signals.orders import Fit, fit, orders
from tests.support.passages import EQUAL, LOW_PASS, SPEED, UNEQUAL, line_of, passage_over


def fitted(line, force, most: float = 30.0, **more) -> tuple[Fit, np.ndarray]:
    passage = passage_over(line, force, **more)
    deviation = passage.force - passage.force.mean()
    taken = orders(line, *passage.ends, most)
    found = fit(deviation, line.spans(passage.position), line.intervals(passage.position), taken)
    return found, deviation


def waves(phase: np.ndarray, amplitude: float, lag: float = 0.4) -> np.ndarray:
    return amplitude * np.cos(2.0 * np.pi * phase - lag)


@pytest.mark.parametrize("spans", [EQUAL, UNEQUAL])
@pytest.mark.parametrize("ends", [None, (31.0, 497.0)])
def test_variances_add_up_to_the_variance(spans, ends) -> None:
    noise = np.random.default_rng(1).normal(size=100_000)

    def force(t, x, xi, psi):
        return waves(xi, 20.0) + waves(3 * xi, 5.0) + waves(psi, 10.0) + 4.0 * noise[: t.size]

    found, deviation = fitted(line_of(spans), force, ends=ends)
    total = found.variances.sum() + np.mean(found.remainder**2)
    # Pythagoras to rounding: 240 columns of 5000 numbers, 1e-16 each.
    assert total == pytest.approx(np.mean(deviation**2), rel=1e-11)


def test_over_whole_equal_spans_it_is_a_fourier_series() -> None:
    line = line_of(EQUAL)
    values = np.random.default_rng(2).normal(size=100_000)

    def force(t, x, xi, psi):
        # A pattern of the span: the same numbers in each, 480 samples of 60 m.
        return values[np.arange(t.size) % 480]

    found, deviation = fitted(line, force)
    series = np.abs(np.fft.rfft(deviation[:480]) / 480) ** 2 * 2.0
    assert [one.of_span for one in found.orders] == list(range(1, 31))
    np.testing.assert_allclose(found.variances, series[1:31], rtol=1e-9)  # rounding


@pytest.mark.parametrize("spans", [EQUAL, UNEQUAL])
def test_each_order_has_its_own_variance(spans) -> None:
    def force(t, x, xi, psi):
        return waves(xi, 20.0) + waves(2 * xi, 10.0) + waves(psi, 8.0)

    found, _ = fitted(line_of(spans), force)
    by_source = {
        source: found.variances[[one.source == source for one in found.orders]].sum()
        for source in ("span", "droppers")
    }
    # Unequal spans: the dropper wave has 0.03 of its amplitude in the orders of the span; 2·0.03·8
    # on the largest amplitude of 20 N.
    assert found.variances[0] == pytest.approx(20.0**2 / 2, abs=0.5 * 20.0)
    assert by_source["span"] == pytest.approx((20.0**2 + 10.0**2) / 2, rel=0.04)
    assert by_source["droppers"] == pytest.approx(8.0**2 / 2, rel=0.04)
    assert np.mean(found.remainder**2) < 1e-3


def test_droppers_of_unequal_spans_need_their_own_phase() -> None:
    """Without the phase ψ the same wave would pass for rest: this is what it is for."""
    line = line_of(UNEQUAL)
    passage = passage_over(line, lambda t, x, xi, psi: waves(psi, 8.0))
    deviation = passage.force - passage.force.mean()
    spans, intervals = line.spans(passage.position), line.intervals(passage.position)
    taken = orders(line, *passage.ends, 30.0)
    assert np.mean(fit(deviation, spans, intervals, taken).remainder ** 2) < 1e-9
    without = tuple(one for one in taken if not one.carrier)
    assert np.mean(fit(deviation, spans, intervals, without).remainder ** 2) > 5.0


def test_a_speed_that_changes_leaves_the_orders_where_they_are() -> None:
    line = line_of(EQUAL)
    found, _ = fitted(
        line, lambda t, x, xi, psi: waves(2 * xi, 10.0), speed=lambda t: SPEED * t - 1.2 * t**2
    )
    # Of the mean over time, slow spans count more: 2 % of the wave's mean stays.
    assert found.variances[1] == pytest.approx(50.0, rel=0.02)
    assert np.mean(found.remainder**2) < 1e-9


def test_an_order_belongs_to_what_it_is_nearest_to() -> None:
    taken = orders(line_of(EQUAL), 0.0, 600.0, 25.0)  # 10 intervals in a span
    assert {one.of_span for one in taken if one.source == "span"} == {1, 2, 3, 4, 5}
    assert {one.of_span for one in taken if one.source == "droppers"} == set(range(6, 26))
    assert {one.source for one in orders(line_of(EQUAL, None), 0.0, 600.0, 25.0)} == {"span"}


def test_the_low_pass_bounds_the_orders() -> None:
    most = 1.25 * LOW_PASS * 60.0 / SPEED
    assert max(one.of_span for one in orders(line_of(EQUAL), 0.0, 600.0, most)) == 30
