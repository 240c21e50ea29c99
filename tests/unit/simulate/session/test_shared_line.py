"""Sessions on a shared line: each has the bits it has alone, and failures stay with their own."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import ContactError, ModelError, _core
from arcless.model import Scenario
from arcless.simulate.session.shared_line import Advanced, SharedLine

Short = Callable[..., Scenario]
Floats = np.ndarray
PLACES = [55.0, 70.0, 101.5]
GIVEN = {"pantographs.0.mean_force": None, "pantographs.0.static_force": 80.0}


def pushed(steps: int, phase: float) -> Floats:
    """Forces in N of so many steps of one pantograph."""
    return 30.0 * np.sin(0.03 * np.arange(steps) + phase)[:, None]


def stepped(line: SharedLine, places: list[float], workers: int) -> list[Floats]:
    """Return contact forces, displacements and velocities of sessions begun at places in m."""
    sessions = [line.begin(place) for place in places]
    forces = np.stack([pushed(300, place) for place in places])
    pieces = [line.advance(sessions, part, workers) for part in np.split(forces, [7, 100], axis=1)]
    names = ("contact_force_N", "displacement_m", "velocity_m_s")
    return [np.concatenate([getattr(piece, name) for piece in pieces], axis=1) for name in names]


@pytest.fixture(scope="module")
def line(short: Short) -> SharedLine:
    return SharedLine(short(**GIVEN))


@pytest.mark.parametrize("workers", [1, 2, 7])
def test_each_session_is_as_it_is_alone(line: SharedLine, workers: int) -> None:
    together = stepped(line, PLACES, workers)
    for row, place in enumerate(PLACES):
        for many, alone in zip(together, stepped(line, [place], 1), strict=True):
            np.testing.assert_array_equal(many[row], alone[0])


def test_a_session_is_the_run_from_its_start(line: SharedLine) -> None:
    place, (force, *_) = PLACES[1], stepped(line, [PLACES[1]], 1)
    static = float(line.begin(place).static_force_N[0])
    changes = {"travel.start": place, "pantographs.0.static_force": static}
    acting = pushed(300, place)[:, 0].tolist()
    law = {"P1": lambda sample: acting[min(sample.sample_number, 299)]}
    run = arcless.run(line.scenario.with_(**changes), controllers=law).dataset
    np.testing.assert_array_equal(force[0, :, 0], run["contact_force"].values[:300, 0])


def test_the_same_pantograph_has_another_static_force_elsewhere(short: Short) -> None:
    stiff = SharedLine(short(**GIVEN, **{"pantographs.0.model.masses.0.stiffness": 500.0}))
    found = [float(stiff.begin(place).static_force_N[0]) for place in (50.0, 75.0, 100.0)]
    assert found[0] == pytest.approx(80.0)  # where the run starts
    # All spans are alike; in the middle of one the wire yields more, and the spring with it.
    assert found[2] == pytest.approx(found[0], abs=0.5)
    assert found[1] < found[0] - 1.0


def test_a_mean_force_is_that_of_the_run_without_control(short: Short) -> None:
    wanted = {"pantographs.0.static_force": None, "pantographs.0.mean_force": 95.0}
    scenario = short(**wanted)
    line = SharedLine(scenario)
    run = arcless.run(line.scenario)
    # `mean_force.TOLERANCE`
    assert run.assessment.pantographs[0].mean_force_N == pytest.approx(95.0, abs=0.02)


def test_a_failure_stays_with_its_session(line: SharedLine) -> None:
    sessions = [line.begin(place) for place in (60.0, 199.0)]
    sessions[1].start_m = 298.0  # two metres before the end of the wire
    found: Advanced = line.advance(sessions, np.zeros((2, 40, 1)), 2)
    assert found.failures[0] is None
    assert isinstance(found.failures[1], ContactError)
    assert "P1 left the wire" in str(found.failures[1])
    assert sessions[0].steps == 40
    assert 0 < sessions[1].steps < 40
    assert f"{298.0 + sessions[1].steps * 0.002 * line.speed_m_s:.2f} m" in str(found.failures[1])
    alone = line.advance([line.begin(60.0)], np.zeros((1, 40, 1)), 1)
    np.testing.assert_array_equal(found.contact_force_N[0], alone.contact_force_N[0])
    assert line.advance(sessions[:1], np.zeros((1, 5, 1)), 1).failures == [None]


@pytest.mark.parametrize("place", [0.0, 250.0, float("nan")])
def test_starts_outside_the_travel_are_refused(line: SharedLine, place: float) -> None:
    with pytest.raises(ModelError, match="a start outside the travel"):
        line.begin(place)


def test_a_speed_that_changes_is_refused(short: Short) -> None:
    profile = {"speed": None, "speed_profile": {"time": [0, 5], "speed": [30.0, 40.0]}}
    with pytest.raises(ModelError, match="a speed that changes"):
        SharedLine(short(**GIVEN, **profile))


def call(line: SharedLine, **changes: Any) -> dict[str, Any]:
    """Return arguments of the core's call for two sessions, some of them changed."""
    width = 4 * 1 + 2 * 2
    return {
        "sessions": [line.begin(place).core for place in PLACES[:2]],
        "forces": np.zeros((2, 5, 1)),
        "positions": np.array([[place + 0.01 * k for k in range(1, 6)] for place in PLACES[:2]]),
        "speeds": np.full(2, 5.0),
        "out": np.zeros((2, 5, width)),
        "workers": 1,
        **changes,
    }


