"""An FMU takes the steps of the loop inside, bit for bit; states, and steps of other lengths."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from tests.support.explicit import EXPLICIT
from tests.support.exported import Driven, Failed, driven
from tests.unit.fmi.conftest import GIVEN, Short

Fmu = Callable[..., Path]


def pushed(number: int) -> float:
    return 40.0 * float(np.sin(0.02 * number))


def faster(number: int) -> float:
    return 80.0 + 2.0 * float(np.sin(0.01 * number))


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("changes", [{}, EXPLICIT], ids=["implicit", "explicit"])
def test_pantographs_inside_are_those_of_the_loop(
    short: Short, fmu: Fmu, version: int, changes: dict[str, Any]
) -> None:
    scenario = short(**GIVEN, **changes)
    loop = arcless.realtime(scenario, simulated=True)
    with driven(fmu(version, of=scenario, given="control-force")) as run:
        for number in range(400):
            expected = loop.step(pushed(number), speed_m_s=faster(number))
            run.put({"P1.control_force": pushed(number), "speed": faster(number)})
            run.step()
            found = run.get("P1.contact_force", "P1.wire_height", "P1.wire_velocity", "position")
            assert found == [
                expected[0],
                loop.height_m[0],
                loop.height_rate_m_s[0],
                loop.position_m,
            ]
        names = [f"P1.mass_{k}.{what}" for what in ("displacement", "velocity") for k in (1, 2, 3)]
        found = run.get(*[name for name in names if name in run.numbers])
        assert found == [*loop.displacement_m, *loop.velocity_m_s]


def test_forces_from_outside_are_those_of_the_loop(short: Short, fmu: Fmu) -> None:
    scenario = short(**GIVEN)
    loop = arcless.realtime(scenario)
    place = loop.position_m
    with driven(fmu(2, travel="position", supports=("support 3",))) as run:
        highest = 0.0
        for number in range(400):
            force, place = 120.0 + pushed(number), place + 0.08
            loop.step(force, position_m=place)
            run.put({"P1.contact_force": force, "position": place})
            run.step()
            assert run.get("P1.wire_height", "speed") == [loop.height_m[0], loop.speed_m_s]
            highest = max(highest, run.value("support_3.uplift"))
        assert 0.01 < highest < 0.3


def _go(run: Driven, steps: int) -> list[list[float]]:
    seen = []
    for _ in range(steps):
        run.put({"P1.control_force": pushed(run.steps)})
        run.step()
        seen.append(run.get(*run.outputs()))
    return seen


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("choice", [{"given": "control-force"}, {"pantograph": "P1"}], ids=repr)
def test_a_state_put_back_repeats_what_followed(
    fmu: Fmu, version: int, choice: dict[str, Any]
) -> None:
    save, restore, serialise, revive, free = (
        ("getFMUState", "setFMUState", "serializeFMUState", "deserializeFMUState", "freeFMUState")
        if version == 3
        else (
            "getFMUstate",
            "setFMUstate",
            "serializeFMUstate",
            "deSerializeFMUstate",
            "freeFMUstate",
        )
    )
    name = "contact_force" if "pantograph" in choice else "P1.control_force"
    with driven(fmu(version, **choice)) as run:

        def go(steps: int) -> list[list[float]]:
            seen = []
            for _ in range(steps):
                run.put({name: 100.0 + pushed(run.steps)})
                run.step()
                seen.append(run.get(*run.outputs()))
            return seen

        first = go(100)
        state = run.attempt(save)
        second = go(100)
        bytes_ = run.attempt(serialise, state)
        run.attempt(restore, state)
        run.steps = 100
        assert go(100) == second
        run.attempt("reset")
        run._begin(0.0)
        run.steps = 0
        assert go(100) == first
        again = run.attempt(revive, bytes_)
        run.attempt(restore, again)
        run.steps = 100
        assert run.value("time") == pytest.approx(run.time)
        assert go(100) == second
        for each in (state, again):
            run.attempt(free, each)


def test_a_state_goes_to_another_instance_of_the_same_model_alone(fmu: Fmu) -> None:
    with driven(fmu(2, given="control-force")) as one, driven(fmu(2, given="control-force")) as two:
        _go(one, 50)
        bytes_ = one.attempt("serializeFMUstate", one.attempt("getFMUstate"))
        two.attempt("setFMUstate", two.attempt("deSerializeFMUstate", bytes_))
        two.steps = 50
        assert _go(two, 50) == _go(one, 50)
    with driven(fmu(2)) as other:
        foreign = other.attempt("deSerializeFMUstate", bytes_)
        with pytest.raises(Failed, match="a state is restored at t = 0 s: it is of another model"):
            other.attempt("setFMUstate", foreign)
        damaged = other.attempt("deSerializeFMUstate", bytes_[:50])
        with pytest.raises(Failed, match="it is damaged, or none"):
            other.attempt("setFMUstate", damaged)


def test_a_long_communication_step_is_cut_into_whole_ones(fmu: Fmu) -> None:
    path = fmu(2, given="control-force")
    with driven(path) as short_steps, driven(path) as long_steps:
        for number in range(20):
            for run in (short_steps, long_steps):
                run.put({"P1.control_force": pushed(number)})
            for _ in range(10):
                short_steps.step()
            # As importers do, by differences of times.
            begin = long_steps.time
            long_steps.step((begin + 10 * long_steps.h) - begin)
            names = short_steps.outputs()
            assert long_steps.get(*names) == short_steps.get(*names)


def test_a_position_is_reached_evenly(fmu: Fmu) -> None:
    """In a long step the train moves on evenly, so the speed is that of its mean."""
    with driven(fmu(2, given="control-force", travel="position")) as run:
        place, h = 50.0, run.h
        for number in range(1, 30):
            run.put({"position": 50.0 + 0.4 * number})
            run.step(5 * h)
            place += 0.4
            # Rounding of positions of 60 m over a step of 1 ms.
            assert run.value("speed") == pytest.approx(0.4 / (5 * h), abs=1e-9)


def test_time_may_start_elsewhere(fmu: Fmu) -> None:
    for version in (2, 3):
        with driven(fmu(version, given="control-force"), start_time=12.5) as run:
            seen = _go(run, 20)
            assert run.value("time") == pytest.approx(12.5 + 20 * run.h)
        with driven(fmu(version, given="control-force")) as run:
            assert _go(run, 20) == seen
