"""Defaults that a scenario fills in, and its warnings."""

from math import pi
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.model import load, load_line, load_pantograph, scenario_warnings
from arcless.model.advice.advice import LONG_ELEMENT, backward_difference_damping
from tests.support.explicit import BY_MATRIX, EXPLICIT

SCENARIO = load("en50318-ac-simple-320-planar")
CUBIC = SCENARIO.with_(**BY_MATRIX)


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
    told = [said.partition(": the inner half")[0] for said in scenario_warnings(scenario)]
    count = last - first + 1
    words = f"analysis: {(first - 1) * 55} to {last * 55} m is judged, {count} whole span"
    words += f"{'s' * (count > 1)} of {spans}"
    # Three spans and fewer are told of.
    assert told == [words] * (count < 4)


def test_a_section_of_few_spans_that_was_asked_for_is_not_told() -> None:
    for chosen in ({"spans": [3, 4]}, {"from": 110, "to": 220}):
        assert scenario_warnings(with_spans(6).with_(analysis=chosen)) == []


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
    with pytest.raises(ModelError, match="Scenario cannot be changed") as caught:
        SCENARIO.speed = 3  # type: ignore[misc]
    assert "http" not in str(caught.value)
    with pytest.raises(ModelError, match="Line cannot be changed"):
        del SCENARIO.line.name


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
        (
            {"speed_profile": {"time": [0, 2], "speed": [80, 80]}},
            "m, before the first pantograph has left the section at",
        ),
        ({**BY_MATRIX, "solver.time_step": "10 ms"}, "more than half an element"),
        ({**BY_MATRIX, "solver.contact_wire_element": "3 m"}, "3 m is more than the"),
        (
            {"line": "ac-simple-55-3d", "line.geometry.stagger_contact_wire": [0]},
            "steady arms carry nothing",
        ),
    ],
)
def test_warnings(changes: dict[str, Any], message: str) -> None:
    scenario = SCENARIO.with_(**changes)
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
    backward = rigid.with_(**{"solver.scheme": "backward-difference"})
    assert not any("rings" in warning for warning in scenario_warnings(backward))


@pytest.mark.parametrize("angle", [1e-4, 0.01, 2 * pi * 20 * 1e-3, 0.6, 3.0, 100.0])
def test_damping_of_backward_differences_from_the_roots_of_the_scheme(angle: float) -> None:
    # u″ + ω²u = 0 with (u_i − 2u_{i−1} + u_{i−2})/h² for u″: (1 + ω²h²) z² − 2z + 1 = 0.
    root = np.log(np.roots([1 + angle**2, -2, 1])[0])
    # The roots of a polynomial with nearly equal roots are good to √ε ≈ 1e-8 relative to 1, and
    # the decay is their distance from 1, about angle².
    tolerance = max(1e-9, 1e-8 / angle)
    exact = -root.real / abs(root)
    assert backward_difference_damping(angle) == pytest.approx(exact, rel=tolerance)


def test_damping_of_backward_differences_at_known_points() -> None:
    # For short steps ωh/2; the next term is of the third order.
    assert backward_difference_damping(1e-3) == pytest.approx(0.5e-3, rel=1e-6)
    # 20 Hz at 1 ms: the design notes say about 6 %.
    assert backward_difference_damping(2 * pi * 20 * 1e-3) == pytest.approx(0.06, abs=0.005)


def test_a_scheme_that_damps_more_than_the_line_is_warned_about() -> None:
    # 2 % at ωh = 0.04: 0.32 ms for 20 Hz.
    changes = {"solver.scheme": "backward-difference", "solver.contact_wire_element": 0.5}
    loud, quiet = (SCENARIO.with_(**changes, **{"solver.time_step": h}) for h in ("1 ms", "0.3 ms"))
    assert scenario_warnings(loud) == [
        "solver.scheme: backward differences with a step of 1 ms damp 20 Hz by 6.3% of critical and"
        " may hide gaps; compare with a shorter solver.time_step or the scheme generalised-alpha"
    ]
    assert scenario_warnings(quiet) == []
    # A lower band is damped less.
    assert scenario_warnings(loud.with_(**{"analysis.low_pass": "6 Hz"})) == []


