"""Controlled forces: sampling, delay, limits, energy, and failures that say where."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import ControlError, ControlInput
from arcless.model import Scenario
from arcless.results import Result
from arcless.simulate.setup.controllers import Controllers

Short = Callable[..., Scenario]
Run = Callable[..., Result]
Data = dict[str, Any]
CONTROLLER = "pantographs.0.controller"
BASE = "pantographs.0.model.masses.0"
TRAPEZOIDAL = {"solver.scheme": {"name": "trapezoidal"}}


def force(result: Result) -> np.ndarray:
    return result.dataset["contact_force"].values[:, 0]


def test_a_controller_that_does_nothing_changes_no_bit(short: Short, run: Run) -> None:
    for more in ({}, TRAPEZOIDAL):
        plain, idle = run(**more), arcless.run(short(**more), controllers={"P1": lambda _: 0.0})
        assert set(idle.dataset.variables) - set(plain.dataset.variables) <= {
            "control_force",
            "energy_work_control",
        }
        for name in plain.dataset.variables:
            there, here = plain.dataset[name].values, idle.dataset[name].values
            assert there.tobytes() == here.tobytes() or list(there) == list(here), name
        assert not idle.dataset["control_force"].values.any()


def test_samples_say_what_the_run_records(short: Short) -> None:
    seen: list[ControlInput] = []

    def look(sample: ControlInput) -> float:
        seen.append(sample)
        return 5.0 * np.sin(20.0 * sample.time_s)

    # Balance at the end of the step: what is recorded of a step is what the next sample sees.
    scheme = {"solver.scheme": {"name": "newmark", "beta": 0.3025, "gamma": 0.6}}
    scenario = short(**scheme)
    data = arcless.run(scenario, controllers={"P1": look}).dataset
    step = scenario.time_step_s
    assert [s.sample_number for s in seen] == list(range(len(seen)))
    later = seen[1:]
    recorded = data["contact_force"].values[: len(later), 0]
    np.testing.assert_array_equal([s.contact_force_N for s in later], recorded)
    moved = data["mass_displacement"].values[: len(later), 0]
    # The same numbers: room for the round-off of 1 m, and of 1e3 m along the track.
    np.testing.assert_allclose([s.displacements_m for s in later], moved, rtol=0, atol=1e-12)
    np.testing.assert_allclose(
        [s.position_m for s in later], data["position"].values[: len(later), 0], rtol=0, atol=1e-9
    )
    # Newmark's v = Δu/h up to first order.
    rate = np.diff(moved, axis=0)[200:] / step
    given = np.array([s.velocities_m_s for s in later])[201:]
    assert np.max(np.abs(rate - given)) < 0.1 * np.max(np.abs(given))
    assert seen[0].contact_force_N == pytest.approx(80.0)


@pytest.mark.parametrize(("every", "delay"), [(1, 0), (1, 3), (4, 0), (4, 2), (4, 9)])
def test_a_force_acts_exactly_after_its_delay(short: Short, every: int, delay: int) -> None:
    step = short().time_step_s
    timing = {"sample_time": every * step, "delay": delay * step}
    scenario = short(**{CONTROLLER: timing, "travel.end": "60 m", "analysis.to": "59 m"} | SECTION)
    result = arcless.run(scenario, controllers={"P1": lambda sample: sample.sample_number + 1.0})
    found = result.dataset["control_force"].values[:, 0]
    number = np.arange(len(found)) - delay
    np.testing.assert_array_equal(found, np.where(number < 0, 0, number // every + 1))


SECTION = {"analysis": {"from": "51 m", "to": "59 m"}, "travel": {"start": "50 m", "end": "60 m"}}


def test_a_controller_that_is_a_spring_is_the_spring(short: Short) -> None:
    """Held for T the force lags by T/2 on average: −k u(t − T/2) = −k u + ½ k T u̇."""
    stiffness, samples = 400.0, [1, 2, 4, 8]
    step = short().time_step_s
    part = short().pantographs[0].model.masses[0]
    assert part.damping is not None
    errors, rest = [], []
    for every in samples:
        held = every * step
        scenario = short(**{CONTROLLER: {"sample_time": held}})
        spring = {"P1": lambda sample: -stiffness * sample.displacements_m[0]}
        found = force(arcless.run(scenario, controllers=spring))
        added = {f"{BASE}.stiffness": (part.stiffness or 0.0) + stiffness}
        errors.append(np.std(found - force(arcless.run(short(**added)))))
        added[f"{BASE}.damping"] = part.damping - 0.5 * stiffness * held
        rest.append(np.std(found - force(arcless.run(short(**added)))))
    ratios = np.divide(errors[1:], errors[:-1])
    # First order in T; droppers that slacken blur it.
    assert np.all((ratios > 1.6) & (ratios < 2.4)), errors
    # With the lag as a negative damper what is left is a small part.
    assert np.all(np.array(rest) < 0.2 * np.array(errors)), (errors, rest)


def test_the_work_of_the_controller_is_in_the_balance(short: Short) -> None:
    pid = {"target": 80, "proportional": 0.5, "integral": 2.0, "filter": "10 ms"}
    timing = {"sample_time": "4 ms", "delay": "2 ms"}
    scenario = short(**{CONTROLLER: {**timing, "pid": pid}}, **TRAPEZOIDAL)
    data = arcless.run(scenario).dataset
    assert data.attrs["energy_residual_relative"] < 1e-11
    work = data["energy_work_control"].values
    assert np.max(np.abs(work)) > 0.1
    # Force times increment, from the record: its displacements are those between two steps.
    moved = np.diff(data["mass_displacement"].values[:, 0, 0], prepend=0.0)
    total = np.cumsum(data["control_force"].values[:, 0] * moved)[:: scenario.output.line_every]
    assert np.max(np.abs(work - total)) < 0.02 * np.max(np.abs(work))


def test_limits_hold(short: Short) -> None:
    limits = {"minimum_force": -3, "maximum_force": 2, "rate_limit": "50 N/s"}
    timing = {"sample_time": "10 ms", **limits}
    scenario = short(**{CONTROLLER: timing} | SECTION)
    swing = {"P1": lambda sample: 100.0 if sample.time_s < 0.12 else -100.0}
    found = arcless.run(scenario, controllers=swing).dataset["control_force"].values[:, 0]
    assert (found.min(), found.max()) == (-3.0, 2.0)
    # 50 N/s over 10 ms, but for rounding.
    assert np.max(np.abs(np.diff(found))) == pytest.approx(0.5)


class Counting:
    """A controller with a memory, which must be empty at the start of each run."""

    def __init__(self) -> None:
        self.samples = 0

    def __call__(self, sample: ControlInput) -> float:
        assert self.samples == sample.sample_number
        self.samples += 1
        return 3.0 * np.sin(5.0 * sample.time_s)


@pytest.mark.parametrize("controller", [Counting, Counting()])
def test_every_run_of_a_search_has_a_new_controller(short: Short, controller: Any) -> None:
    wanted = {"pantographs.0.static_force": None, "pantographs.0.mean_force": "85 N"}
    result = arcless.run(short(**wanted), controllers={"P1": controller})
    # The search stops within 0.02 N; five times that.
    assert result.assessment.pantographs[0].mean_force_N == pytest.approx(85.0, abs=0.1)


def failing(sample: ControlInput) -> float:
    if sample.sample_number == 250:
        raise ValueError("sensor lost")
    return 0.0


@pytest.mark.parametrize(
    ("controller", "words"),
    [
        (failing, r"P1, t = 0\.\d+ s, \d+\.\d+ m: the controller failed: got ValueError: sensor"),
        (lambda _: float("nan"), r"P1, t = 0 s, 50\.00 m: the controller gave no force: got nan"),
        (lambda _: None, "gave no force: got None, expected N"),
        (lambda _: "much", "gave no force: got 'much', expected N"),
        (lambda: 0.0, "the controller failed: got TypeError"),
        (3.0, "the controller of P1 cannot be called: got 3.0"),
    ],
)
def test_a_controller_that_fails_is_named(short: Short, controller: Any, words: str) -> None:
    with pytest.raises(ControlError, match=words):
        arcless.run(short(), controllers={"P1": controller})


def test_controllers_belong_to_pantographs(short: Short) -> None:
    with pytest.raises(ControlError, match="unknown pantograph: got 'P2', expected one of: P1"):
        arcless.run(short(), controllers={"P2": failing})
    with pytest.raises(ControlError, match="nothing decides on the force"):
        arcless.run(short(**{CONTROLLER: {"sample_time": "2 ms"}}))


def stop_run(_: ControlInput) -> float:
    raise KeyboardInterrupt


def test_a_controller_may_be_interrupted(short: Short) -> None:
    with pytest.raises(KeyboardInterrupt):
        arcless.run(short(), controllers={"P1": stop_run})


SOURCE = """
from dataclasses import dataclass

