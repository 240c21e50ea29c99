"""What a solver takes for `auto`."""

import json
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import Solver, load, scenario_warnings

SHIPPED = load("en50318-ac-simple-320")
# By a matrix, as scenarios are that name no scheme.
SCENARIO = SHIPPED.with_(**{"solver.scheme": "generalised-alpha"})
FIELDS = ("wire_model", "contact_wire_element", "messenger_wire_element")
EXPLICIT = {"solver.scheme": "central-difference"}
BY_MATRIX = (
    "generalised-alpha", "hht", "trapezoidal", "backward-difference",
    {"name": "newmark", "beta": 0.25},
)  # fmt: skip


def taken(solver: Solver) -> tuple[str, float, float]:
    """Wire model, elements of contact and messenger wire in m."""
    return solver.wires, solver.contact_wire_element_m, solver.messenger_wire_element_m


def given(solver: Solver) -> tuple[Any, ...]:
    """What the fields say."""
    return tuple(getattr(solver, name) for name in FIELDS)


@pytest.mark.parametrize("scheme", BY_MATRIX)
def test_elements_of_schemes_with_a_matrix(scheme: Any) -> None:
    changed = SCENARIO.with_(**{"solver.scheme": scheme})
    assert taken(changed.solver) == ("hermite", 1.45, 2.9)
    # Point masses that are solved for keep the lengths of cubic elements.
    lumped = changed.with_(**{"solver.wire_model": "lumped"})
    assert taken(lumped.solver) == ("lumped", 1.45, 2.9)


def test_one_setting_makes_steps_explicit() -> None:
    changed = SCENARIO.with_(**EXPLICIT)
    assert taken(changed.solver) == ("lumped", 0.45, 0.6)
    assert scenario_warnings(changed) == []
    # And one takes them back.
    assert changed.with_(**{"solver.scheme": "generalised-alpha"}).solver == SCENARIO.solver


def test_what_is_given_is_kept() -> None:
    own = load("en50318-2002-250")
    assert taken(own.solver) == ("hermite", 0.8, 1.6)
    assert taken(own.with_(**EXPLICIT).solver) == ("lumped", 0.8, 1.6)
    one = SCENARIO.with_(**EXPLICIT, **{"solver.messenger_wire_element": "0.9 m"})
    assert taken(one.solver) == ("lumped", 0.45, 0.9)
    left = own.with_(**EXPLICIT, **dict.fromkeys((f"solver.{name}" for name in FIELDS[1:]), "auto"))
    assert taken(left.solver) == ("lumped", 0.45, 0.6)


def test_cubic_elements_with_explicit_steps_are_refused() -> None:
    with pytest.raises(ModelError, match=r"solver\.wire_model: not together with the scheme"):
        SCENARIO.with_(**EXPLICIT, **{"solver.wire_model": "hermite"})
    cubic = SCENARIO.with_(**{"solver.wire_model": "hermite"})
    with pytest.raises(ModelError, match="leave it out: auto takes what the scheme needs"):
        cubic.with_(**EXPLICIT)


@pytest.mark.parametrize("changes", [{}, EXPLICIT])
def test_the_word_survives_plain_data(changes: dict[str, Any]) -> None:
    changed = SCENARIO.with_(**changes)
    assert given(changed.solver) == ("auto", "auto", "auto")
    again = load(json.loads(json.dumps(changed.to_dict())))
    assert again == changed
    assert given(again.with_(speed="300 km/h").solver) == ("auto", "auto", "auto")


@pytest.mark.parametrize("changes", [{}, EXPLICIT])
def test_resolved_settings_are_those_with_the_numbers_given(changes: dict[str, Any]) -> None:
    left = SCENARIO.with_(**changes)
    numbers = dict(zip((f"solver.{name}" for name in FIELDS), taken(left.solver), strict=True))
    written = left.with_(**numbers)
    assert written.solver != left.solver
    assert written.solver == left.solver.resolved == written.solver.resolved
    assert given(left.solver.resolved) == taken(left.solver)


def test_ac_simple_is_shipped_with_explicit_steps() -> None:
    assert taken(SHIPPED.solver) == ("lumped", 0.45, 0.6)
    assert SCENARIO.with_(**EXPLICIT).solver == SHIPPED.solver


def test_the_step_of_one_element_follows_the_scheme() -> None:
    slow = SCENARIO.with_(speed=100.0, **{"solver.time_step": "one element"})
    assert slow.time_step_s == 1.45 / 100.0
    assert slow.with_(**EXPLICIT).time_step_s == 0.45 / 100.0
