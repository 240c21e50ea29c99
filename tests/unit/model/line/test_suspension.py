"""Lines without a messenger wire: what is refused, and that a file says all of it."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load, load_line, scenario_warnings
from tests.support.line_types import AUXILIARY, STITCH, scenario_data, stitched_data
from tests.support.simple_lines import bridle_data, rail_data, trolley_data

ALONE = "hint: without a messenger wire the contact wire hangs on contact_support alone"


def refusal(data: dict[str, Any]) -> str:
    with pytest.raises(ModelError) as caught:
        load_line(data)
    return str(caught.value)


@pytest.mark.parametrize("data", [trolley_data(), bridle_data(), rail_data()])
def test_round_trip(data: dict[str, Any]) -> None:
    line = load_line(data)
    assert load_line(line.to_dict()) == line


def test_a_rail_has_no_wave_speed_to_be_warned_of() -> None:
    line = load_line(rail_data())
    assert line.wave_speed is None
    warnings = scenario_warnings(load(scenario_data(rail_data(), speed=80.0)))
    assert not [w for w in warnings if w.startswith("speed")]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"contact_support": None},
            "messenger_wire: missing field: expected messenger_wire, or contact_support for a"
            " contact wire without one",
        ),
        (
            {"contact_support": None, "geometry__encumbrance": 1.2},
            f"geometry.encumbrance: encumbrance without a messenger wire: expected messenger_wire,"
            f" or no encumbrance; {ALONE}",
        ),
        (
            {"dropper": {"stiffness": 1e5}},
            f"dropper: droppers without a messenger wire: expected messenger_wire, or no dropper;"
            f" {ALONE}",
        ),
        (
            {"support": {"vertical_stiffness": 1e5}},
            f"support: messenger supports without a messenger wire: expected messenger_wire, or no"
            f" support; {ALONE}",
        ),
        (
            {"stitch_wire": STITCH},
            f"stitch_wire: stitch wires without a messenger wire: expected messenger_wire, or no"
            f" stitch_wire; {ALONE}",
        ),
        (
            {"auxiliary_wire": AUXILIARY},
            f"auxiliary_wire: an auxiliary wire without a messenger wire: expected messenger_wire,"
            f" or no auxiliary_wire; {ALONE}",
        ),
        (
            {"span_types__span__droppers": {"positions": [20]}},
            f"span_types.span.droppers: droppers without a messenger wire: expected messenger_wire,"
            f" or no droppers; {ALONE}",
        ),
        (
            {"geometry__stagger_messenger_wire": [0.1]},
            f"geometry.stagger_messenger_wire: stagger of a messenger wire without a messenger"
            f" wire:"
            f" expected messenger_wire, or no stagger_messenger_wire; {ALONE}",
        ),
        (
            {"contact_support": None, "bridle": {**bridle_data()["bridle"]}},
            "messenger_wire: missing field: expected messenger_wire, or contact_support for a"
            " contact wire without one",
        ),
        (
            {"steady_arm": {"kind": "spring", "vertical_stiffness": 1.0}},
            "steady_arm.kind: two things hold the contact wire at each mast: got contact_support"
            " and"
            " a steady arm of kind spring, expected contact_support alone, or a bridle that it"
            " holds",
        ),
        (
            {"contact_wire__tension": 0},
            "contact_wire.tension: got 0 N, expected a force (N, kN, daN, MN, kgf, tf, lbf),"
            " at least 0.001 N; hint: only a conductor rail (kind: conductor_rail) is"
            " without tension",
        ),
        (
            {"contact_wire__joints": {"mass": 2.0, "spacing": 12.0}},
            "contact_wire.joints: joints of a wire: expected kind: conductor_rail, or no joints;"
            " hint: single masses on a wire are point_masses",
        ),
    ],
)
def test_half_a_suspension(changes: dict[str, Any], message: str) -> None:
    assert refusal(trolley_data(**changes)).endswith(message)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"bridle__tension": 12e3},
            "bridle.tension: bridle with all of the contact wire's tension: got 12000 N, expected"
            " less than 12000 N, the tension of the contact wire; hint: between the clamps the"
            " contact wire keeps the difference",
        ),
        (
            {"bridle__tension": 200.0},
            "bridle.tension: bridle too loose: got 200 N, with 216 N of contact wire on each clamp,"
            " expected at least 432 N; hint: with less it rises by more than one metre in two from"
            " its clamps",
        ),
        (
            {"bridle__length": 40.0},
            "bridle.length: bridle longer than a span: got 40 m, expected less than 40 m, the"
            " shortest span; hint: half of it reaches into each span, where that of the next"
            " support begins",
        ),
        (
            {"spans": [{"type": "span"}]},
            "bridle: no support for a bridle: got a line of one span, expected at least two spans;"
            " hint: bridles hang at the supports between two spans",
        ),
        (
            {"contact_wire": rail_data()["contact_wire"]},
            "bridle: bridle of a conductor rail: expected a contact wire of kind wire, or no"
            " bridle",
        ),
        (
            {"steady_arm": None, "geometry__stagger_contact_wire": [0.2]},
            "geometry.stagger_contact_wire.0: nothing holds the stagger: got 0.2 m with a steady"
            " arm"
            " of kind none, expected 0 m, or a steady arm of kind spring or arm",
        ),
    ],
)
def test_impossible_bridles(changes: dict[str, Any], message: str) -> None:
    assert refusal(bridle_data(**changes)).endswith(message)


def test_a_rail_without_tension_must_resist_bending() -> None:
    assert refusal(rail_data(contact_wire__bending_stiffness=0.0)).endswith(
        "contact_wire.bending_stiffness: nothing holds the rail up between its supports: got"
        " neither"
        " tension nor bending stiffness, expected a bending stiffness above 0 N m²"
    )


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"contact_support": {"vertical_stiffness": 1e5}},
            "contact_support: contact support with a messenger wire: expected messenger_wire, or"
            " contact_support; hint: droppers hold a contact wire below a messenger wire",
        ),
        (
            {"bridle": bridle_data()["bridle"]},
            "bridle: bridle with a messenger wire: expected messenger_wire, or bridle; hint:"
            " droppers hold a contact wire below a messenger wire",
        ),
        (
            {"dropper": None},
            "dropper: missing field: expected dropper, which a line with a messenger wire has;"
            " hint: for instance dropper: {stiffness: 100 kN/m}",
        ),
        (
            {"geometry__encumbrance": None},
            "geometry.encumbrance: missing field: expected Messenger wire above contact wire at the"
            " supports (system height): a length (m, mm, cm, km, in, ft, yd, chain, mi),"
            " above 0 m and at most 10 m",
        ),
        (
            {"steady_arm": None},
            "steady_arm: missing field: expected steady_arm, which a line with a messenger wire"
            " has; hint: for instance steady_arm: {kind: spring, vertical_stiffness: 250 N/m}",
        ),
        (
            {"span_types__span__droppers": None},
            "span_types.span.droppers: missing field: expected droppers, which the contact wire"
            " hangs on; hint: for instance droppers: {positions: [10 m, 20 m, 30 m]}; a span"
            " without any has droppers: {positions: []}",
        ),
        (
            {"contact_wire__kind": "conductor_rail"},
            "contact_wire.kind: conductor rail below a messenger wire: expected a contact wire of"
            f" kind wire, or no messenger_wire; {ALONE}",
        ),
    ],
)
def test_what_a_messenger_wire_needs(changes: dict[str, Any], message: str) -> None:
    assert refusal(stitched_data(**changes)).endswith(message)


def test_joints_stand_between_the_ends() -> None:
    line = load_line(rail_data(contact_wire__joints={"mass": 2.0, "spacing": 12.0}))
    assert line.contact_wire.joints is not None
    assert line.contact_wire.joints.places(30.0) == [12.0, 24.0]
    assert line.contact_wire.joints.places(24.0) == [12.0]
    shifted = line.contact_wire.joints.model_copy(update={"first": 1.0})
    assert shifted.places(30.0) == [1.0, 13.0, 25.0]
    assert shifted.places(0.5) == []