WRONG: list[dict[str, Any]] = [
    {"forces": np.zeros((2, 5, 2))},
    {"forces": np.zeros((2, 4, 1))},
    {"forces": np.zeros((1, 5, 1))},
    {"forces": np.zeros((2, 0, 1))},
    {"positions": np.zeros((2, 4))},
    {"speeds": np.zeros(3)},
    {"out": np.zeros((2, 5, 7))},
    {"out": np.zeros((2, 5, 16))[:, :, ::2]},
    {"workers": 0},
    {"sessions": []},
]


def test_no_session_takes_no_step(line: SharedLine) -> None:
    for inputs, width in ((1, 8), (0, 0)):
        none = {"forces": np.zeros((0, 5, inputs)), "out": np.zeros((0, 5, width))}
        more = {"sessions": [], "positions": np.zeros((0, 5)), "speeds": np.zeros(0)}
        assert _core.advance(**call(line, **none, **more)) == []


@pytest.mark.parametrize("changes", WRONG, ids=str)
def test_the_core_refuses_arrays_that_do_not_fit(line: SharedLine, changes: dict[str, Any]) -> None:
    with pytest.raises((ValueError, TypeError)):
        _core.advance(**call(line, **changes))


def test_the_core_refuses_a_session_twice_and_numbers_that_are_not_finite(line: SharedLine) -> None:
    given = call(line)
    with pytest.raises(RuntimeError):
        _core.advance(**{**given, "sessions": [given["sessions"][0]] * 2})
    given["forces"][1, 3] = np.nan
    (steps, error), (others, failure) = _core.advance(**given)
    assert (steps, error, others) == (5, None, 3)
    assert isinstance(failure, _core.NativeError)
    assert failure.args[2]["array"] == "forces"


def test_the_running_filter_refuses_arrays_that_do_not_fit() -> None:
    sections, states, signals = np.ones((2, 5)), np.zeros((3, 2, 2)), np.zeros((3, 4))
    _core.filter_on(sections, states, signals)
    for wrong in (
        (np.ones((2, 4)), states, signals),
        (sections, np.zeros((3, 1, 2)), signals),
        (sections, np.zeros((2, 2, 2)), signals),
        (np.ones((0, 5)), np.zeros((3, 0, 2)), signals),
    ):
        with pytest.raises(ValueError, match="sections are n × 5"):
            _core.filter_on(*wrong)
    _core.filter_on(sections, states, np.zeros((3, 0)))
