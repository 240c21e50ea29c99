"""Numbers that are valid and not meant: a sentence each, with the number and what is usual."""

from typing import Any

import pytest

from arcless.model import line_warnings, load, load_line, scenario_warnings
from arcless.model.shipped.library import shipped
from tests.support.line_types import scenario_data, stitched_data

DAMPING = {"alpha": 0.1, "beta": 1e-4}


def calm(**changes: Any) -> dict[str, Any]:
    """Return a line that gives no warning."""
    own = {
        "contact_wire__damping": DAMPING,
        "contact_wire__ends": "weights",
        "messenger_wire__ends": "weights",
        "design": {"supply": "AC 25 kV"},
    }
    return stitched_data(**(own | changes))


def test_a_sound_line_gives_no_warning() -> None:
    assert line_warnings(load_line(calm())) == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        # 12 kN for 12 MN: T/EA is above 1, and sound runs at 100 m/s.
        (
            {"contact_wire__axial_stiffness": 12e3},
            ["strain at rest, T/EA, is", "longitudinal waves"],
        ),
        ({"contact_wire__tension": 1.5e6}, ["the stress", "the strain", "wave speed"]),
        (
            {"contact_wire__mass": 1350.0},
            ["the mass is 1350 kg/m", "longitudinal", "wave speed"],
        ),
        ({"geometry__contact_wire_height": 8.5}, ["the height of the contact wire is 8.5 m"]),
        ({"dropper__stiffness": 100.0}, ["the stiffness of a dropper is 0.1 kN/m"]),
        ({"messenger_wire__tension": 3.0e3}, ["lets the messenger wire sag by"]),
        (
            {"contact_wire__damping": {}, "geometry__stagger_contact_wire": [0.0]},
            ["no wire has damping (contact_wire.damping, messenger_wire.damping, stitch"],
        ),
        ({"design": {}}, ["line.design.supply: not given"]),
        (
            {"geometry__stagger_contact_wire": [0.45, -0.45]},
            ["line.geometry.stagger_contact_wire: the contact wire at rest lies 0.45 m aside"],
        ),
    ],
)
def test_a_wrong_unit_is_told_with_the_number(changes: dict[str, Any], words: list[str]) -> None:
    if "messenger_wire__tension" in changes:  # below the stitch wire's the line is refused
        changes |= {"stitch_wire__tension": 1.0e3}
    told = " | ".join(line_warnings(load_line(calm(**changes))))
    for part in words:
        assert part in told


@pytest.mark.parametrize("name", shipped("line"))
def test_no_shipped_line_looks_like_a_wrong_unit(name: str) -> None:
    assert [text for text in line_warnings(load_line(name)) if "unit" in text] == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"mean_force": 1100.0}, "pantographs.0.mean_force: the mean force is 1100 N"),
        ({"static_force": 7.0}, "pantographs.0.static_force: the static force is 7 N"),
    ],
)
def test_a_force_beyond_all_use_is_told(change: dict[str, Any], words: str) -> None:
    data = scenario_data(calm())
    pantograph = data["pantographs"][0]
    pantograph.pop("static_force", None)
    scenario = load({**data, "pantographs": [{**pantograph, **change}]})
    assert any(text.startswith(words) for text in scenario_warnings(scenario))


@pytest.mark.parametrize(
    ("head", "sway", "told"),
    [
        ({"head_width": 1.6}, 0.0, "the head of pantograph P1 allows 0.4 m"),
        ({"head_width": 1.95}, 0.0, None),
        ({"head_width": 1.95}, 0.15, "and the head sways by 0.15 m"),
        ({"lateral_range": 0.3}, 0.0, "allows 0.3 m"),
        ({}, 0.0, "0.40 m are allowed for a head of 1.60 m"),
    ],
)
def test_staggers_are_held_against_the_heads(
    head: dict[str, float], sway: float, told: str | None
) -> None:
    data = scenario_data(calm(geometry__stagger_contact_wire=[0.45, -0.45]))
    model = {
        "name": "two masses",
        "masses": [{"mass": 15, "stiffness": 50, "damping": 90}, {"mass": 7, "stiffness": 5e3}],
        **head,
    }
    model["masses"][1]["damping"] = 10
    placement = {"model": model, "static_force": 80.0, "sway": sway}
    scenario = load({**data, "pantographs": [placement]})
    found = [text for text in scenario_warnings(scenario) if "aside" in text]
    assert len(found) == (0 if told is None else 1)
    assert told is None or told in found[0]
