"""The environment: Gymnasium's own check, seeds, the same bits as a run, and what is refused."""

import warnings
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import arcless
from arcless import ControlError, ModelError, control
from arcless.control.environment import PantographEnv
from arcless.control.vector_environment import PantographVectorEnv
from arcless.model import Scenario
from tests.unit.control.conftest import ACTUATOR, SETTINGS

Floats = np.ndarray


def wave(number: int) -> float:
    """Force in N that goes beyond both limits."""
    return 80.0 * float(np.sin(0.05 * number))


def episode(env: PantographEnv, seed: int, law: Callable[[int], float] = wave) -> Floats:
    """Return what is seen and earned in an episode, a row for each sample."""
    seen, _ = env.reset(seed=seed)
    rows, ended, number = [np.append(seen, 0.0)], False, 0
    while not ended:
        seen, earned, terminated, truncated, _ = env.step([law(number)])
        rows.append(np.append(seen, earned))
        ended, number = terminated or truncated, number + 1
    assert truncated
    return np.array(rows)


@pytest.mark.parametrize("render_mode", [None, "ansi"])
def test_gymnasium_has_nothing_to_say(scenario: Scenario, render_mode: str | None) -> None:
    more = {"actuator": ACTUATOR, "spans": 1, "lead_in_spans": 1}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        env = gymnasium.make(
            control.ENVIRONMENT, scenario=scenario, render_mode=render_mode, **more
        )
        check_env(env.unwrapped)
    assert env.action_space == gymnasium.spaces.Box(-1.0, 1.0, (1,), np.float64)


def test_actions_are_parts_of_the_limit_or_newtons(scenario: Scenario) -> None:
    settings = {**SETTINGS, "action_in": "limit"}
    env = PantographEnv(scenario=scenario, **settings)
    env.reset(seed=1)
    for _ in range(8):
        *_, info = env.step([0.25])
    assert info["force_N"] == 15.0
    for _ in range(40):
        *_, info = env.step([7.0])
    assert info["force_N"] == 60.0  # the limit of the actuator, as in a run


def test_seeds_give_the_same_bits(task: control.Task) -> None:
    env = PantographEnv(task=task)
    first, other, again = (episode(env, seed) for seed in (5, 6, 5))
    assert first.tobytes() == again.tobytes()
    assert first.shape != other.shape or first.tobytes() != other.tobytes()


def test_an_episode_is_whole_spans(task: control.Task) -> None:
    env = PantographEnv(task=task)
    _, info = env.reset(options={"start_m": 80.0})
    # A lead-in of one span of 50 m, and a part of a sample of 0.178 m at most.
    assert 130.0 <= info["position_m"] < 130.0 + task.sample_m
    begun, ended = info["position_m"], False
    while not ended:
        *_, ended, info = env.step([0.0])
    assert info["position_m"] - begun == pytest.approx(50.0, abs=0.5 * task.sample_m)


def test_starts_cover_the_spans_they_may(task: control.Task) -> None:
    env, (low, high) = PantographEnv(task=task), task.begin_between
    # From the second support on; two spans and two samples before the last support but one.
    assert low == 1.0
    assert high == pytest.approx(5.0 - 2.0 * task.sample_m / 50.0)
    starts = [env.reset(seed=seed)[1]["start_m"] for seed in range(6)]
    assert min(starts) >= 50.0
    assert max(starts) <= 250.0
    assert np.ptp(starts) > 25.0  # six draws over 200 m


def test_a_run_with_the_same_forces_has_the_same_bits(task: control.Task) -> None:
    env = PantographEnv(task=task)
    seen, info = env.reset(seed=2)
    lead_in, _ = task.lengths(task.spans_of_line.count_at(info["start_m"]))
    there, acted, ended = [seen], [], False
    while not ended:
        seen, *_, ended, told = env.step([wave(len(acted))])
        there.append(seen)
        acted.append(told["force_N"])
    here: list[Floats] = []

    class Wave:
        """Law that keeps what it sees, without a force in the lead-in."""

        def begin(self) -> None:
            here.clear()

        def __call__(self, seen: Floats) -> Floats:
            number = len(here) - lead_in
            here.append(seen[0].copy())
            return np.array([wave(number) if 0 <= number < len(acted) else 0.0])

    controller = control.LawController.of(Wave(), task)
    changes = {
        "pantographs.0.static_force": info["static_force_N"],
        "travel": {"start": info["start_m"], "end": told["position_m"] + 5.0},
        "analysis": {"from": info["start_m"] + 10.0, "to": told["position_m"]},
    }
    # A run copies an object that is a controller, and its list with it; a function it does not.
    run = arcless.run(
        task.scenario.with_(**changes),
        controllers={"P1": lambda sample: controller(sample)},  # noqa: PLW0108
    )
    np.testing.assert_array_equal(np.array(here[lead_in : lead_in + len(there)]), np.array(there))
    steps = round(task.sample_time_s / task.line.time_step_s)
    force = run.dataset["control_force"].values[:, 0]
    np.testing.assert_array_equal(force[lead_in * steps :][steps - 1 :: steps][: len(acted)], acted)