@pytest.mark.parametrize("changes", [{"solver.scheme": "generalised-alpha"}, EXPLICIT])
@pytest.mark.parametrize("wire", ["contact", "messenger"])
def test_elements_longer_than_those_of_the_rule_are_told(changes: Any, wire: str) -> None:
    field = f"{wire}_wire_element"
    by_rule = SCENARIO.with_(
        **{key: value for key, value in changes.items() if "element" not in key}
    )
    rule = getattr(by_rule.choice, f"{wire}_wire")
    assert scenario_warnings(by_rule) == []
    fitting = by_rule.with_(**{f"solver.{field}": LONG_ELEMENT * rule * 0.999})
    assert scenario_warnings(fitting) == []
    (said,) = scenario_warnings(by_rule.with_(**{f"solver.{field}": LONG_ELEMENT * rule * 1.001}))
    assert said.startswith(f"solver.{field}: ")
    family = "point masses" if changes is EXPLICIT else "cubic elements"
    assert f"more than the {rule:g} m that forces within 1 % need with {family}" in said


def test_elements_of_the_published_method_are_told_nothing() -> None:
    # Updated kinematics: the published method, with the elements that it was published with.
    coarse = CUBIC.with_(**{"solver.kinematics": "updated"})
    assert scenario_warnings(coarse) == []
    assert len(scenario_warnings(CUBIC)) == 2


def test_a_step_of_one_element_is_not_called_long() -> None:
    assert scenario_warnings(SCENARIO.with_(**{"solver.time_step": "one element"})) == []


@pytest.mark.parametrize("wire_model", ["hermite", "lumped"])
@pytest.mark.parametrize(("speed", "element"), [(320 / 3.6, 1.45), (0.7, 0.05), (100 / 3, 0.3)])
def test_a_step_may_be_exactly_one_element(wire_model: str, speed: float, element: float) -> None:
    changes = {
        "speed": speed,
        "solver.wire_model": wire_model,
        "solver.contact_wire_element": element,
        "solver.time_step": "one element",
        "analysis.low_pass": 6,
    }
    scenario = CUBIC.with_(**changes)
    assert scenario.time_step_s == element / speed
    step = scenario.time_step_s
    if step <= 0.05:  # the longest that can be typed
        scenario.with_(**{"solver.time_step": step})
        with pytest.raises(ModelError, match=r"solver\.time_step: step longer than an element"):
            scenario.with_(**{"solver.time_step": 1.001 * step})


def test_the_fastest_moment_of_a_profile_decides_on_the_step() -> None:
    profile = {"time": [0, 5, 10], "speed": [10, 80, 10]}
    fitting = CUBIC.with_(speed_profile=profile, **{"solver.time_step": "18 ms"})
    assert fitting.top_speed == 80
    with pytest.raises(ModelError, match=r"got 1\.52 m in a step, expected at most 1\.45 m"):
        CUBIC.with_(speed_profile=profile, **{"solver.time_step": "19 ms"})


@pytest.mark.parametrize("end", ["151 m", "1 km"])
def test_a_line_shorter_than_the_run_is_refused(end: str) -> None:
    short = {"line.spans": [{"type": "standard", "count": 15}], "travel.end": end}
    with pytest.raises(ModelError) as caught:
        load("praks-180").with_(**short)
    message = str(caught.value)
    assert message.startswith("travel.end: outside the line: got 1")
    assert "expected a position between 0 and 150 m, the line's length" in message


def test_stagger_without_steady_arms_is_refused() -> None:
    with pytest.raises(ModelError, match=r"stagger_contact_wire\.1: nothing holds the stagger"):
        load("praks-180").with_(**{"line.geometry.stagger_contact_wire": [0, 0.2]})
