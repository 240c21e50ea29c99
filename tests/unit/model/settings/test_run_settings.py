"""Solver settings: their fields, and their refusals."""

import json
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import Solver, load

SHIPPED = load("en50318-ac-simple-320-planar")
MATRIX = {"solver.scheme": "generalised-alpha"}
SCENARIO = SHIPPED.with_(**MATRIX)
FIELDS = ("wire_model", "contact_wire_element", "messenger_wire_element", "time_step")
EXPLICIT = {"solver.scheme": "central-difference"}


def given(solver: Solver) -> tuple[Any, ...]:
    """Return the values of the fields."""
    return tuple(getattr(solver, name) for name in FIELDS)


def test_cubic_elements_with_explicit_steps_are_refused() -> None:
    with pytest.raises(ModelError, match=r"solver\.wire_model: not together with the scheme"):
        SCENARIO.with_(**EXPLICIT, **{"solver.wire_model": "hermite"})
    cubic = SCENARIO.with_(**{"solver.wire_model": "hermite"})
    with pytest.raises(ModelError, match="leave it out: auto takes what the scheme needs"):
        cubic.with_(**EXPLICIT)


def test_explicit_steps_without_residual_flexibility_are_refused() -> None:
    with pytest.raises(ModelError, match="explicit steps always have it"):
        SCENARIO.with_(**EXPLICIT, **{"solver.residual_flexibility": False})
    assert SCENARIO.with_(**EXPLICIT, **{"solver.residual_flexibility": True})


@pytest.mark.parametrize("changes", [{}, MATRIX, EXPLICIT])
def test_the_word_survives_plain_data(changes: dict[str, Any]) -> None:
    changed = SHIPPED.with_(**changes)
    assert given(changed.solver) == ("auto",) * 4
    again = load(json.loads(json.dumps(changed.to_dict())))
    assert again == changed
    assert again.stepping == changed.stepping
    assert given(again.with_(speed="300 km/h").solver) == ("auto",) * 4


def test_the_step_of_one_element_follows_the_elements() -> None:
    slow = SCENARIO.with_(speed=100.0, **{"solver.time_step": "one element"})
    assert slow.time_step_s == slow.stepping.contact_wire_element_m / 100.0
