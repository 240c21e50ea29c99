"""Spectral lines of a remainder: Parseval, bands of modes, what chance gives."""

import numpy as np
import pytest

from arcless.explanation.signals.remainder import Lines, band, chance, mode_at
from arcless.pantograph.natural_modes import Band, PantographMode


@pytest.mark.parametrize("count", [1000, 1001])
def test_lines_add_up_to_the_variance(count: int) -> None:
    values = np.random.default_rng(3).normal(size=count)
    lines = Lines.of(values, 100.0)
    # Parseval, to rounding.
    assert lines.variance.sum() == pytest.approx(np.mean(values**2), rel=1e-12)
    assert lines.frequency[-1] <= 50.0


def test_a_sine_is_one_line() -> None:
    time = np.arange(1000) / 100.0
    lines = Lines.of(3.0 * np.sin(2.0 * np.pi * 7.0 * time), 100.0)
    assert lines.frequency[lines.variance.argmax()] == pytest.approx(7.0)
    assert lines.variance.max() == pytest.approx(4.5, rel=1e-12)  # rounding


def test_a_line_belongs_to_the_nearer_of_two_bands() -> None:
    bands = [Band(1.0, 2.0, 4.0), Band(3.0, 5.0, 6.0)]
    at = np.array([0.5, 1.0, 3.4, 3.6, 6.0, 6.1])
    assert mode_at(at, bands).tolist() == [-1, 0, 0, 1, 1, -1]


def test_a_band_is_wider_by_the_half_power_width() -> None:
    found = band(PantographMode(Band(2.0, 3.0, 4.0), 0.25, 1.0))
    assert (found.low, found.middle, found.high) == (1.5, 3.0, 5.0)
    assert band(PantographMode(Band(2.0, 3.0, 4.0), 1.5, 1.0)).low == 0.0


def test_chance_is_the_variance_of_a_free_line() -> None:
    # Ten lines in the width of an order, one of them taken: nine free ones share the variance.
    lines = Lines(np.arange(0.0, 10.0, 0.1), np.full(100, 0.9))
    found = chance(lines, np.array([2.05, 3.05]), np.array([2, 2]), 1.0)
    np.testing.assert_allclose(found, 0.9 * 10 / 9)


def test_chance_is_not_known_where_no_line_is_free() -> None:
    lines = Lines(np.arange(0.0, 10.0, 0.5), np.full(20, 0.9))
    assert np.isnan(chance(lines, np.array([2.05]), np.array([4]), 1.0)).all()
