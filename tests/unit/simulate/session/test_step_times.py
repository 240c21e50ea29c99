"""Times of steps by a clock that the test moves: response, misses, percentiles, histogram."""

from collections.abc import Iterator
from types import SimpleNamespace

import numpy as np
import pytest

import arcless
from arcless.errors import ModelError
from arcless.simulate.session import step_times
from arcless.simulate.session.step_times import Stepping, StepTimes, Times, histograms, measure

MS = 1_000_000
H = 1e-3


class Clock:
    """A clock in ns that only sleeping and working move."""

    def __init__(self) -> None:
        self.now = 0
        self.late = 0

    def perf_counter_ns(self) -> int:
        return self.now

    def sleep(self, time_s: float) -> None:
        self.now += round(1e9 * time_s) + self.late


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    found = Clock()
    monkeypatch.setattr(step_times, "time", found)
    return found


def turn(clock: Clock, work_ms: list[float]) -> tuple[np.ndarray, np.ndarray]:
    """Return computing and response in ms of steps that take so long."""
    works = iter(work_ms)

    def act() -> None:
        clock.now += round(MS * next(works))

    computing, response = np.empty(len(work_ms)), np.empty(len(work_ms))
    step_times._turn(computing, response, H, (act, lambda: None), step_times._sleep)
    return 1e3 * computing, 1e3 * response


def test_a_long_step_makes_those_after_it_late(clock: Clock) -> None:
    """Work of 2.5 ms in steps of 1 ms: the next are late by 1.5 − 0.6 n ms until none is left."""
    work = [0.4, 2.5, 0.4, 0.4, 0.4, 0.4]
    computing, response = turn(clock, work)
    assert computing == pytest.approx(work)
    assert response == pytest.approx([0.4, 2.5, 1.9, 1.3, 0.7, 0.4])
    assert Times(computing / 1e3, response / 1e3, H).misses == 3


def test_waking_up_late_is_response_and_not_computing(clock: Clock) -> None:
    clock.late = MS // 5
    computing, response = turn(clock, [0.4, 0.4])
    assert computing == pytest.approx([0.4, 0.4])
    assert response == pytest.approx([0.6, 0.6])


def test_looking_at_the_clock_ends_when_it_is_time(clock: Clock) -> None:
    def ticking() -> int:
        clock.now += 7
        return clock.now

    clock.perf_counter_ns = ticking  # type: ignore[method-assign]
    assert 1000 <= step_times._spin(1000) < 1007


def test_percentiles_are_times_that_were_measured() -> None:
    times = Times(np.arange(1.0, 10001.0), np.arange(10000.0, 0.0, -1.0), 9998.0)
    expected = {
        "least": 1.0,
        "50 %": 5001.0,
        "99 %": 9901.0,
        "99.99 %": 10000.0,
        "largest": 10000.0,
    }
    assert times.percentiles("computing") == expected
    assert times.percentiles("response") == expected
    assert times.misses == 2


def test_every_time_is_in_one_class() -> None:
    rng = np.random.default_rng(1)
    values = 10.0 ** rng.uniform(-8.0, 0.0, 5000)
    values[:2] = 1e-6, 2e-6
    found = StepTimes(Times(values, values, H), Times(values, values[::2], H))
    edges, counts = histograms(found)
    assert (edges[0], edges[1], edges[3]) == (0.0, 1e-6, pytest.approx(2e-6))
    assert np.allclose(edges[2:] / edges[1:-1], np.sqrt(2.0))
    assert {name: int(each.sum()) for name, each in counts.items()} == {
        "steps computing": 5000, "steps response": 5000, "empty loop response": 2500,
    }  # fmt: skip
    assert edges[-1] > values.max()


@pytest.fixture(scope="module")
def scenario() -> arcless.Scenario:
    return arcless.load("en50318-ac-simple-320-planar")


@pytest.mark.parametrize("simulated", [False, True])
def test_steps_begin_again_where_the_line_ends(scenario: arcless.Scenario, simulated: bool) -> None:
    force = {"pantographs.0.mean_force": None, "pantographs.0.static_force": "170 N"}
    loop = arcless.realtime(scenario.with_(**force), simulated=simulated)
    begin, reach = loop.position_m, 0.5 * loop.speed_m_s
    stepping = Stepping(loop, begin + reach)
    places = []
    for _ in range(1200):
        stepping.step()
        places.append(loop.position_m)
        stepping.begin_again()
    steps = round(0.5 / loop.time_step_s)
    assert places[0] == places[steps] == places[2 * steps]
    assert begin + reach - max(places) < loop.speed_m_s * loop.time_step_s
    mean = float(np.mean(loop.contact_force_N))
    assert 0.0 < mean < 1000.0


def test_both_loops_are_measured_and_the_start_is_found_again(scenario: arcless.Scenario) -> None:
    loop = arcless.realtime(scenario)
    told: list[float] = []
    found = measure(loop, 1e9, 0.05, progress=lambda fraction, _: told.append(fraction))
    assert len(found.steps.response_s) == len(found.empty.response_s) == 50
    assert (found.steps.computing_s > 0.0).all()
    # By the clock of the machine: an empty loop does less than a step, in the least of 50.
    assert found.empty.computing_s.min() < found.steps.computing_s.min()
    assert told == [0.0]


def test_nothing_to_measure(scenario: arcless.Scenario) -> None:
    loop = SimpleNamespace(time_step_s=H)
    with pytest.raises(ModelError, match=r"seconds: got 0\.0005, expected one time step, or more"):
        measure(loop, 1e9, 0.0005)  # type: ignore[arg-type]


def test_it_is_cancelled(scenario: arcless.Scenario) -> None:
    asked: Iterator[bool] = iter([False, True])
    with pytest.raises(KeyboardInterrupt):
        measure(arcless.realtime(scenario), 1e9, 2.0, cancel=lambda: next(asked))
