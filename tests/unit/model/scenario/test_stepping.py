"""Settings that a run takes where the solver settings leave them to `auto`."""

from math import sqrt
from typing import Any

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import Scenario, load, scenario_warnings
from arcless.model.scenario.stepping import LADDER, longest_step
from arcless.model.shipped.library import shipped

AC_SIMPLE = load("en50318-ac-simple-320-planar")
EXPLICIT, MATRIX = "central-difference", "generalised-alpha"


def taken(scenario: Scenario) -> tuple[str, str, float, float, float]:
    """Scheme, wire model, elements of contact and messenger wire in m, time step in s."""
    solver = scenario.stepping
    lengths = solver.contact_wire_element_m, solver.messenger_wire_element_m
    return (solver.scheme.name, solver.wires, *lengths, scenario.time_step_s)


def test_elements_follow_from_the_wave_ahead() -> None:
    # c = √(22 kN / 1.35 kg/m) = 127.66 m/s: (c − 88.89)/20 Hz = 1.94 m; a fifth is above 0.30.
    assert taken(AC_SIMPLE) == (EXPLICIT, "lumped", 0.3, 0.35, 1e-3)
    # 275 km/h: 2.56 m, an eighth of it is 0.32 m; a fifth of 2.44 m is 0.49 m, more than the most.
    assert taken(AC_SIMPLE.with_(speed="275 km/h"))[2:] == (0.3, 0.45, 1e-3)
    # 150 km/h: 4.3 m.
    assert taken(AC_SIMPLE.with_(speed="150 km/h"))[2:] == (0.45, 0.45, 1e-3)
    # A filter that lets more through needs more elements: 30 Hz, 1.29 m.
    finer = taken(AC_SIMPLE.with_(**{"analysis.low_pass": "30 Hz"}))
    assert finer[2] == 0.25 and finer[3] == 0.2


def test_above_seven_tenths_of_the_wave_speed_steps_are_shorter() -> None:
    # 0.42/(2π 20 Hz) (1 − v/c) at 380 km/h, 0.83 c: 0.58 ms.
    fast = AC_SIMPLE.with_(speed="380 km/h")
    assert taken(fast)[4] == 0.5e-3
    assert taken(fast)[0] == EXPLICIT


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"solver.kinematics": "updated"}, "updated kinematics"),
        ({"solver.wire_model": "hermite"}, "cubic elements"),
        ({"solver.residual_flexibility": True}, "residual flexibility"),
        ({"solver.time_step": "one element"}, "one element"),
        ({"solver.time_step": "4 ms"}, "4 ms is too long"),
        ({"solver.contact_wire_element": "0.72 m"}, "0.72 m is too long for point masses"),
        ({"solver.messenger_wire_element": "0.72 m"}, "0.72 m is too long for point masses"),
        ({"contact.law": "rigid"}, "rigid contact"),
    ],
)
def test_what_asks_for_a_matrix_gets_one(changes: dict[str, Any], why: str) -> None:
    changed = AC_SIMPLE.with_(**changes)
    assert changed.stepping.scheme.name == MATRIX
    assert why in changed.choice.why
    assert changed.choice.why in changed.choice.sentence


def test_a_rail_without_tension_takes_a_matrix() -> None:
    rail = load("conductor-rail-1-120")
    assert taken(rail) == (MATRIX, "hermite", 0.725, 0.725, 0.5e-3)
    assert "no tension" in rail.choice.why


def test_a_matrix_has_residual_flexibility_where_it_can() -> None:
    solved = AC_SIMPLE.with_(**{"solver.scheme": MATRIX})
    assert taken(solved) == (MATRIX, "hermite", 0.5, 0.5, 1e-3)
    assert solved.stepping.residual_flexibility is True
    without = solved.with_(**{"solver.residual_flexibility": False})
    assert without.stepping.residual_flexibility is False
    updated = AC_SIMPLE.with_(**{"solver.kinematics": "updated"})
    assert updated.stepping.residual_flexibility is False
    assert updated.stepping.contact_wire_element_m == 0.35


def test_a_trailing_pantograph_without_residual_flexibility_is_warned_of() -> None:
    off = {"solver.scheme": MATRIX, "solver.residual_flexibility": False}
    two = load("ac-simple-320-two-pantographs")

    def about(scenario: Scenario) -> list[str]:
        found = scenario_warnings(scenario)
        return [text for text in found if text.startswith("solver.residual_flexibility")]

    (text,) = about(two.with_(**off))
    assert "σ of a trailing pantograph is too low" in text
    assert about(two.with_(**{"solver.scheme": MATRIX})) == []
    assert about(two) == []  # point masses have it in their links
    # One pantograph, and kinematics that cannot have it, are not warned of.
    assert about(AC_SIMPLE.with_(**off)) == []
    assert about(two.with_(**{"solver.kinematics": "updated"})) == []


