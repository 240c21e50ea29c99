"""Histogram, spectrum and spectrogram of forces whose content is known."""

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.description import Bars, Curve, Map, Rules
from arcless.figures.run import distribution
from arcless.figures.run.run_data import RunData
from tests.support.synthetic import SPAN_M, synthetic_dataset

SPEED, SECTION = 20.0, (100.0, 500.0)
AMPLITUDE, FREQUENCY = 20.0, 8.0


def run_of(**more) -> RunData:
    dataset = synthetic_dataset(section=SECTION, **more)
    return RunData(dataset, assess(dataset))


def wave(t):
    return 100.0 + AMPLITUDE * np.sin(2.0 * np.pi * FREQUENCY * t)


def test_shares_of_time_add_up() -> None:
    (figure,) = distribution.histogram(run_of(force=wave))
    (bars,) = [layer for layer in figure.layers if isinstance(layer, Bars)]
    assert bars.high.sum() == pytest.approx(100.0, rel=1e-12)  # rounding
    # A sine stays longest at its ends: density 1/(π √(A² - x²)), so the outer bins are largest.
    assert {int(bars.high.argmax()), int(bars.high[::-1].argmax())} & {0}


def test_histograms_of_pantographs_have_the_same_axes() -> None:
    one, other = distribution.histogram(run_of(pantographs=("a", "b"), force=wave))
    assert (one.x, one.y) == (other.x, other.y)


def test_the_spectrum_has_the_power_of_the_wave() -> None:
    (figure,) = distribution.force_spectrum(run_of(force=wave))
    (curve,) = [layer for layer in figure.layers if isinstance(layer, Curve)]
    assert curve.x[curve.y.argmax()] == pytest.approx(FREQUENCY, abs=0.126)  # half a line of 4 s
    power = np.sum(curve.y) * (curve.x[1] - curve.x[0])
    # Parseval: the variance of a sine; a Hann window leaves less than 1e-3 beyond 50 Hz.
    assert power == pytest.approx(AMPLITUDE**2 / 2.0, rel=2e-3)
    wavelengths = next(tip.values for tip in curve.tips if tip.label == "wavelength")
    np.testing.assert_allclose(wavelengths * curve.x, SPEED)
    assert f"largest at {curve.x[curve.y.argmax()]:.2f} Hz" in figure.alt


def test_passing_frequencies_are_marked() -> None:
    (figure,) = distribution.force_spectrum(run_of(force=wave))
    rules = {layer.name: layer for layer in figure.layers if isinstance(layer, Rules)}
    span = rules["span passing, 0.40 Hz and multiples"]
    np.testing.assert_allclose(span.at, SPEED / SPAN_M * np.array([1.0, 2.0, 3.0]))
    np.testing.assert_allclose(rules["dropper passing, 2.00 Hz"].at, [2.0])
    np.testing.assert_allclose(rules["bands: 5 and 20 Hz"].at, [5.0, 20.0])


def test_the_spectrogram_shows_when_a_frequency_changes() -> None:
    # 6 Hz up to 300 m, 12 Hz after it; without a jump of the phase.
    def force(t):
        later = np.maximum(t - 300.0 / SPEED, 0.0)
        return 100.0 + AMPLITUDE * np.sin(2.0 * np.pi * (6.0 * t + 6.0 * later))

    (figure,) = distribution.spectrogram(run_of(force=force))
    (grid,) = [layer for layer in figure.layers if isinstance(layer, Map)]
    step = (grid.y[1] - grid.y[0]) / grid.values.shape[0]
    frequency = grid.y[0] + step * (np.arange(grid.values.shape[0]) + 0.5)
    largest = frequency[grid.values.argmax(axis=0)]
    x = np.linspace(*grid.x, grid.values.shape[1])
    # A window of 1 s is 20 m long and has lines 1 Hz apart.
    np.testing.assert_allclose(largest[x < 300.0 - 12.0], 6.0, atol=0.51)
    np.testing.assert_allclose(largest[x > 300.0 + 12.0], 12.0, atol=0.51)


def test_the_spectrogram_has_the_density_of_a_sine() -> None:
    (figure,) = distribution.spectrogram(run_of(force=wave))
    (grid,) = [layer for layer in figure.layers if isinstance(layer, Map)]
    # A sine on a line: density A²/2 · (Σw)²·2/(... ) = A²/2 / (1.5 Hz), the noise width of Hann.
    expected = 10.0 * np.log10(AMPLITUDE**2 / 2.0 / 1.5)
    np.testing.assert_allclose(grid.values.max(axis=0), expected, atol=0.05)  # leakage of the mean


def test_a_short_run_has_no_spectrogram() -> None:
    assert distribution.spectrogram(run_of(duration_s=30.0)) != []
    dataset = synthetic_dataset(duration_s=1.9, section=(5.0, 35.0))
    assert distribution.spectrogram(RunData(dataset, assess(dataset))) == []
