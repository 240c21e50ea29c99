"""The PID law against closed forms of first-order loops."""

from math import exp

import numpy as np
import pytest

from arcless.model.pantograph.controller import Pid
from arcless.simulate.setup.pid import PidLaw


def free(force: float) -> float:
    return force


def loop(pid: Pid, step: float, lag: float, end: float, start: float = 0.0) -> np.ndarray:
    """Response of ẏ = (u − y)/lag, held inputs, to the controller: values at the samples."""
    law, y, found = PidLaw(pid, step), start, []
    keep = exp(-step / lag)
    for _ in range(round(end / step)):
        found.append(y)
        y = keep * y + (1.0 - keep) * law(y, free)
    return np.array(found)


def test_a_proportional_loop_is_a_faster_lag() -> None:
    """ẏ = (P (r − y) − y)/τ: y → r P/(1 + P) with τ/(1 + P)."""
    gain, lag = 4.0, 0.2
    errors = []
    for step in (2e-3, 1e-3, 5e-4):
        y = loop(Pid(target=100.0, proportional=gain), step, lag, 0.4)
        t = step * np.arange(len(y))
        exact = 100.0 * gain / (1 + gain) * (1 - np.exp(-(1 + gain) * t / lag))
        errors.append(np.max(np.abs(y - exact)))
    ratios = np.divide(errors[:-1], errors[1:])
    # Holding the input is of first order in the sample time.
    np.testing.assert_allclose(ratios, 2.0, atol=0.1)
    assert errors[-1] < 0.5


def test_an_integral_loop_on_a_static_plant_forgets_the_error_by_a_constant_factor() -> None:
    """Measured force = 60 + what was answered: each sample takes the share I T off the error."""
    pid, step = Pid(target=100.0, integral=5.0), 0.01
    law, force, errors = PidLaw(pid, step), 0.0, []
    for _ in range(50):
        errors.append(100.0 - (60.0 + force))
        force = law(60.0 + force, free)
    # Rounding of 100 N.
    np.testing.assert_allclose(errors, 40.0 * (1.0 - 5.0 * step) ** np.arange(50), atol=1e-11)


def test_pi_that_cancels_the_lag_leaves_a_first_order_loop() -> None:
    """I = P/τ cancels the pole of the plant: y = r (1 − e^(−P t/τ))."""
    gain, lag = 3.0, 0.1
    pid = Pid(target=50.0, proportional=gain, integral=gain / lag)
    errors = []
    for step in (1e-3, 5e-4, 2.5e-4):
        y = loop(pid, step, lag, 0.3)
        t = step * np.arange(len(y))
        errors.append(np.max(np.abs(y - 50.0 * (1 - np.exp(-gain * t / lag)))))
    # First order: halves with the step, but for the next order, 1 % at 1 ms over a lag of 0.1 s.
    np.testing.assert_allclose(np.divide(errors[:-1], errors[1:]), 2.0, atol=0.1)


def test_derivative_and_filter() -> None:
    law = PidLaw(Pid(target=0.0, derivative=0.5), 0.1)
    assert [law(y, free) for y in (1.0, 2.0, 4.0)] == pytest.approx([0.0, -5.0, -10.0])
    law = PidLaw(Pid(target=0.0, proportional=1.0, filter=0.2), 0.1)
    # A step of the measurement after the first sample: 1 − e^(−t/0.2).
    found = [law(y, free) for y in (0.0, 1.0, 1.0, 1.0)]
    assert found == pytest.approx([-(1 - exp(-n * 0.5)) for n in range(4)])


def test_the_integral_waits_at_a_limit() -> None:
    law = PidLaw(Pid(target=100.0, integral=10.0), 0.1)

    def limit(force: float) -> float:
        return min(force, 150.0)

    for _ in range(20):
        found = law(0.0, limit)
    assert found == pytest.approx(100.0)
    # It comes down at once when the error turns: nothing was wound up.
    assert law(110.0, limit) == pytest.approx(90.0)
