"""A session: added forces are found at the contact, and the wires that are sent are the line."""

import struct

import numpy as np
import pytest

import arcless
from arcless import ModelError
from arcless.model import Scenario
from arcless.studio.hands_on.clock import MOST_LAG, Clock
from arcless.studio.hands_on.frames import channels, packed
from arcless.studio.hands_on.gusts import STATED_LIFT, Gust
from arcless.studio.hands_on.session import Session

OFFSET = 30.0
# Force in N that mass times change of velocity may take in the time that is averaged: 20 kg and
# 0.3 m/s in 6 s are 1 N. Without the base spring of 160 N/m, 2 N would be missing.
OF_MOMENTUM = 1.0
BASE_SPRING = 160.0


@pytest.fixture(scope="module")
def scenario() -> Scenario:
    found: Scenario = arcless.load("en50318-ac-simple-275-planar")
    return found.with_(**{"pantographs.0.mean_force": None, "pantographs.0.static_force": 120.0})


def mean_force(session: Session, steps: int) -> tuple[float, float]:
    """Return mean contact force in N and mean displacement of the lowest mass in m."""
    rows = np.empty((steps, 2))
    for row in rows:
        session.step()
        row[:] = session.moment(1.0).pantographs[0][[1, 4]]
    return tuple(rows.mean(axis=0))


def test_an_offset_is_what_the_mean_force_gains(scenario: Scenario) -> None:
    plain, pushed = Session(scenario), Session(scenario)
    pushed.offset(0, OFFSET)
    steps = 6000
    (force, place), (other, higher) = (mean_force(one, steps) for one in (plain, pushed))
    gained = other - force + BASE_SPRING * (higher - place)
    assert gained == pytest.approx(OFFSET, abs=OF_MOMENTUM)


def test_a_gust_gives_its_impulse(scenario: Scenario) -> None:
    session, gust = Session(scenario), Gust(10.0, 0.5)
    session.gust(gust)
    added = []
    for _ in range(600):
        added.append(float(session.added_N()[0]))
        session.step()
    # Steps of 1 ms of a smooth course; it begins and ends level, so that only rounding is left.
    assert sum(added) * 1e-3 == pytest.approx(0.5 * STATED_LIFT * 0.5, rel=1e-9)
    assert added[-1] == 0.0


def test_at_the_end_of_the_travel_it_begins_anew_and_is_the_same(scenario: Scenario) -> None:
    short = scenario.with_(
        travel={"start": 300.0, "end": 310.0}, analysis={"from": 301.0, "to": 309.0}
    )
    session = Session(short)
    steps = session.steps_of_travel
    first = [_stepped(session) for _ in range(steps)]
    again = [_stepped(session) for _ in range(steps)]
    assert session.laps == 1
    assert first == again  # bit for bit, as the state is restored
    assert session.time_s == pytest.approx(2 * steps * 1e-3)


def _stepped(session: Session) -> float:
    session.step()
    return float(session.moment(1.0).pantographs[0][1])


def test_the_wire_that_is_sent_is_where_the_contact_is(scenario: Scenario) -> None:
    session = Session(scenario)
    for _ in range(1500):
        session.step()
    moment, geometry = session.moment(50.0), session.geometry
    first, up, across = moment.wires[0]
    assert across is None
    wire = geometry["wires"][0]
    x = np.array(wire["x"])[first : first + len(up)]
    z = np.array(wire["z"])[first : first + len(up)] + up
    assert x[0] >= moment.position_m - 50.0
    assert x[-1] <= moment.position_m + 50.0
    height = np.interp(moment.position_m, x, z)
    # The contact sags between nodes by what is below the mesh: 0.25 mm here. A node that was not
    # followed would be centimetres away.
    assert height == pytest.approx(moment.pantographs[0][2], abs=5e-4)
    # Neighbours are 0.3 m apart and the steepest wave has some per cent: no node is left behind.
    assert np.abs(np.diff(up)).max() < 5e-3


def test_a_mean_force_is_taken_as_a_static_one_and_that_is_said() -> None:
    session = Session(arcless.load("en50318-ac-simple-275-planar"))
    assert session.static_force_N == pytest.approx([143.4])
    assert any("found by whole runs" in note for note in session.notes)


def test_frames_are_read_as_they_are_written(scenario: Scenario) -> None:
    session = Session(scenario)
    session.step()
    moment = session.moment(100.0)
    names = {one["number"]: one["name"] for one in channels(session, 2, spatial=False)}
    frames = packed(moment)
    heads = [struct.unpack_from("<IId", frame) for frame in frames]
    assert [names[channel] for channel, _, _ in heads] == ["wire.0.up", "wire.1.up", "pantograph.0"]
    assert {time for _, _, time in heads} == {moment.time_s}
    values = np.frombuffer(frames[-1], dtype="<f4", offset=16)
    np.testing.assert_allclose(values, moment.pantographs[0], rtol=1e-6)  # singles
    assert heads[0][1] == moment.wires[0][0]


@pytest.mark.parametrize("given", [(1, 10.0), (-1, 10.0), (True, 10.0), (0, 1e4), (0, "5"),
                                   (0, float("inf"))])  # fmt: skip
def test_an_offset_that_is_none_is_refused(
    scenario: Scenario, given: tuple[object, object]
) -> None:
    session = Session(scenario)
    with pytest.raises(ModelError):
        session.offset(*given)
    assert not session.offset_N.any()


def test_a_slow_machine_slows_the_session_and_piles_nothing_up() -> None:
    clock = Clock(0.5)
    clock.begin(wall=10.0, time=2.0)
    assert clock.due(12.0) == pytest.approx(3.0)
    # It kept pace within the lag: nothing is given up.
    clock.give_up_lag(12.0, 3.0 - 0.4 * MOST_LAG)
    assert clock.due(12.0) == pytest.approx(3.0)
    clock.give_up_lag(12.0, 2.5)
    assert clock.due(12.0) == pytest.approx(2.5)
    assert clock.pace(12.0, 2.5) == pytest.approx(0.25)
    assert clock.pace(12.1, 2.55) is None
