"""Sensitivities of σ: slopes of known laws, parameters of a scenario, and runs."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import Scenario, load
from arcless.model.fields import extremes
from arcless.simulate.central_differences import effect, parameters, sensitivities, variants
from tests.support.synthetic import scenario_data

FACTORS = (0.95, 0.975, 1.025, 1.05)


@pytest.mark.parametrize("power", [-1.3, 0.4, 2.0])
def test_the_slope_of_a_power_law_is_its_power(power: float) -> None:
    found = effect("P1", 30.0, [30.0 * one**power for one in FACTORS], FACTORS)
    # Over logarithms a power law is a straight line: rounding.
    assert found.percent_per_percent == pytest.approx(power, rel=1e-12)
    assert (found.below, found.above) == pytest.approx((power, power), rel=1e-12)
    assert found.uncertainty == pytest.approx(0.0, abs=1e-12)
    assert found.significant
    assert found.linear
    assert found.better == ("less" if power > 0 else "more")
    factor = 0.95 if power > 0 else 1.05
    assert found.lowers_percent == pytest.approx(100.0 * (1.0 - factor**power))


def test_a_cubic_term_is_the_uncertainty() -> None:
    # ln σ = a u + c u³ with u = ln p: E_h = a + c h² to leading order, E_h − E_h/2 = ¾ c h².
    values = [np.exp(np.log(one) + 40.0 * np.log(one) ** 3) for one in FACTORS]
    found = effect("P1", 1.0, values, FACTORS)
    assert found.percent_per_percent - 1.0 == pytest.approx(40.0 * 0.05**2, rel=0.01)
    assert found.uncertainty == pytest.approx(0.75 * 40.0 * 0.05**2, rel=0.01)


def test_a_valley_is_not_linear_and_noise_not_significant() -> None:
    valley = effect("P1", 1.0, [1.02, 1.005, 1.006, 1.025], FACTORS)
    assert not valley.linear
    assert valley.lowers_percent < 0.0
    noise = effect("P1", 1.0, [1.001, 0.997, 1.003, 1.0005], FACTORS)
    assert not noise.significant


def test_parameters_of_a_scenario() -> None:
    own = load(scenario_data())
    found = {one.name: one for one in parameters(own)}
    assert list(found) == [
        "dropper stiffness", "tension of the contact wire", "tension of the messenger wire",
        "pantograph mass 1 of 1 from the base",
    ]  # fmt: skip
    varied = found["tension of the contact wire"].varied(own, 1.1)
    assert varied.line.contact_wire.tension == pytest.approx(11_000.0)
    assert own.line.contact_wire.tension == 10_000.0


def test_a_mass_is_varied_wherever_its_model_stands() -> None:
    first = scenario_data()["pantographs"][0]
    pair = [{**first, "name": "front"}, {**first, "name": "rear", "distance": 100.0}]
    (mass,) = [
        one for one in parameters(load(scenario_data(pantographs=pair))) if "mass" in one.name
    ]
    assert mass.values == {f"pantographs.{i}.model.masses.0.mass": 8.0 for i in (0, 1)}


def test_a_conductor_rail_has_no_tension_and_no_droppers() -> None:
    names = [one.name for one in parameters(arcless.load("conductor-rail-1-120"))]
    assert names
    assert all("mass" in name for name in names)


def test_runs_give_the_slope_that_two_runs_give(short: Callable[..., Scenario]) -> None:
    scenario = short()
    known = sensitivities(scenario, workers=1)
    assert known.runs == 1 + 4 * len(known.parameters)
    (mass,) = [one for one in known.parameters if "2 of 2" in one.parameter]
    low, high = (
        arcless.run(scenario.with_(**{mass.paths[0]: factor * 7.2})).assessment.pantographs[0]
        for factor in (0.95, 1.05)
    )
    slope = np.log(high.std_force_N / low.std_force_N) / np.log(1.05 / 0.95)
    # A member of a batch is the run alone, bit for bit: rounding of 1.05 · 7.2.
    assert mass.effects[0].percent_per_percent == pytest.approx(slope, rel=1e-6)


def test_a_parameter_at_the_end_of_its_range_is_left_out() -> None:
    stiffest = load(scenario_data(line__dropper__stiffness=extremes.STIFFNESS))
    chosen = list(parameters(stiffest))
    made, told = variants(stiffest, chosen, FACTORS)
    assert list(told) == ["dropper stiffness"]
    assert told["dropper stiffness"].note.startswith("out of range: ")
    assert told["dropper stiffness"].effects == ()
    assert len(made) == 1 + 4 * (len(chosen) - 1)


@pytest.mark.parametrize("step", [0.0, 31.0, float("nan")])
def test_a_step_out_of_range_is_refused(short: Callable[..., Any], step: float) -> None:
    with pytest.raises(ModelError, match=r"expected 0\.1 to 30 %"):
        sensitivities(short(), step_percent=step)
