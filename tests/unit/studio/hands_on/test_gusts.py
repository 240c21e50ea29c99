"""Gusts: their course against its integrals in closed form, and the law of lift."""

import numpy as np
import pytest

import arcless
from arcless import ModelError
from arcless.model import Pantograph, Scenario
from arcless.studio.hands_on.gusts import STATED_LIFT, Gust, has_lift

WIND, DURATION, SPEED = 10.0, 1.5, 70.0
# N/(m/s)²
LAW = 0.0125
# Of the sum over 10⁴ intervals: a smooth course that begins and ends level is summed to rounding.
ROUNDING = 1e-9


def pantograph(aerodynamic: float) -> Pantograph:
    scenario: Scenario = arcless.load("en50318-ac-simple-275-planar")
    return scenario.with_(
        **{"pantographs.0.model.masses.0.aerodynamic": aerodynamic}
    ).pantographs[0].model  # fmt: skip


def impulse(gust: Gust, model: Pantograph) -> float:
    times, step = np.linspace(0.0, DURATION, 10_000, endpoint=False, retstep=True)
    return float(sum(gust.lift(model, SPEED, time) for time in times) * step)


def test_the_lift_is_that_of_the_law_of_the_pantograph() -> None:
    model = pantograph(LAW)
    gust = Gust(WIND, DURATION)
    peak = LAW * ((SPEED + WIND) ** 2 - SPEED**2)
    assert gust.lift(model, SPEED, 0.5 * DURATION) == pytest.approx(peak, rel=ROUNDING)
    # ∫ k((v + w s)² − v²) dt with s = (1 − cos)/2, whose mean is 1/2 and that of its square 3/8.
    exact = LAW * DURATION * (2.0 * SPEED * WIND / 2.0 + WIND**2 * 3.0 / 8.0)
    assert impulse(gust, model) == pytest.approx(exact, rel=ROUNDING)


def test_without_a_law_the_peak_is_a_stated_force() -> None:
    model = pantograph(0.0)
    assert not has_lift(model)
    gust = Gust(WIND, DURATION)
    assert gust.lift(model, SPEED, 0.5 * DURATION) == pytest.approx(STATED_LIFT, rel=ROUNDING)
    assert impulse(gust, model) == pytest.approx(0.5 * STATED_LIFT * DURATION, rel=ROUNDING)


def test_before_and_after_it_a_gust_adds_nothing() -> None:
    gust, model = Gust(WIND, DURATION), pantograph(LAW)
    for time in (-1.0, 0.0, DURATION, DURATION + 1e-9, 100.0):
        assert gust.lift(model, SPEED, time) == pytest.approx(0.0, abs=ROUNDING)


@pytest.mark.parametrize("given", [(-1.0, 1.0), (61.0, 1.0), (10.0, 0.0), ("10", 1.0),
                                   (float("nan"), 1.0), (True, 1.0), (None, 1.0)])  # fmt: skip
def test_what_is_no_gust_is_refused(given: tuple[object, object]) -> None:
    with pytest.raises(ModelError, match="expected a number from"):
        Gust.of(*given)
