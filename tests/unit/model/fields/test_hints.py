"""Hints name what was given, with numbers, and what they say works."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import Scenario, load, load_line, scenario_warnings
from arcless.model.advice.speeds import check_typed_speed
from arcless.model.scenario.step_rules import _floor
from tests.support.line_types import scenario_data
from tests.support.overlaps import plain_data

DAMPING = {"alpha": 0.1, "beta": 1e-4}


def scenario(line: dict[str, Any] | None = None, **changes: Any) -> Scenario:
    return load({**scenario_data(plain_data(8) if line is None else line), **changes})


def refused(line: dict[str, Any] | None = None, **changes: Any) -> str:
    with pytest.raises(ModelError) as caught:
        scenario(line, **changes)
    return str(caught.value)


def test_a_speed_far_beyond_the_wave_speed_asks_for_the_unit() -> None:
    with pytest.raises(ModelError) as caught:
        check_typed_speed(scenario(speed=160))
    text = str(caught.value)
    assert text.startswith("a speed far beyond the wave speed of the contact wire: got 160 m/s")
    assert "m/s (576 km/h)" in text
    assert "did you mean 160 km/h?" in text
    assert text.endswith("if m/s are meant, write 160 m/s")
    for typed in ("160 km/h", "160 m/s", "576 km/h"):
        check_typed_speed(scenario(speed=typed))


def test_a_stored_scenario_may_be_as_fast_as_it_was() -> None:
    fast = scenario(speed="576 km/h")
    assert load(fast.to_dict()) == fast
    assert any("the run is made" in text for text in scenario_warnings(fast))


@pytest.mark.parametrize(
    ("share", "asked"), [(0.8, True), (1.1, True), (0.5, False)], ids=["high", "above", "usual"]
)
def test_a_whole_number_of_metres_per_second_asks_for_the_unit(share: float, asked: bool) -> None:
    speed = next(
        v for v in range(int(share * scenario().line.wave_speed), 200) if (3.6 * v) % 10 > 0.1
    )
    told = " | ".join(scenario_warnings(scenario(speed=speed)))
    assert (f"did you mean {speed} km/h?" in told) is asked


def test_a_speed_given_with_its_unit_asks_nothing() -> None:
    kmh = 10 * int(0.8 * 3.6 * scenario().line.wave_speed / 10)
    told = " | ".join(scenario_warnings(scenario(speed=f"{kmh} km/h")))
    assert "EN 50119 allows 70%" in told
    assert "did you mean" not in told


def test_a_slow_wave_is_not_blamed_on_the_speed() -> None:
    """22 N for 22 kN: the line at rest tells what is wrong."""
    told = scenario_warnings(scenario(plain_data(8, contact_wire__tension=22.0)))
    assert any("the wave speed of the contact wire is" in text for text in told)
    assert not any("did you mean" in text for text in told)


@pytest.mark.parametrize(
    ("change", "hint"),
    [
        ({"geometry__stagger_contact_wire": [200, -200]}, "did you mean 200 mm?"),
        ({"geometry__contact_wire_height": 5300}, "did you mean 5300 mm?"),
        (
            {"steady_arm": {"kind": "arm", "length": 1.0, "slope": 8, "mass": 1.0}},
            "did you mean 8 deg?",
        ),
    ],
)
def test_a_bare_number_beyond_its_bounds_asks_for_the_unit(
    change: dict[str, Any], hint: str
) -> None:
    with pytest.raises(ModelError) as caught:
        load_line(plain_data(8, **change))
    assert caught.value.hint == hint


@pytest.mark.parametrize("value", ["200 m", 20000, "nan"])
def test_a_unit_that_is_given_or_helps_nothing_is_not_asked_for(value: object) -> None:
    with pytest.raises(ModelError) as caught:
        load_line(plain_data(8, geometry__stagger_contact_wire=[value]))
    assert "did you mean" not in str(caught.value)


def test_a_decimal_comma_in_a_list_is_told() -> None:
    span = {"positions": [5, 17, 5, 30, 42, 5, 45], "presag": [0] * 5}
    with pytest.raises(ModelError) as caught:
        load_line(plain_data(8, span_types__span__droppers=span))
    text = str(caught.value)
    assert "droppers.positions.2: droppers out of order: got 5 m after 17 m" in text
    assert text.endswith("17.5")


def test_an_encumbrance_in_another_unit_is_blamed_itself() -> None:
    with pytest.raises(ModelError) as caught:
        load_line(plain_data(8, geometry__encumbrance="1.2 mm"))
    assert str(caught.value).startswith("geometry.encumbrance: got 0.0012 m, expected an encumb")


def test_a_dropper_to_the_ground_is_refused() -> None:
    droppers = {"positions": [10, 20], "lengths": [1.1, 900]}
    with pytest.raises(ModelError, match=r"lengths\.1: a dropper that reaches the ground: got 900"):
        load_line(plain_data(8, span_types__span__droppers=droppers))


def test_a_wire_without_tension_is_not_taken_for_a_rail() -> None:
    with pytest.raises(ModelError, match=r"contact_wire\.tension: got 0 N"):
        load_line(plain_data(8, contact_wire__tension=0, contact_wire__ends="weights"))


def two(distance: float) -> list[dict[str, Any]]:
    one = scenario_data(plain_data(8))["pantographs"][0]
    return [{**one, "name": "A"}, {**one, "name": "B", "distance": distance}]


def test_a_train_longer_than_its_way_is_told_how_much_is_missing() -> None:
    length = scenario().line.total_length
    whole = {"start": 0.7 * length, "end": 0.9 * length}
    text = refused(pantographs=two(0.6 * length), travel=whole)
    assert text.startswith("pantographs.1.distance: no place that every pantograph passes")
    assert "add spans of more than 192 m in all" in text


def test_travel_that_was_given_backwards_is_not_asked_for() -> None:
    text = refused(travel={"start": 200, "end": 100})
    assert text.endswith("hint: travel.start and travel.end are places of the first pantograph")


def test_a_run_of_days_is_blamed_on_its_speed() -> None:
    assert "look at speed and travel" in refused(speed="0.001 km/h")


def test_records_too_rare_for_the_filter_say_how_many() -> None:
    text = refused(output={"contact_every": 1000})
    assert "hint: give output.contact_every at most " in text
    every = int(text.rsplit(maxsplit=1)[-1])
    scenario(output={"contact_every": every})


def test_a_planar_calculation_of_a_spatial_line_names_the_field() -> None:
    line = plain_data(8, geometry__stagger_contact_wire=[0.2, -0.2])
    text = refused(line, solver={"dimension": "planar"})
    assert text.startswith("solver.dimension: a planar calculation of a line that is not planar")
    scenario(line, solver={"dimension": "auto"})


@pytest.mark.parametrize("value", [1e-310, 5e-324, 1e-6, 0.12345678, 1.0, 2.0399999, 9.9999, 1e300])
def test_a_bound_is_told_in_four_digits_and_not_above_it(value: float) -> None:
    told = float(_floor(value))
    assert told <= value * (1 + 1e-9)
    assert told >= value * (1 - 1e-3) or value < 1e-307  # subnormal numbers have fewer digits
