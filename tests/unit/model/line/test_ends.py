"""Ends of a line's wires: data, weights and friction."""

from typing import Any

import pytest

from arcless.model import Line, Wire, line_warnings, load, load_line, scenario_warnings
from arcless.model.shipped.library import shipped
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.simple_lines import rail_data, trolley_data

WIRE = {"mass": 1.1, "axial_stiffness": 14e6, "bending_stiffness": 0.0, "tension": 12e3}


def of_ends(line: Line) -> list[str]:
    """Return what a line is told of its ends."""
    return [text for text in line_warnings(line) if text.startswith("line: no ends")]


def test_a_line_that_says_nothing_of_ends_is_told_what_temperature_does() -> None:
    line = load_line(stitched_data())
    assert line.contact_wire.is_anchored
    # EA α = 14 MN · 17e-6/K = 238 N/K, 7.4 MN · 17e-6/K = 126 N/K.
    assert of_ends(line) == [
        "line: no ends given, so wires are anchored (ends: fixed) and pull with the temperature:"
        " contact_wire by 2.4 kN per 10 K, 19.8 kN 20 K colder in place of 15; messenger_wire by"
        " 1.3 kN per 10 K, 17.5 kN 20 K colder in place of 15. Real lines mostly hang on weights:"
        " say ends: weights (with a midpoint_anchor both ends move), constant_force, spring, or"
        " fixed"
    ]


def test_it_is_told_once_and_of_the_wires_that_are_meant() -> None:
    data = compound_data(contact_wire__ends="fixed", messenger_wire__ends="weights")
    warnings = scenario_warnings(load(scenario_data(data)))
    (notice,) = (text for text in warnings if "no ends given" in text)
    assert "auxiliary_wire by" in notice
    assert "contact_wire by" not in notice
    assert "messenger_wire by" not in notice


def test_saying_fixed_is_enough() -> None:
    wires = ("contact_wire", "messenger_wire")
    data = stitched_data(**{f"{wire}__ends": "fixed" for wire in wires})
    assert of_ends(load_line(data)) == []


def test_silence_survives_being_written() -> None:
    line = load_line(stitched_data())
    again = load_line(line.to_dict())
    assert again.contact_wire.ends is None
    assert of_ends(again) == of_ends(line) != []


def test_a_rail_without_tension_is_told_its_change_alone() -> None:
    (notice,) = of_ends(load_line(rail_data(contact_wire__ends=None)))
    assert "contact_wire by 26 kN per 10 K. Real" in notice  # 150 MN · 17e-6/K · 10 K = 25.5 kN


@pytest.mark.parametrize("name", shipped("line"))
def test_shipped_lines_say_what_their_ends_are(name: str) -> None:
    line = load_line(name)
    for field in ("contact_wire", "messenger_wire", "auxiliary_wire"):
        wire = getattr(line, field)
        if wire is not None:
            assert wire.ends is not None
            assert line.provenance[f"{field}.ends"].mark is not None


@pytest.mark.parametrize(
    ("given", "mass", "band"),
    [
        # n T/g
        ({"ends": "weights", "end_ratio": 2.0}, 2 * 12e3 / 9.81, (12e3, 12e3)),
        ({"ends": "weights", "end_efficiency": 0.96}, 3 * 12e3 / 9.81, (11520.0, 12500.0)),
        ({"ends": "constant_force", "end_efficiency": 0.5001}, 0.0, (6001.2, 23995.2)),
        ({"ends": "fixed"}, 0.0, (12e3, 12e3)),
        ({}, 0.0, (12e3, 12e3)),
    ],
)
def test_mass_and_band(given: dict[str, Any], mass: float, band: tuple[float, float]) -> None:
    wire = Wire(**WIRE, **given)
    assert wire.end_mass == pytest.approx(mass)
    # Rounding of five figures.
    assert wire.end_band == pytest.approx(band, rel=1e-5)


def test_friction_of_nothing_is_none() -> None:
    assert not Wire(**WIRE, ends="weights", end_efficiency=1.0).has_friction
    assert Wire(**WIRE, ends="weights", end_efficiency=0.99).has_friction
    assert load_line(trolley_data()).contact_wire.ends == "constant_force"
