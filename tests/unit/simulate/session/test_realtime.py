"""A line stepped from outside: the same steps as a run, places and speeds, and what is refused."""

import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from benchmarks.realtime import HEAD, idle, measure, row

import arcless
from arcless import ContactError, ModelError
from arcless.model import Scenario
from arcless.simulate import Realtime
from tests.support.explicit import EXPLICIT

Short = Callable[..., Scenario]
FORCE = 120.0
# Balance at the end of the step: what a run records of a step is what a loop then shows.
NEWMARK = {"solver.scheme": {"name": "newmark", "beta": 0.3025, "gamma": 0.6}}
GIVEN = {"pantographs.0.mean_force": None, "pantographs.0.static_force": FORCE}


def pushed(number: int) -> float:
    return 10.0 * float(np.sin(0.02 * number))


@pytest.fixture
def loop(short: Short) -> Realtime:
    return arcless.realtime(short(**GIVEN))


@pytest.mark.parametrize("steps", [NEWMARK, EXPLICIT], ids=["newmark", "explicit"])
def test_simulated_pantographs_are_those_of_a_run(short: Short, steps: dict[str, Any]) -> None:
    scenario = short(**GIVEN, **steps)
    law = {"P1": lambda sample: pushed(sample.sample_number)}
    run = arcless.run(scenario, controllers=law).dataset
    loop = arcless.realtime(scenario, simulated=True)
    for number in range(400):
        place = run["position"].values[number, 0]
        force = loop.step(pushed(number), position_m=place, speed_m_s=loop.speed_m_s)
        np.testing.assert_array_equal(force, run["contact_force"].values[number])
    # Both balance at the end of a step, where the loop is read: the sums are made in another
    # order, of heights of 5 m with a rounding of 1e-15.
    np.testing.assert_allclose(loop.height_m, run["contact_height"].values[399], atol=1e-12)
    moved = run["mass_displacement"].values[399, 0]
    # The same, of some tenths of a metre.
    np.testing.assert_allclose(loop.displacement_m, moved, atol=1e-12)
    assert loop.inputs == loop.contacts == ("P1",)
    assert loop.time_s == pytest.approx(400 * scenario.time_step_s)


def test_contact_forces_of_a_run_move_the_wire_as_in_the_run(short: Short) -> None:
    scenario = short(**GIVEN, **NEWMARK)
    run = arcless.run(scenario).dataset
    loop = arcless.realtime(scenario)
    np.testing.assert_allclose(loop.contact_force_N, FORCE)
    heights = [loop.step(forces).copy() for forces in run["contact_force"].values]
    # Rounding, which slack droppers let grow.
    np.testing.assert_allclose(heights, run["contact_height"].values, atol=1e-9)
    np.testing.assert_array_equal(loop.pantograph_force_N, loop.contact_force_N)


def test_two_strips_take_a_force_each(short: Short) -> None:
    head = {
        "strips": 2,
        "strip_spacing": "0.3 m",
        "half_length": "0.6 m",
        "mass": "3 kg",
        "stiffness": "5 kN/m",
        "damping": "10 N s/m",
    }
    loop = arcless.realtime(short(**GIVEN, **{"pantographs.0.model.head": head}))
    assert loop.inputs == ("P1 strip 1", "P1 strip 2")
    np.testing.assert_allclose(loop.contact_force_N, FORCE / 2)
    loop.step([50.0, 70.0])
    np.testing.assert_array_equal(loop.contact_force_N, [50.0, 70.0])
    np.testing.assert_array_equal(loop.pantograph_force_N, [120.0])


def test_place_and_speed_follow_from_one_another(loop: Realtime) -> None:
    start, h, speed = loop.position_m, loop.time_step_s, loop.speed_m_s
    loop.step(FORCE)
    assert (loop.position_m, loop.speed_m_s) == (pytest.approx(start + h * speed), speed)
    place = loop.position_m
    loop.step(FORCE, speed_m_s=speed + 1.0)
    assert loop.position_m == pytest.approx(place + h * (speed + 0.5))
    place = loop.position_m
    loop.step(FORCE, position_m=place + 0.05)
    assert loop.speed_m_s == pytest.approx(0.05 / h)
    loop.step(FORCE, position_m=place + 0.06, speed_m_s=3.0)
    assert (loop.position_m, loop.speed_m_s) == (place + 0.06, 3.0)
    assert loop.step_number == 4


def test_a_state_repeats_what_followed_it(loop: Realtime) -> None:
    def go() -> list[bytes]:
        return [loop.step(100.0 + pushed(i)).tobytes() for i in range(100)]

    go()
    saved = pickle.loads(pickle.dumps(loop.save()))
    shown = loop.height_m.copy()
    followed = go()
    loop.restore(saved)
    assert loop.step_number == 100
    np.testing.assert_array_equal(loop.height_m, shown)
    assert go() == followed


def test_states_of_others_are_refused(loop: Realtime, short: Short) -> None:
    other = arcless.realtime(short(**GIVEN), simulated=True)
    with pytest.raises(ModelError, match="of another loop"):
        loop.restore(other.save())
    saved = loop.save()
    saved.numbers["line_velocity"][0] = np.nan
    before = loop.step(FORCE).copy()
    with pytest.raises(ModelError, match=r"the state is damaged.*not finite"):
        loop.restore(saved)
    np.testing.assert_array_equal(loop.height_m, before)


