"""Travel, pantographs and scheme numbers."""

from collections.abc import Callable
from math import inf

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.model import Scenario, load_pantograph
from arcless.model.settings.schemes import (
    BackwardDifference,
    GeneralisedAlpha,
    HilberHughesTaylor,
    Newmark,
    Trapezoidal,
)
from arcless.simulate.setup import pantographs, trajectory

Short = Callable[..., Scenario]


def test_constant_speed_is_exact(short: Short) -> None:
    travel = trajectory.motion(short(speed=40.0))
    steps = np.arange(travel.steps + 1)
    np.testing.assert_array_equal(travel.positions, 50.0 + 40.0 * (steps * 2e-3))
    np.testing.assert_array_equal(travel.speeds, 40.0)
    assert travel.steps == 1875  # 150 m at 0.08 m a step
    assert travel.positions[-1] == pytest.approx(200.0, abs=1e-9)
    assert travel.duration == pytest.approx(3.75)


def test_travel_never_passes_its_end(short: Short) -> None:
    travel = trajectory.motion(short(speed=44.5))
    assert 200.0 - 44.5 * 2e-3 < travel.positions[-1] <= 200.0


def test_speed_profile_is_integrated_exactly(short: Short) -> None:
    times, speeds = [0.0, 1.3, 2.0, 4.1], [20.0, 45.0, 45.0, 10.0]
    travel = trajectory.motion(
        short(speed_profile={"time": times, "speed": speeds}, analysis={"from": 55, "to": 100})
    )
    at = travel.time_step * np.arange(travel.steps + 1)
    # The same interpolation at times that differ in the last bit.
    np.testing.assert_allclose(travel.speeds, np.interp(at, times, speeds), rtol=1e-14)
    # The trapezoidal rule is exact between knots, and knots are points of this grid.
    grid = np.unique(np.concatenate([np.linspace(0.0, 4.1, 4101), times]))
    v = np.interp(grid, times, speeds)
    distance = np.concatenate([[0.0], np.cumsum(np.diff(grid) * (v[1:] + v[:-1]) / 2)])
    # Between grid points the distance is a parabola; 1e-5 m is a·h²/8 for 1 ms and 36 m/s².
    np.testing.assert_allclose(travel.positions, 50.0 + np.interp(at, grid, distance), atol=1e-5)


def test_speed_profile_ends_at_the_end_of_the_travel(short: Short) -> None:
    profile = {"time": [0.0, 100.0], "speed": [30.0, 30.0]}
    travel = trajectory.motion(short(speed_profile=profile))
    assert 200.0 - 30.0 * 2e-3 <= travel.positions[-1] <= 200.0


def test_a_standing_train_takes_no_step(short: Short) -> None:
    profile = {"time": [0.0, 1.0, 1e4], "speed": [0.0, 0.0, 50.0]}
    travel = trajectory.motion(short(speed_profile=profile))
    assert travel.positions[0] == travel.positions[1] == 50.0
    assert np.all(np.diff(travel.positions) >= 0)


def test_too_many_steps_are_refused(short: Short) -> None:
    # Whether the scenario or the travel notices first is not promised, the message is.
    with pytest.raises(ModelError, match=r"time steps: got .*1\.5e\+07, expected"):
        trajectory.motion(short(speed=1.0, **{"solver.time_step": 1e-5}))


def test_a_travel_shorter_than_a_step_is_refused(short: Short) -> None:
    travel = {"travel": {"start": "50 m", "end": "50.05 m"}, "analysis": {}}
    with pytest.raises(ModelError, match=r"number of time steps: got 0\.\d+, expected 1 to"):
        trajectory.motion(short(**travel))


def test_matrices_of_a_chain() -> None:
    pantograph = load_pantograph("ac-simple")
    made = pantographs.data(pantograph, 160.0)
    np.testing.assert_array_equal(np.reshape(made.mass, (3, 3)), np.diag([6.0, 9.0, 7.5]))
    expected = [[160 + 15500, -15500, 0], [-15500, 15500 + 7000, -7000], [0, -7000, 7000]]
    np.testing.assert_array_equal(np.reshape(made.stiffness, (3, 3)), expected)
    expected = [[100.1, -0.1, 0], [-0.1, 45.1, -45], [0, -45, 45]]
    np.testing.assert_allclose(np.reshape(made.damping, (3, 3)), expected)
    # One strip: in the middle, of any length, everywhere at the height of the last mass.
    (strip,) = made.strips
    assert (strip.offset, strip.half_width) == (0.0, inf)
    assert (strip.knots, strip.vectors) == ([0.0], [[0, 0, 1]])
    assert (made.preload, made.lift) == ([1, 0, 0], [0, 0, 0])
    assert made.start_force == 160.0


def test_frequencies_of_a_pantograph_are_those_of_the_data_sheet() -> None:
    pantograph = load_pantograph("en50318-2002")
    made = pantographs.data(pantograph, 120.0)
    m, k = np.reshape(made.mass, (2, 2)), np.reshape(made.stiffness, (2, 2))
    found = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(m, k)))) / (2 * np.pi)
    # Printed with two decimals in the reference data.
    np.testing.assert_allclose(found, [0.24, 4.68], atol=0.005)


def test_schemes_go_to_the_core_by_name_and_parameters() -> None:
    radius = GeneralisedAlpha(name="generalised-alpha", spectral_radius=0.7)
    assert trajectory.scheme_numbers(radius) == ("generalised-alpha", [0.7])
    # Files count alpha from -1/3 to 0, as in the textbooks; the core counts its amount.
    hht = HilberHughesTaylor(name="hht", alpha=-0.05)
    assert trajectory.scheme_numbers(hht) == ("hht", [0.05])
    newmark = Newmark(name="newmark", beta=0.3, gamma=0.55)
    assert trajectory.scheme_numbers(newmark) == ("newmark", [0.3, 0.55])
    assert trajectory.scheme_numbers(Trapezoidal(name="trapezoidal")) == ("trapezoidal", [])
    backward = BackwardDifference(name="backward-difference")
    assert trajectory.scheme_numbers(backward) == ("backward-difference", [])


def test_rigid_contact_has_no_compliance(short: Short) -> None:
    assert trajectory.contact_stiffness(short()) == 50e3
    assert trajectory.contact_stiffness(short(**{"contact.law": "rigid"})) == inf