def test_what_is_given_stays() -> None:
    given = {"solver.contact_wire_element": 0.2, "solver.time_step": "0.5 ms"}
    assert taken(AC_SIMPLE.with_(**given)) == (EXPLICIT, "lumped", 0.2, 0.35, 0.5e-3)
    coarse = AC_SIMPLE.with_(**{"solver.scheme": EXPLICIT, "solver.contact_wire_element": 0.6})
    assert taken(coarse)[2] == 0.6
    (said,) = scenario_warnings(coarse)
    assert said.startswith("solver.contact_wire_element: 0.6 m is more than the 0.3 m that")


def test_elements_that_are_given_short_shorten_the_step() -> None:
    fine = AC_SIMPLE.with_(**{"solver.contact_wire_element": 0.15})
    # Bending and damping leave 0.47 ms of the 1.17 ms that a wave of 128 m/s takes; 0.9 of that.
    assert taken(fine)[4] == 0.4e-3
    finest = AC_SIMPLE.with_(**{"solver.contact_wire_element": 0.1})
    assert finest.stepping.scheme.name == MATRIX
    assert "shorter than 0.2 ms" in finest.choice.why


def test_masses_and_bridles_need_short_elements() -> None:
    mass = {"name": "clamp", "position": 300.0, "mass": "3 kg"}
    slow = AC_SIMPLE.with_(speed="150 km/h")
    assert taken(slow.with_(**{"line.point_masses": [mass]}))[2:4] == (0.3, 0.3)
    light = {**mass, "mass": "0.9 kg"}
    assert taken(slow.with_(**{"line.point_masses": [light]}))[2:4] == (0.45, 0.45)
    assert taken(load("trolley-bridles-60"))[2] == 0.2


def test_a_copy_with_other_settings_chooses_anew() -> None:
    assert AC_SIMPLE.stepping.scheme.name == EXPLICIT
    other = AC_SIMPLE.with_(**{"solver.scheme": MATRIX})
    copied = AC_SIMPLE.model_copy(update={"solver": other.solver})
    assert copied.stepping == other.stepping


@pytest.mark.parametrize("name", [n for n in shipped("scenario") if not n.startswith("praks")])
def test_shipped_scenarios_leave_the_choice_to_auto(name: str) -> None:
    scenario = load(name)
    assert scenario.solver.scheme.name == "auto"
    assert (scenario.stepping.scheme.name == MATRIX) == name.startswith("conductor-rail")
    assert scenario_warnings(scenario) == []


def test_the_longest_step_of_a_string_is_the_time_of_a_wave() -> None:
    # Without bending stiffness the filter leaves C = 1 exactly: (1 − C²)/12 is none.
    wire = AC_SIMPLE.line.contact_wire.model_copy(update={"bending_stiffness": 0.0})
    wire = wire.model_copy(
        update={"damping": wire.damping.model_copy(update={"beta": 0.0, "alpha": 0.0})}
    )
    speed = sqrt(wire.tension / wire.mass)
    # Halving 40 times leaves 1e-12.
    assert longest_step(wire, 0.45) == pytest.approx(0.45 / speed, rel=1e-9)


@pytest.mark.parametrize(
    "name", ["en50318-ac-simple-320-planar", "spain-ca-220-3kv-200", "germany-re-330-300"]
)
@pytest.mark.parametrize("length", LADDER[3:])
def test_steps_that_auto_takes_are_stable(name: str, length: float) -> None:
    """The core accepts the steps of the rule for elements of any length."""
    lengths = dict.fromkeys(
        ("solver.contact_wire_element", "solver.messenger_wire_element"), length
    )
    scenario = load(name).with_(
        **lengths,
        **{"solver.scheme": EXPLICIT, "line.spans": [{"type": "standard", "count": 5}]}
        | {"travel": {}, "analysis": {}},
    )
    arcless.simulate.runs.job.ready_line(scenario, lambda _share, _text: None)


def test_explicit_steps_on_a_rail_are_refused_with_what_helps() -> None:
    rail = load("conductor-rail-1-120")
    with pytest.raises(ModelError) as caught:
        rail.with_(**{"solver.scheme": {"name": "central-difference"}})
    text = str(caught.value)
    assert "explicit steps on a rail" in text
    assert "leave solver.scheme to auto" in text
    assert rail.with_(**{"solver.scheme": {"name": "auto"}}).choice.why
