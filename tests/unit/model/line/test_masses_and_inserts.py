"""Masses, inserts, midpoint anchors, tensioning springs: what is refused."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load_line
from tests.support.line_types import compound_data, stitched_data
from tests.support.simple_lines import trolley_data

INSERT = {"position": 50.0, "length": 2.0, "mass": 9.0, "axial_stiffness": 2e7}
INSULATOR = {**INSERT, "name": "section insulator", "bending_stiffness": 3e3}
ANCHOR = {"stiffness": 1e6}


def refusal(data: dict[str, Any]) -> str:
    with pytest.raises(ModelError) as caught:
        load_line(data)
    return str(caught.value)


def test_round_trip() -> None:
    line = load_line(
        compound_data(
            point_masses=[{"wire": "auxiliary_wire", "position": 4.0, "mass": 1.0}],
            inserts=[INSULATOR],
            contact_wire__ends="spring",
            contact_wire__end_stiffness=2e4,
            messenger_wire__ends="constant_force",
            auxiliary_wire__ends="constant_force",
            midpoint_anchor=ANCHOR,
        )
    )
    assert load_line(line.to_dict()) == line


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"point_masses": [{"wire": "auxiliary_wire", "position": 4.0, "mass": 1.0}]},
            "point_masses.0.wire: mass on a wire that the line does not have: got auxiliary_wire,"
            " expected one of: contact_wire",
        ),
        (
            {"point_masses": [{"position": 401.0, "mass": 1.0}]},
            "point_masses.0.position: mass outside the wires: got 401 m, expected a place on one"
            " wire between 0 and 400 m",
        ),
        (
            {"inserts": [{**INSULATOR, "position": 399.5}]},
            "inserts.0.position: section insulator outside the wires: got 398.5 m to 400.5 m,"
            " expected a place on one wire between 0 and 400 m",
        ),
        (
            {"inserts": [INSULATOR, {**INSULATOR, "position": 51.9}]},
            "inserts.1.position: inserts overlap: got 50.9 m to 52.9 m, and inserts.0 49 m to 51 m,"
            " expected inserts one behind the other",
        ),
        (
            {"inserts": [{**INSULATOR, "tension_length": 2}]},
            "inserts.0.tension_length: section insulator outside its tension length: got tension"
            " length 2 at 50 m, expected tension_length: 1",
        ),
        (
            {"inserts": [{**INSULATOR, "mass": 0}]},
            "inserts.0.mass: got 0, expected a mass (kg, g, t, lb), above 0 kg and at most 1e+06"
            " kg",
        ),
        (
            {"inserts": [INSERT]},
            "inserts.0.bending_stiffness: missing field: expected Bending stiffness EI: a bending"
            " stiffness (N m², kN m², N mm²,"
            " kgf m², lbf ft², lbf in²), at least 0 N m² and at most 1e+13 N m²",
        ),
    ],
)
def test_what_is_not_on_a_wire(changes: dict[str, Any], message: str) -> None:
    assert refusal(trolley_data(**changes)).endswith(message)


def test_inserts_of_two_wires_may_be_side_by_side() -> None:
    both = [INSULATOR, {**INSULATOR, "wire": "messenger_wire"}]
    assert len(load_line(stitched_data(inserts=both)).inserts) == 2
    touching = [INSULATOR, {**INSULATOR, "position": 52.0}]
    assert len(load_line(stitched_data(inserts=touching)).inserts) == 2


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"contact_wire__ends": "fixed", "midpoint_anchor": ANCHOR},
            "contact_wire.ends: midpoint anchor between fixed ends: got ends: fixed, expected ends:"
            " weights, constant_force or spring, or no midpoint_anchor; hint: the anchor lets both"
            " ends of a wire move",
        ),
        (
            {"contact_wire__ends": None, "midpoint_anchor": ANCHOR},
            "contact_wire.ends: midpoint anchor between fixed ends: got no ends, which are fixed"
            " then, expected ends: weights, constant_force or spring, or no midpoint_anchor; hint:"
            " the anchor lets both ends of a wire move",
        ),
        (
            {"contact_wire__end_ratio": 3},
            "contact_wire.end_ratio: ratio of a pulley that is not there: got end_ratio with ends:"
            " constant_force, expected ends: weights, or no end_ratio",
        ),
        (
            {"contact_wire__ends": None, "contact_wire__end_efficiency": 0.97},
            "contact_wire.end_efficiency: friction of a device that has none: got end_efficiency"
            " without ends, expected ends: weights or constant_force, or no end_efficiency",
        ),
        (
            {"contact_wire__ends": "weights", "contact_wire__end_efficiency": 1.03},
            "contact_wire.end_efficiency: got 1.03, expected a number without unit, or in % or"
            " ‰, above 0.5 and at most 1",
        ),
        (
            {"spans": [{"type": "span"}], "midpoint_anchor": ANCHOR},
            "midpoint_anchor: no support for a midpoint anchor: got a tension length of one span,"
            " expected at least two spans",
        ),
        (
            {"midpoint_anchor": {**ANCHOR, "support": 11}},
            "midpoint_anchor.support: midpoint anchor at an end of the line: got support 11,"
            " expected a support between 2 and 10",
        ),
        (
            {"midpoint_anchor": {**ANCHOR, "support": 1}},
            "midpoint_anchor.support: midpoint anchor at an end of the line: got support 1,"
            " expected a support between 2 and 10",
        ),
        (
            {"contact_wire__ends": "spring"},
            "contact_wire.end_stiffness: missing field: expected Stiffness of a tensioning spring;"
            " only with ends: spring: a stiffness (N/m, kN/m, N/mm, MN/m, kN/mm, daN/m, kgf/m,"
            " kgf/mm, lbf/ft, lbf/in), above 0 N/m"
            " and at most 1e+13 N/m",
        ),
        (
            {"contact_wire__end_stiffness": 2e4},
            "contact_wire.end_stiffness: stiffness of a spring that is not there: got end_stiffness"
            " with ends: constant_force, expected ends: spring, or no end_stiffness",
        ),
    ],
)
def test_impossible_ends(changes: dict[str, Any], message: str) -> None:
    assert refusal(trolley_data(**changes)).endswith(message)