@pytest.mark.parametrize("force", [[1.0, 2.0], [], "100 N", np.nan, None, [[1.0]]])
def test_wrong_forces_are_refused(loop: Realtime, force: Any) -> None:
    before = loop.height_m.copy()
    with pytest.raises(ModelError):
        loop.step(force)
    np.testing.assert_array_equal(loop.height_m, before)
    assert loop.step_number == 0


def test_a_loop_goes_on_after_leaving_the_wire(loop: Realtime) -> None:
    with pytest.raises(ContactError, match="step 0: pantograph P1 left the wire"):
        loop.step(FORCE, position_m=1e4)
    loop.step(FORCE)
    assert loop.step_number == 1


REFUSED: list[tuple[dict[str, Any], bool, str]] = [
    ({"pantographs.0.mean_force": FORCE}, True, "mean_force"),
    ({**GIVEN, "solver.kinematics": "updated", "solver.wire_model": "lumped"}, False, "kinematics"),
    (
        {
            **GIVEN,
            "pantographs.0.roof_motion": {"time": [0, 9], "displacement": [0.0, 0.1]},
        },
        True,
        "roof_motion",
    ),
]


@pytest.mark.parametrize(("changes", "simulated", "field"), REFUSED)
def test_what_a_loop_cannot_do(
    short: Short, changes: dict[str, Any], simulated: bool, field: str
) -> None:
    with pytest.raises(ModelError, match="not in a real-time loop") as refused:
        arcless.realtime(short(**changes), simulated=simulated)
    assert field in str(refused.value.where)


@pytest.mark.parametrize("scheme", ["central-difference", "generalised-alpha"])
def test_the_rate_is_the_slope_of_the_height(scheme: str) -> None:
    # No dropper goes slack: that would be a jump of the acceleration.
    changes = {"pantographs.0.mean_force": None, "pantographs.0.static_force": "40 N"}
    scenario = arcless.load("en50318-ac-simple-320-planar").with_(
        **changes, **{"solver.scheme": scheme}
    )
    loop = arcless.realtime(scenario)
    place, step, omega = loop.position_m, loop.time_step_s, 10.0 * np.pi
    height, rate = np.zeros((2, 500))
    for n in range(500):
        loop.step(40.0 + 15.0 * (1.0 - np.cos(omega * step * n)), position_m=place)
        height[n], rate[n] = loop.height_m[0], loop.height_rate_m_s[0]
    slope = (height[2:] - height[:-2]) / (2.0 * step)
    # Of a difference over two steps (ωh)²/6: 1.6e-4 of 5 Hz, 2.6e-3 of 20 Hz, which droppers send
    # back; half a step off ωh/2 = 1.6 %.
    assert np.abs(rate[1:-1] - slope)[100:].max() < 3e-3 * np.abs(rate).max()


def test_several_contact_wires_need_simulated_pantographs() -> None:
    scenario = arcless.load("ac-simple-overlap-275").with_(**GIVEN)
    with pytest.raises(ModelError, match="simulated=True"):
        arcless.realtime(scenario)
    loop = arcless.realtime(scenario, simulated=True)
    assert len(loop.contacts) == 2
    assert loop.step(0.0).shape == (1,)


def test_single_steps_are_timed(loop: Realtime) -> None:
    wall, own, least = measure(loop, 30)
    assert wall.shape == own.shape == least.shape == (30,)
    assert (least == wall).all()
    assert loop.step_number == 30
    assert len(row("steps", wall)) == len(HEAD)
    assert (idle(100.0) > 0.0).all()


def test_the_least_of_equal_steps(loop: Realtime) -> None:
    length = 9.5 * loop.speed_m_s * loop.time_step_s
    wall, _, least = measure(loop, 25, length)
    assert loop.step_number == 5  # of the third round
    rounds = [wall[at : at + 10] for at in (0, 10, 20)]
    assert least == pytest.approx([min(r[k] for r in rounds if k < len(r)) for k in range(10)])


def test_the_line_is_where_the_wire_is_read() -> None:
    """Nodes on both sides of the collector have the height of the wire there, less its kink."""
    static = {"pantographs.0.mean_force": None, "pantographs.0.static_force": "170 N"}
    scenario = arcless.load("en50318-ac-simple-320-planar").with_(**static)
    loop = arcless.realtime(scenario, simulated=True)
    mesh = arcless.statics(scenario).equilibrium
    (wire,) = mesh.mesh.contact_wires
    x, z = mesh.positions[wire, 0], mesh.positions[wire, 2]
    assert np.all(loop.line_displacement_m()[:, -1] < 0.2)
    off, moved = [], []
    for number in range(1500):
        loop.step(0.0)
        if number % 50 == 0 and number > 500:
            up = loop.line_displacement_m()[wire, -1]
            off.append(np.interp(loop.position_m, x, z + up) - loop.height_m[0])
            moved.append(np.ptp(up))
    assert min(moved) > 0.03
    # The kink of 250 N in an element of 0.45 m under 20 kN is 250 N 0.45 m / (4 20 kN) = 1.4 mm,
    # half of it on the average; a millisecond of 0.5 m/s is 0.5 mm more.
    assert np.abs(off).max() < 1.5e-3