@pytest.mark.parametrize("workers", [1, 3])
def test_many_at_once_are_each_alone(task: control.Task, workers: int) -> None:
    count, env = 3, PantographVectorEnv(3, task=task, workers=workers, autoreset=False)
    seen, _ = env.reset(seed=5)
    rows = [[np.append(one, 0.0)] for one in seen]
    ended, number = np.zeros(count, dtype=bool), 0
    while not ended.all():
        seen, earned, terminated, truncated, _ = env.step(np.full((count, 1), wave(number)))
        for i in np.flatnonzero(~ended):
            rows[i].append(np.append(seen[i], earned[i]))
        ended, number = ended | terminated | truncated, number + 1
    alone = PantographEnv(task=task)
    for i in range(count):
        assert np.array(rows[i]).tobytes() == episode(alone, 5 + i).tobytes()


def test_after_an_end_the_next_step_begins_another_episode(task: control.Task) -> None:
    env = PantographVectorEnv(2, task=task)
    env.reset(seed=[7, 8])
    for _ in range(400):
        _, _, terminated, truncated, _ = env.step(np.zeros((2, 1)))
        if truncated[0]:
            break
    assert truncated[0]
    assert not terminated.any()
    seen, earned, _, truncated, _ = env.step(np.full((2, 1), 50.0))
    assert earned[0] == 0.0
    assert not truncated[0]
    alone = PantographEnv(task=task)
    alone.reset(seed=7)
    np.testing.assert_array_equal(seen[0], alone.reset()[0])  # the second draw of that seed


def test_failures_end_an_episode_and_say_why(scenario: Scenario) -> None:
    pulling = {"sample_time": "4 ms", "minimum_force": "-9 kN", "maximum_force": "9 kN"}
    weights = {"failure": 7.0}
    settings = {**SETTINGS, "actuator": pulling, "weights": weights}
    many = PantographVectorEnv(2, scenario=scenario, **settings, autoreset=False)
    many.reset(seed=1)
    alone = PantographEnv(task=many.task)
    before, _ = alone.reset(seed=1)
    for _ in range(60):
        seen, earned, terminated, truncated, told = alone.step([-9000.0])
        _, rewards, failed, _, info = many.step([[-9000.0], [0.0]])
        if terminated:
            break
        before = seen
    assert terminated
    assert not truncated
    # 9 kN on 15 kg fall 2 m in 82 ms.
    assert "beyond its range" in told["failure"]
    assert earned == rewards[0] == -7.0
    np.testing.assert_array_equal(seen, before)
    assert failed.tolist() == [True, False]
    assert info["failure"][0] == told["failure"]
    assert info["failure"][1] is None
    with pytest.raises(ControlError, match="the episode has ended"):
        alone.step([0.0])


def test_what_is_rendered_is_a_line_of_text(task: control.Task) -> None:
    env = PantographEnv(task=task, render_mode="ansi")
    env.reset(options={"start_m": 60.0})
    assert env.render() == "begun at 60.00 m"
    env.step([0.0])
    assert "contact force" in str(env.render())
    assert PantographEnv(task=task).render() is None


ACTIONS: list[tuple[Any, str]] = [
    ([np.nan], "not finite"),
    ([np.inf], "not finite"),
    ([1.0, 2.0], "wrong shape"),
    ([[1.0, 2.0]], "wrong shape"),
    (5.0, "wrong shape"),
    ("5 N", "wrong shape"),
    (None, "wrong shape"),
]


@pytest.mark.parametrize(("action", "what"), ACTIONS)
def test_wrong_actions_are_refused(task: control.Task, action: Any, what: str) -> None:
    env = PantographEnv(task=task)
    env.reset(seed=1)
    with pytest.raises(ControlError, match=what):
        env.step(action)
    assert env.step([0.0])[1] < 0.0  # and the episode continues


@pytest.mark.parametrize("action", [[[0.0], [np.nan]], [0.0, 0.0], [[0.0]], np.zeros((2, 2)), None])
def test_wrong_actions_of_many_are_refused(task: control.Task, action: Any) -> None:
    env = PantographVectorEnv(2, task=task)
    env.reset(seed=1)
    with pytest.raises(ControlError, match=r"not finite|wrong shape.*\(2, 1\)"):
        env.step(action)


