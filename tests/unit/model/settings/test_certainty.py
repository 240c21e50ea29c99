"""Asking how sure a number is, and the other family of elements."""

from typing import Any

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import Scenario, json_schema, library, load
from arcless.model.scenario.other_family import other_family
from tests.support.explicit import BY_MATRIX

SCENARIOS = [entry.name for entry in library() if entry.kind == "scenario"]


def test_a_number_alone_is_that_of_starts() -> None:
    shipped = load("en50318-ac-simple-320-planar")
    assert shipped.certainty is None
    asked = load({**shipped.to_dict(), "certainty": 5}).certainty
    assert asked is not None
    assert (asked.starts, asked.other_family) == (5, True)
    given = shipped.with_(certainty={"starts": 4, "other_family": False})
    assert load(given.to_dict()) == given
    assert given.with_(certainty=None).certainty is None


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (0, "greater than or equal to 2"),
        (1, "greater than or equal to 2"),
        (-3, "greater than or equal to 2"),
        (10**9, "less than or equal to 100"),
        (2.5, "a whole number"),
        (float("nan"), "a whole number"),
        ("many", "a whole number"),
        (True, "a whole number"),
        ([8], "a whole number"),
        ({"starts": 8, "times": 3}, "certainty"),
        ({"starts": 8, "other_family": "yes"}, "true or false"),
    ],
)
def test_what_is_no_number_of_starts_is_refused(given: Any, expected: str) -> None:
    with pytest.raises(ModelError) as caught:
        load("en50318-ac-simple-320-planar").with_(certainty=given)
    assert "certainty" in str(caught.value)
    assert expected in str(caught.value)


def test_the_schema_takes_both_forms() -> None:
    field = json_schema()["$defs"]["Scenario"]["properties"]["certainty"]
    assert {"type": "integer", "minimum": 2, "maximum": 100} in field["anyOf"][0]["anyOf"]


@pytest.mark.parametrize("name", SCENARIOS)
def test_the_other_family_is_another_one_and_valid(name: str) -> None:
    scenario = load(name)
    other = other_family(scenario)
    assert load(other.to_dict()) == other
    assert other.time_step_s <= 0.5 * scenario.time_step_s * (1 + 1e-12)
    own, there = scenario.stepping, other.solver
    assert there.kinematics == own.kinematics
    if scenario.line.wave_speed is not None:
        assert there.wires != own.wires
    else:  # a rail without tension is no chain
        assert there.wires == own.wires == "hermite"
        assert there.contact_wire_element_m <= 0.5 * own.contact_wire_element_m
    rate, its_rate = (s.output.contact_every * s.time_step_s for s in (scenario, other))
    assert its_rate == pytest.approx(rate, rel=1e-12)


def test_cubic_elements_are_refined_where_a_line_refuses_chains() -> None:
    cubic = BY_MATRIX | {"solver.contact_wire_element": 0.75}
    scenario = load("germany-re-330-300").with_(**cubic)
    other = other_family(scenario, chains=False)
    assert (other.solver.wires, other.solver.residual_flexibility) == ("hermite", True)
    assert other.solver.contact_wire_element_m == 0.375
    assert other.solver.messenger_wire_element_m == 0.725
    assert other.time_step_s == 5e-4


def test_the_finest_elements_stay_allowed() -> None:
    finest = {"contact_wire_element": 0.05, "messenger_wire_element": 0.05, "time_step": 1e-5}
    scenario = arcless.load("germany-re-330-300").with_(
        **{f"solver.{name}": value for name, value in finest.items()},
        **{"travel.end": "700 m", "analysis": {"from": "200 m", "to": "600 m"}},
    )
    other = other_family(scenario)
    assert isinstance(load(other.to_dict()), Scenario)
    assert other.time_step_s == 1e-5


def test_rigid_contact_gets_a_scheme_that_does_not_ring() -> None:
    rigid = load("en50318-ac-simple-320-planar").with_(**{"contact.law": "rigid"})
    for family, wires in ("auto", "lumped"), ("lumped", "hermite"):
        own = rigid.with_(**{"solver.wire_model": family, "solver.scheme": "generalised-alpha"})
        other = other_family(own).solver
        assert other.wires == wires
        assert other.scheme.name == "generalised-alpha"
        assert other.scheme.spectral_radius == 0.0