open(__file__ + ".run", "a").write("run ")
count = 0


def push(sample):
    global count
    count += 1
    assert count == sample.sample_number + 1, "a memory of another run"
    return 2.0


@dataclass
class Ramp:
    force: "float" = 0.0

    def __call__(self, sample):
        self.force += 0.1
        return self.force
"""


def written(short: Short, folder: Path, function: str, **more: Any) -> Path:
    import json

    data = short(**SECTION, **more).to_dict()
    data["pantographs"][0]["controller"] = {"sample_time": 0.01, "function": function}
    (folder / "scenario.json").write_text(json.dumps(data), encoding="utf-8")
    return folder / "scenario.json"


def test_a_function_comes_from_a_file_beside_the_scenario(short: Short, tmp_path: Path) -> None:
    (tmp_path / "laws.py").write_text(SOURCE, encoding="utf-8")
    scenario = arcless.load(written(short, tmp_path, "laws.py:push"))
    assert not (tmp_path / "laws.py.run").exists(), "loading runs nothing"
    found = arcless.run(scenario).dataset["control_force"].values
    assert (found == 2.0).all()
    again = arcless.load(scenario.to_dict())
    assert again.pantographs[0].controller == scenario.pantographs[0].controller
    ramp = arcless.load(written(short, tmp_path, "laws.py:Ramp"))
    found = arcless.run(ramp).dataset["control_force"].values
    assert found[0] == pytest.approx(0.1)
    wanted = {"pantographs.0.static_force": None, "pantographs.0.mean_force": "85 N"}
    arcless.run(scenario.with_(**wanted))


def test_a_file_or_function_that_is_not_there(short: Short, tmp_path: Path) -> None:
    with pytest.raises(arcless.ModelError, match=r"controller\.function.*file not found"):
        arcless.load(written(short, tmp_path, "laws.py:push"))
    (tmp_path / "laws.py").write_text(SOURCE, encoding="utf-8")
    missing = arcless.load(written(short, tmp_path, "laws.py:pull"))
    with pytest.raises(ControlError, match=r"laws\.py has no function pull.*one of: "):
        arcless.run(missing)
    (tmp_path / "laws.py").write_text("import nothing_of_this_name\n", encoding="utf-8")
    with pytest.raises(ControlError, match=r"laws\.py cannot be run: got ModuleNotFoundError"):
        Controllers(missing)


@pytest.mark.parametrize(
    ("controller", "words"),
    [
        ({"sample_time": "2.5 ms"}, "sample_time: not a multiple of the time step: got 2.5 ms"),
        ({"sample_time": "0.1 ms"}, "sample_time: not a multiple of the time step"),
        ({"sample_time": "2 ms", "delay": "1.5 ms"}, "delay: not a multiple of the time step"),
        ({"sample_time": "2 ms", "mass": 3}, "mass: no such mass: got 3, expected at most 2"),
        ({"sample_time": "2 ms", "function": "push"}, "function: not a function in a file"),
        (
            {"sample_time": "2 ms", "function": "a.py:b", "pid": {"target": 100}},
            "function: both pid and function given",
        ),
        (
            {"sample_time": "2 ms", "minimum_force": 5, "maximum_force": 2},
            "maximum_force: limits out of order: got 5 N and 2 N",
        ),
    ],
)
def test_what_does_not_fit_is_refused(short: Short, controller: Data, words: str) -> None:
    with pytest.raises(arcless.ModelError) as caught:
        short(**{CONTROLLER: controller})
    assert words in str(caught.value)
