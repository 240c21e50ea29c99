"""What a scenario fills in by itself, and what it warns about."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load, load_line, load_pantograph, scenario_warnings

SCENARIO = load("en50318-ac-simple-320")


def with_spans(count: int, **changes: Any) -> Any:
    return SCENARIO.with_(**{"analysis.spans": None, "line.spans.0.count": count}, **changes)


def test_travel_leaves_a_span_free_at_both_ends() -> None:
    assert SCENARIO.travel_range() == (55, 19 * 55)


def test_travel_leaves_room_for_trailing_pantographs() -> None:
    scenario = load("ac-simple-320-two-pantographs")
    assert scenario.travel_range() == (55 + 200, 19 * 55)
    assert [placement.name for placement in scenario.pantographs] == ["leading", "trailing"]


def test_given_travel_is_kept() -> None:
    assert SCENARIO.with_(**{"travel.start": 110}).travel_range() == (110, 19 * 55)


@pytest.mark.parametrize(
    ("spans", "first", "last"),
    [(20, 6, 15), (10, 4, 7), (8, 3, 6), (6, 3, 4), (5, 3, 3)],
)
def test_default_section_is_the_inner_half(spans: int, first: int, last: int) -> None:
    scenario = with_spans(spans)
    assert scenario.analysis_range() == ((first - 1) * 55, last * 55)
    assert scenario_warnings(scenario) == []


def test_default_section_of_a_short_line_is_all_of_the_travel() -> None:
    scenario = with_spans(4)
    assert scenario.analysis_range() == scenario.travel_range() == (55, 165)
    assert "too short for inner spans" in scenario_warnings(scenario)[0]


def test_default_section_is_travelled_by_every_pantograph() -> None:
    scenario = load("ac-simple-320-two-pantographs").with_(**{"analysis.spans": None})
    assert scenario.analysis_range() == (275, 825)
    short = scenario.with_(**{"travel.start": 300, "travel.end": 900})
    assert short.analysis_range() == (300, 700)


def test_one_end_of_the_section_may_be_given() -> None:
    scenario = with_spans(20, **{"analysis.from": "400 m"})
    assert scenario.analysis_range() == (400, 825)


def test_pantographs_are_named_by_their_place(data: dict[str, Any]) -> None:
    data["pantographs"] = [{"model": "dsa-380"}, {"model": "dsa-250", "distance": 100}]
    assert [placement.name for placement in load(data).pantographs] == ["P1", "P2"]


def test_two_pantographs_of_one_name(data: dict[str, Any]) -> None:
    data["pantographs"] = [
        {"model": "dsa-380", "name": "P2"},
        {"model": "dsa-250", "distance": 100},
    ]
    with pytest.raises(ModelError, match=r"pantographs.1.name: name used twice: got \"P2\""):
        load(data)


def test_the_force_of_the_pantograph_is_the_last_resort(data: dict[str, Any]) -> None:
    assert load(data).pantographs[0].start_force == 70
    data["pantographs"][0]["static_force"] = "80 N"
    assert load(data).pantographs[0].start_force == 80


def test_models_may_be_given_as_objects(data: dict[str, Any]) -> None:
    data["line"] = load_line("en50318-2002")
    data["pantographs"][0]["model"] = load_pantograph("dsa-250")
    scenario = load(data)
    assert scenario.line is data["line"]
    assert load(scenario) is scenario


def test_a_scenario_cannot_be_changed() -> None:
    with pytest.raises(ValueError, match="frozen"):
        SCENARIO.speed = 3  # type: ignore[misc]


def test_spans_of_several_types(data: dict[str, Any]) -> None:
    line = load_line("ac-simple-55").to_dict()
    line["span_types"]["short"] = {"length": 40, "droppers": {"positions": [10, 20, 30]}}
    line["spans"] = [
        {"type": "standard", "count": 2},
        {"type": "short"},
        {"type": "standard", "count": 2},
    ]
    model = load_line(line)
    assert model.support_positions() == [0, 55, 110, 150, 205, 260]
    assert [span.length for span in model.span_list()] == [55, 55, 40, 55, 55]
    assert model.total_length == 260
    assert model.span_types["short"].droppers.design_presag == (0, 0, 0)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"speed": "470 km/h"}, "is 102% of the wave speed 460 km/h"),
        ({"speed": "350 km/h"}, "EN 50119 allows 70%"),
        ({"analysis.spans": [2, 15]}, "first or last two spans"),
        ({"analysis.spans": [6, 19]}, "first or last two spans"),
        ({"travel.start": 400}, "is not travelled in full"),
        ({"speed_profile": {"time": [0, 2], "speed": [80, 80]}}, "ends before"),
        ({"solver.time_step": "10 ms"}, "more than half an element"),
        ({"solver.contact_wire_element": "3 m"}, "fewer than two elements"),
        (
            {"line": "ac-simple-55-3d", "line.geometry.stagger_contact_wire": [0]},
            "steady arms carry nothing",
        ),
    ],
)
def test_warnings(changes: dict[str, Any], message: str) -> None:
    scenario = SCENARIO
    for path, value in changes.items():
        scenario = scenario.with_(**{path: value})
    assert any(message in warning for warning in scenario_warnings(scenario))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"solver.contact_wire_element": 0.05, "line.spans.0.count": 5000}, "too many elements"),
        ({"solver.time_step": 1e-5, "speed": 0.01}, "too many time steps"),
        ({"speed_profile": {"time": [0, 9], "speed": [0, 0]}}, "no motion"),
    ],
)
def test_sizes_are_bounded(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError, match=message):
        SCENARIO.with_(**changes)


def test_rigid_contact_with_a_scheme_that_rings_is_warned_about() -> None:
    rigid = SCENARIO.with_(**{"contact.law": "rigid"})
    assert "rings at the step frequency" in scenario_warnings(rigid)[0]
    quiet = {"name": "generalised-alpha", "spectral_radius": 0}
    assert scenario_warnings(rigid.with_(**{"solver.scheme": quiet})) == []
    assert scenario_warnings(SCENARIO) == []
