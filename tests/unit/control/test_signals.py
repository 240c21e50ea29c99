"""Signals: Newton's law of what is above the sensors, and pantographs that have no such sensor."""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless import ControlInput, ModelError, control
from arcless.control.signals import SIGNALS, Reader, Sample, chosen, observation, sensor_of
from arcless.model import Scenario

NEWMARK = {"solver.scheme": {"name": "newmark", "beta": 0.3025, "gamma": 0.6}}
LIFT = {"pantographs.0.model.masses.1.aerodynamic": "0.004 N/(m/s)2"}


def test_the_sensor_shows_the_contact_force_without_the_inertia(scenario: Scenario) -> None:
    scenario = scenario.with_(**NEWMARK, **LIFT)
    pantograph, speed = scenario.pantographs[0].model, scenario.top_speed
    sensor = sensor_of(pantograph, speed)
    assert sensor is not None
    assert sensor.lift_N == pytest.approx(0.004 * speed**2)
    seen: list[ControlInput] = []
    arcless.run(scenario, controllers={"P1": lambda sample: seen.append(sample) or 0.0})
    u, v = (np.array([getattr(s, n) for s in seen]) for n in ("displacements_m", "velocities_m_s"))
    pressed = np.array([s.contact_force_N for s in seen])
    sample = Sample(pressed, u, v, u, v, np.full(len(u), pressed[0]), 0 * pressed, speed, pressed)
    (found,) = observation([SIGNALS["strip_force_N"]], sample, Reader(0.002, sensor)).T
    # F_s = F_c + m z̈ − L, by the second difference of the displacement.
    acceleration = np.diff(u[:, -1], n=2) / scenario.time_step_s**2
    expected = pressed[1:-1] + pantograph.masses[-1].mass * acceleration - sensor.lift_N
    # A second difference is Newmark's acceleration filtered over three steps: what is left of it
    # is in the roughness of the force, a few newtons; the slow part must agree.
    for signal in (found[1:-1] - expected,):
        smooth = np.convolve(signal, np.ones(25) / 25, mode="valid")[100:]
        assert np.abs(smooth).max() < 0.02 * np.ptp(pressed)
    inertia = np.abs(found[1:-1] - pressed[1:-1] + sensor.lift_N)
    assert inertia[100:].max() > 0.05 * np.ptp(pressed)  # it is not the contact force
    assert found[0] == pytest.approx(pressed[0] - sensor.lift_N)


def test_rates_are_gained_over_the_sample() -> None:
    now, before = np.array([[0.3, 0.1]]), np.array([[0.1, 0.1]])
    one = np.ones(1)
    sample = Sample(one, now, 2 * now, before, 2 * before, one, 7 * one, 40.0, 0.25 * one)
    names = (
        "frame_displacement_m", "frame_velocity_m_s", "frame_acceleration_m_s2",
        "head_acceleration_m_s2", "asked_force_N", "speed_m_s", "span_position_1",
    )  # fmt: skip
    found = observation([SIGNALS[name] for name in names], sample, Reader(0.1, None))[0]
    np.testing.assert_allclose(found, [0.3, 2.0, 4.0, 0.0, 7.0, 40.0, 0.25])


MATRICES = {
    "mass": [[10.0]], "damping": [[20.0]], "stiffness": [[50.0]], "strip": [1.0], "preload": [1.0],
}  # fmt: skip
HEAD: dict[str, Any] = {
    "strips": 2, "strip_spacing": "0.3 m", "half_length": "0.6 m", "mass": "3 kg",
    "stiffness": "5 kN/m", "damping": "10 N s/m",
}  # fmt: skip
PART = "pantographs.0.model"


@pytest.mark.parametrize(
    ("changes", "names"),
    [
        ({f"{PART}.head": HEAD}, ["strip_force_N"]),
        ({f"{PART}.head": HEAD}, ["frame_displacement_m"]),
        ({f"{PART}.masses.1.friction": {"force": "2 N"}}, ["strip_force_N"]),
    ],
)
def test_pantographs_without_such_sensors_are_refused(
    scenario: Scenario, changes: dict[str, Any], names: list[str]
) -> None:
    pantograph = scenario.with_(**changes).pantographs[0].model
    with pytest.raises(ModelError, match=f"{names[0]} is not defined for the pantograph"):
        chosen(names, pantograph)
    assert chosen(["contact_force_N"], pantograph)[0].unit == "N"


def test_a_head_of_two_strips_is_controlled_by_its_contact_force(scenario: Scenario) -> None:
    headed = scenario.with_(**{f"{PART}.head": HEAD})
    settings: dict[str, Any] = {"observe": ["contact_force_N"], "spans": 1, "lead_in_spans": 1}
    actuator = {"sample_time": "4 ms", "minimum_force": -50, "maximum_force": 50}
    env = control.PantographEnv(scenario=headed, actuator=actuator, **settings)
    seen, info = env.reset(seed=1)
    assert 20.0 < seen[0] < 200.0  # the sum of both strips, about the static force of 80 N
    assert info["static_force_N"] > 0.0


def test_every_signal_says_its_unit_and_what_measures_it() -> None:
    for name, signal in SIGNALS.items():
        assert signal.name == name
        assert name.endswith(signal.unit.replace("/", "_").replace("²", "2"))
        assert signal.low < signal.high
        assert signal.measured_by
    assert "span_position_1" not in control.DEFAULT
