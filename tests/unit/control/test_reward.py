"""The reward by closed forms, and its filter compared with SciPy's."""

from typing import Any

import numpy as np
import pytest
from scipy import signal

from arcless.assess.signals.running import RunningLowPass
from arcless.control.reward import Meter, Scores, Weights, reward
from arcless.errors import ModelError

RATE, CUTOFF = 1000.0, 20.0
ONE, TWO = np.array([0]), np.array([0, 1])


def test_the_filter_is_that_of_scipy_however_it_is_cut() -> None:
    random = np.random.default_rng(1)
    values = 100.0 + 30.0 * random.normal(size=(2, 400))
    sections = signal.butter(6, CUTOFF, fs=RATE, output="sos")
    begin = signal.sosfilt_zi(sections)
    found = RunningLowPass(CUTOFF, RATE, 2)
    found.begin(TWO, values[:, 0])
    pieces = [found.filtered(TWO, piece) for piece in np.split(values, [7, 8, 200], axis=1)]
    for row, own in enumerate(np.concatenate(pieces, axis=1)):
        expected, _ = signal.sosfilt(sections, values[row], zi=begin * values[row, 0])
        # Rounding of coefficients that two programs find by other operations.
        np.testing.assert_allclose(own, expected, rtol=1e-9)


def test_signals_are_filtered_each_by_itself() -> None:
    found = RunningLowPass(CUTOFF, RATE, 2)
    found.begin(TWO, np.array([1.0, 5.0]))
    np.testing.assert_allclose(found.filtered(ONE, np.ones((1, 50))), 1.0, rtol=1e-12)
    np.testing.assert_allclose(found.filtered(np.array([1]), np.full((1, 9), 5.0)), 5.0, rtol=1e-12)


def test_a_filter_that_does_not_fit_is_refused() -> None:
    with pytest.raises(ModelError, match="does not fit the rate"):
        RunningLowPass(500.0, RATE, 1)


def test_the_meter_of_a_sine() -> None:
    # A window of two whole periods of 5 Hz, in samples of 5 ms; 20 Hz take 0.5 (5/20)^12 off it.
    meter, steps, amplitude = Meter(CUTOFF, 1.0 / RATE, 80, 1), 5, 10.0
    meter.begin(ONE, np.array([100.0]))
    force = 100.0 + amplitude * np.sin(2.0 * np.pi * 5.0 * np.arange(1500) / RATE)
    for piece in force.reshape(-1, steps):
        scores = meter.read(ONE, piece[None], np.full((1, steps), -3.0))
    # The transient of the filter has fallen below 1e-6 within a second.
    assert scores.std_force_N[0] == pytest.approx(amplitude / np.sqrt(2.0), rel=1e-5)
    assert scores.mean_force_N[0] == pytest.approx(100.0, rel=1e-6)
    assert scores.effort_N[0] == 3.0
    assert scores.lost[0] == 0.0


def test_what_a_lead_in_takes_at_once_is_what_samples_take() -> None:
    random, steps = np.random.default_rng(2), 5
    force = 100.0 + 30.0 * random.normal(size=(2, 60 * steps))
    at_once, by_samples = (Meter(CUTOFF, 1.0 / RATE, window, 2) for window in (25, 25))
    for meter in (at_once, by_samples):
        meter.begin(TWO, force[:, 0])
    at_once.take(TWO, force[:, : 50 * steps], steps)
    for number in range(50):
        by_samples.read(TWO, force[:, number * steps : (number + 1) * steps], np.zeros((2, steps)))
    for number in range(50, 60):
        piece = force[:, number * steps : (number + 1) * steps]
        there, here = (m.read(TWO, piece, np.zeros((2, steps))) for m in (at_once, by_samples))
        np.testing.assert_array_equal(there.std_force_N, here.std_force_N)
        np.testing.assert_array_equal(there.mean_force_N, here.mean_force_N)


def test_a_window_longer_than_the_lead_in_holds_the_start() -> None:
    meter = Meter(CUTOFF, 1.0 / RATE, 10, 1)
    meter.begin(ONE, np.array([80.0]))
    meter.take(ONE, np.full((1, 15), 80.0), 5)
    scores = meter.read(ONE, np.full((1, 5), 80.0), np.zeros((1, 5)))
    assert scores.std_force_N[0] == pytest.approx(0.0, abs=1e-9)  # rounding of 80 N


def test_the_share_of_steps_without_contact() -> None:
    meter = Meter(CUTOFF, 1.0 / RATE, 10, 1)
    meter.begin(ONE, np.array([80.0]))
    force = np.array([[80.0, 0.0, 0.0, 5.0]])
    assert meter.read(ONE, force, np.zeros((1, 4))).lost[0] == 0.5


def test_the_reward_is_its_formula() -> None:
    scores = Scores(*(np.array([value]) for value in (20.0, 118.0, 0.25, 40.0)))
    weights = Weights(
        scatter_per_N_s=2.0, mean_per_N_s=3.0, loss_per_s=8.0, effort_per_N_s=0.5, failure=1.0
    )
    # −0.005 (2·20 + 3·|118 − 120| + 8·0.25 + 0.5·40)
    assert reward(weights, scores, 120.0, 0.005)[0] == pytest.approx(-0.005 * 68.0)


@pytest.mark.parametrize("value", [-1.0, float("nan"), float("inf"), "1", None])
def test_no_weights_are_refused(value: Any) -> None:
    with pytest.raises(ModelError, match=r"weights\.loss_per_s"):
        Weights.of({"loss_per_s": value})
