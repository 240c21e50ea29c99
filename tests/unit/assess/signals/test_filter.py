"""The low-pass: its gain is known in closed form, its phase is none, its ends are made up."""

import math

import numpy as np
import pytest

from arcless.assess.signals.filter import low_pass, sample_rate_Hz, spectrum
from arcless.errors import ModelError, ResultFormatError

RATE = 1000.0
TIME = np.arange(20_000) / RATE
MIDDLE = slice(5_000, 15_000)  # whole periods of every frequency below, far from the ends


def gain(frequency: float, cutoff: float, rate: float = RATE) -> float:
    """Order 6, two passes, bilinear transform: derived on paper, not taken from the code."""
    ratio = math.tan(math.pi * frequency / rate) / math.tan(math.pi * cutoff / rate)
    return 1.0 / (1.0 + ratio**12)


@pytest.mark.parametrize("frequency", [0.5, 1.0, 5.0, 12.0, 18.0, 19.0, 20.0, 21.0, 25.0, 40.0])
def test_gain_of_a_sine_is_the_closed_form(frequency: float) -> None:
    sine = np.sin(2.0 * np.pi * frequency * TIME)
    filtered = low_pass(sine, RATE, 20.0)[MIDDLE]
    # 1e-9: rounding of the recursion; what the ends do has decayed long before the middle.
    assert np.std(filtered) == pytest.approx(gain(frequency, 20.0) / math.sqrt(2.0), abs=1e-9)


def test_a_sine_at_the_cut_off_is_halved() -> None:
    assert gain(20.0, 20.0) == 0.5


@pytest.mark.parametrize("frequency", [2.0, 12.0, 20.0, 24.0])
def test_there_is_no_phase_shift(frequency: float) -> None:
    sine = np.sin(2.0 * np.pi * frequency * TIME)
    filtered = low_pass(sine, RATE, 20.0)
    difference = filtered - gain(frequency, 20.0) * sine
    assert np.max(np.abs(difference[MIDDLE])) < 1e-9


def test_a_constant_and_a_trend_pass_unchanged() -> None:
    trend = 100.0 + 3.0 * TIME
    filtered = low_pass(trend, RATE, 20.0)
    # 1e-8 of 160 N: a recursion of sixth order with its poles near 1 loses half of 16 digits.
    assert filtered[MIDDLE] == pytest.approx(trend[MIDDLE], abs=1e-6)
    # The record is extended by three periods of the cut-off, after which 1e-6 of a start is left.
    assert filtered == pytest.approx(trend, abs=1e-3)


def test_the_ends_of_a_record_are_made_up_and_the_middle_is_not() -> None:
    wave = np.cos(2.0 * np.pi * 22.0 * TIME)
    error = np.abs(low_pass(wave, RATE, 20.0) - gain(22.0, 20.0) * wave)
    # Mirrored about its first value the record starts at that value, whatever the filter does.
    assert error[0] == pytest.approx(1.0 - gain(22.0, 20.0), abs=1e-3)
    assert np.max(error[MIDDLE]) < 1e-9


def test_columns_are_filtered_independently() -> None:
    two = np.stack([np.sin(TIME), np.cos(3.0 * TIME)], axis=1)
    both = low_pass(two, RATE, 20.0)
    for column in range(2):
        assert np.array_equal(both[:, column], low_pass(two[:, column], RATE, 20.0))


@pytest.mark.parametrize("cutoff", [0.0, -1.0, 500.0, 600.0, math.nan])
def test_a_cut_off_that_cannot_be_is_refused(cutoff: float) -> None:
    with pytest.raises(ModelError, match="half the recording rate of 1000 Hz"):
        low_pass(TIME, RATE, cutoff)


def test_a_record_of_three_samples_is_filtered() -> None:
    assert np.isfinite(low_pass(np.array([1.0, 2.0, 4.0]), RATE, 20.0)).all()


def test_the_rate_is_that_of_the_record() -> None:
    # Round-off of a time axis of 1e4 steps.
    assert sample_rate_Hz(TIME) == pytest.approx(RATE, rel=1e-12)


def test_uneven_or_missing_times_are_refused() -> None:
    with pytest.raises(ResultFormatError, match="equally spaced"):
        sample_rate_Hz(np.array([0.0, 1.0, 2.0, 4.0]))
    with pytest.raises(ResultFormatError, match="too short"):
        sample_rate_Hz(np.array([0.0]))


def test_the_spectrum_holds_the_variance_at_its_frequency() -> None:
    values = 7.0 + 3.0 * np.sin(2.0 * np.pi * 11.0 * TIME)
    frequency, density = spectrum(values, RATE)
    assert frequency[np.argmax(density)] == pytest.approx(11.0, abs=0.25)  # one bin of 4 s
    # Parseval: 3²/2; the window spreads a line in the middle of a bin but keeps its power.
    assert np.trapezoid(density, frequency) == pytest.approx(4.5, rel=1e-9)


def test_the_spectrum_of_a_short_section_is_finite() -> None:
    _, density = spectrum(np.array([1.0, 2.0, 1.0, 2.0]), RATE)
    assert np.isfinite(density).all()