WRONG: list[tuple[dict[str, Any], str]] = [
    ({"scenario": "no-such-line"}, "no-such-line"),
    ({"scenario": "praks-180", "speed": 3}, "settings of an environment"),
    ({"pantograph": "P7"}, "unknown pantograph"),
    ({"observe": ["colour"]}, "unknown signal"),
    ({"observe": []}, "signals to observe"),
    ({"observe": "strip_force_N"}, "signals to observe"),
    ({"actuator": {"sample_time": "3 ms"}}, "time_step"),
    ({"actuator": {"sample_time": "4 ms", "minimum_force": "-1 N"}}, "without limits"),
    ({"actuator": {**ACTUATOR, "pid": {"target": "80 N"}}}, "a law in the actuator"),
    ({"weights": {"scatter": 1.0}}, "unknown weight"),
    ({"weights": {"failure": float("nan")}}, "a weight of the reward"),
    ({"spans": 0}, "not a number of spans"),
    ({"spans": 1.5}, "not a number of spans"),
    ({"spans": 20}, "no room for an episode"),
    ({"window_spans": 3}, "window is longer"),
    ({"stretch_m": (100.0, 110.0)}, "no room for an episode"),
    ({"stretch_m": "all"}, "a stretch of the line"),
    ({"target_force_N": -5.0}, "a mean contact force"),
    ({"action_in": "kN"}, "unit of the action"),
    ({"render_mode": "human"}, "render_mode"),
]


@pytest.mark.parametrize(("settings", "what"), WRONG, ids=[what for _, what in WRONG])
def test_wrong_settings_are_refused(
    scenario: Scenario, settings: dict[str, Any], what: str
) -> None:
    with pytest.raises(ModelError, match=what):
        PantographEnv(**{"scenario": scenario, "actuator": ACTUATOR, "spans": 1, **settings})


def test_a_speed_that_changes_is_refused(scenario: Scenario) -> None:
    profile = {"speed": None, "speed_profile": {"time": [0, 9], "speed": [30.0, 40.0]}}
    with pytest.raises(ModelError, match="a speed that changes"):
        control.task(scenario.with_(**profile), actuator=ACTUATOR)


@pytest.mark.parametrize("start", [0.0, 390.0, float("nan"), "60 m"])
def test_starts_without_room_are_refused(task: control.Task, start: Any) -> None:
    with pytest.raises(ModelError, match="the start of an episode"):
        PantographEnv(task=task).reset(options={"start_m": start})


def test_resets_that_do_not_fit_are_refused(task: control.Task) -> None:
    env = PantographVectorEnv(2, task=task)
    with pytest.raises(ControlError, match="no episode has begun"):
        env.step(np.zeros((2, 1)))
    with pytest.raises(ModelError, match="unknown option of reset"):
        env.reset(options={"where": 60.0})
    with pytest.raises(ModelError, match="one for each of 2 episodes"):
        env.reset(seed=[1, 2, 3])
    with pytest.raises(ModelError, match="num_envs"):
        PantographVectorEnv(0, task=task)
    with pytest.raises(ModelError, match="one of the two"):
        PantographVectorEnv(2, task=task, spans=3)


def test_the_environment_is_made_by_its_name(scenario: Scenario) -> None:
    more = {"actuator": ACTUATOR, "spans": 1, "lead_in_spans": 1}
    many = gymnasium.make_vec(control.ENVIRONMENT, num_envs=2, scenario=scenario, **more)
    assert isinstance(many.unwrapped, PantographVectorEnv)
    said = many.unwrapped.describe()
    assert said["weights"]["scatter_per_N_s"] == 1.0
    assert [one["name"] for one in said["observe"]] == list(control.DEFAULT)


def test_the_actuator_of_a_scenario_is_taken(scenario: Scenario) -> None:
    own = {"sample_time": "8 ms", "minimum_force": "-5 N", "maximum_force": "10 N"}
    law = {**own, "pid": {"target": "80 N", "proportional": 1}}
    task = control.task(scenario.with_(**{"pantographs.0.controller": law}), spans=1)
    assert task.controller.pid is None
    assert (task.sample_time_s, task.action_unit_N) == (0.008, 10.0)


def test_laws_of_runs_need_no_gymnasium(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("arcless.control.packages.is_installed", lambda _: False)
    with pytest.raises(ModelError, match=r"gymnasium.*arcless\[control\]"):
        _ = control.PantographEnv
    with pytest.raises(ModelError, match=r"gymnasium"):
        control.register()
    assert control.LawController is not None
