"""A line that has no shape at rest is told by what to look at, and what is told helps."""

import re
from collections.abc import Callable
from typing import Any

import pytest

from arcless.equilibrium import equilibrium
from arcless.equilibrium.failure_hints import why_loose
from arcless.errors import EquilibriumError
from arcless.model import Scenario, load
from tests.support.line_types import scenario_data
from tests.support.overlaps import plain_data

Short = Callable[..., Scenario]
ARM = {"kind": "arm", "length": 1.2, "mass": 0.7, "axial_stiffness": 17e6}
PRESAG = "span_types__span__droppers__presag"


def scenario(**changes: Any) -> Scenario:
    return load(scenario_data(plain_data(8, **changes)))


def hint(**changes: Any) -> str:
    with pytest.raises(EquilibriumError) as caught:
        equilibrium.find(scenario(**changes))
    assert caught.value.hint is not None
    return caught.value.hint


def holds(**changes: Any) -> None:
    found = equilibrium.find(scenario(**changes))
    assert (found.of_droppers("link_tension") > 0).all()


def number(pattern: str, text: str) -> float:
    found = re.search(pattern, text)
    assert found is not None, text
    return float(found[1])


def test_a_messenger_wire_that_sags_below_the_contact_wire_names_its_tension() -> None:
    text = hint(messenger_wire__tension=1.5e3)
    assert text.startswith("messenger_wire.tension is 1.5 kN: with all that it carries")
    assert "geometry.encumbrance is 1.8 m" in text
    holds(messenger_wire__tension=1e3 * number(r"it takes some ([\d.]+) kN", text))


@pytest.mark.parametrize("wire", ["contact_wire", "messenger_wire"])
def test_a_tension_in_the_wrong_unit_is_named_before_anything_is_computed(wire: str) -> None:
    with pytest.raises(EquilibriumError) as caught:
        equilibrium.find(scenario(**{f"{wire}__tension": 15.0}))
    text = str(caught.value)
    assert text.startswith(f"{wire}.tension: a wire that does not carry its own weight: got 15 N")
    assert text.endswith("hint: did you mean 15 kN? a number without a unit is in N")


def test_a_tension_with_its_unit_is_not_asked_for_another_one() -> None:
    with pytest.raises(EquilibriumError, match=r"check its unit \(N for kN\?\)"):
        equilibrium.find(scenario(contact_wire__tension="15 N"))
    # A thousandth of a newton is no kilonewton either.
    with pytest.raises(EquilibriumError, match=r"check its unit \(N for kN\?\)"):
        equilibrium.find(scenario(contact_wire__tension=1e-3))


def test_a_loose_contact_wire_is_named_where_no_shape_is_found() -> None:
    """Between the two bounds: only what the core cannot find is told so."""
    line = scenario(contact_wire__tension=50.0).line
    told = why_loose(line, 9.81)
    assert told is not None
    assert told.startswith("contact_wire.tension is 50 N: where 10 m lie between what holds it")
    assert why_loose(scenario().line, 9.81) is None


def test_too_much_pre_sag_names_its_entry_and_how_much_hangs() -> None:
    text = hint(**{PRESAG: [0, 0.2, 0.03, 0.03, 0.02, 0]})
    assert text.startswith("a pre-sag of 200 mm is too much between 0 mm and 30 mm next to it")
    assert text.endswith("see span_types.span.droppers.presag.1")
    most = 1e-3 * number(r"at most (\d+) mm", text)
    holds(**{PRESAG: [0, most, 0.03, 0.03, 0.02, 0]})
    assert "too much" in hint(**{PRESAG: [0, most + 0.003, 0.03, 0.03, 0.02, 0]})


def test_a_pre_sag_upwards_is_told_to_count_downwards() -> None:
    assert hint(**{PRESAG: [0, -0.2, -0.3, -0.3, -0.2, 0]}).endswith("pre-sag counts downwards")


def test_a_steep_arm_of_a_straight_line_is_named() -> None:
    zigzag = {"geometry__stagger_contact_wire": [0.4, -0.4]}
    text = hint(steady_arm={**ARM, "slope": 0.9}, **zigzag)
    assert text.startswith("the steady arm at support 2 pulls with some 400 N")
    flat = number(r"slope below some ([\d.]+) deg", text)
    holds(steady_arm={**ARM, "slope": f"{flat} deg"}, **zigzag)


def test_a_sharp_change_of_height_is_named() -> None:
    steep = [{"from_support": 3, "to_support": 4, "height": 4.0}]
    text = hint(geometry__height_changes=steep)
    assert text.startswith("geometry.height_changes bends the wire there by")
    spread = [{"from_support": 3, "to_support": 8, "height": 4.0}]
    holds(geometry__height_changes=spread)


def test_a_rail_on_supports_too_far_apart_is_named() -> None:
    rail = {
        "name": "rail",
        "contact_wire": {
            "kind": "conductor_rail",
            "mass": 6.0,
            "axial_stiffness": 160e6,
            "bending_stiffness": 250e3,
            "tension": 0.0,
            "ends": "fixed",
        },
        "contact_support": {"vertical_stiffness": 5e5},
        "steady_arm": {"kind": "none"},
        "geometry": {"contact_wire_height": 5.3},
        "span_types": {"span": {"length": 50.0}},
        "spans": [{"type": "span", "count": 8}],
    }
    with pytest.raises(EquilibriumError) as caught:
        equilibrium.find(load(scenario_data(rail)))
    assert "contact_wire.bending_stiffness is 250000 N m²: where 50 m lie" in str(caught.value)
