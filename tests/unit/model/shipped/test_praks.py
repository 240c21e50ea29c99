"""The worked example of the published method: its data, and that each of them can be varied."""

from math import sqrt
from typing import Any

import pytest

from arcless.model import Scenario, load, parse_override
from arcless.model.settings.run_settings import ONE_ELEMENT

SPEEDS = (180, 250, 340, 360)
MASSES = "pantographs.0.masses"


def value_at(scenario: Scenario, path: str) -> Any:
    place: Any = scenario.to_dict()
    for name in path.replace("pantographs.0.masses", "pantographs.0.model.masses").split("."):
        place = place[int(name) if isinstance(place, list) else name]
    return place


def test_the_published_table() -> None:
    scenario = load("praks-340")
    line, head = scenario.line, scenario.pantographs[0].model
    assert (line.messenger_wire.tension, line.contact_wire.tension) == (24e3, 19.6e3)
    assert {line.messenger_wire.ends, line.contact_wire.ends} == {"constant_force"}
    assert {span.length for span in line.span_list()} == {10}
    assert line.dropper.stiffness == 3.6e3
    assert [(m.mass, m.stiffness) for m in head.masses] == [(45, 1e3), (16, 6e3)]
    assert scenario.pantographs[0].start_force == 100
    assert scenario.travel_range()[0] == 5  # the middle of the first span
    assert line.support.longitudinal_stiffness == 0
    solver = scenario.solver
    assert (solver.messenger_wire_element, solver.contact_wire_element) == (2.5, 0.25)
    chosen = (solver.wire_model, solver.scheme.name, solver.kinematics, scenario.contact.law)
    assert chosen == ("lumped", "backward-difference", "updated", "rigid")
    assert solver.time_step == ONE_ELEMENT


@pytest.mark.parametrize("speed", SPEEDS)
def test_the_four_scenarios_differ_in_speed_only(speed: int) -> None:
    scenario = load(f"praks-{speed}")
    assert scenario.speed == speed / 3.6
    # The same division, in one order or the other: the last bit.
    assert scenario.time_step_s == pytest.approx(0.25 / (speed / 3.6), rel=1e-15)
    own = {"name", "description", "speed", "provenance"}
    same = load("praks-340").to_dict()
    assert {k: v for k, v in scenario.to_dict().items() if k not in own} == {
        k: v for k, v in same.items() if k not in own
    }


@pytest.mark.parametrize("speed", SPEEDS)
def test_the_travel_ends_before_waves_return_from_the_end_of_the_line(speed: int) -> None:
    scenario = load(f"praks-{speed}")
    wires = scenario.line.contact_wire, scenario.line.messenger_wire
    wave = max(sqrt(wire.tension / wire.mass) for wire in wires)
    start, end = scenario.travel_range()
    train, far = speed / 3.6, scenario.line.total_length
    # A wave sent ahead at the start goes to the end and back: together they cover twice the way.
    assert end < start + train * 2 * (far - start) / (train + wave)


# Every quantity that the paper names, by the path under which a user changes it.
NAMED_IN_THE_PAPER = {
    "speed": ("300 km/h", 300 / 3.6),
    "pantographs.0.static_force": ("120 N", 120),
    "line.span_types.standard.length": ("12 m", 12),
    "line.span_types.standard.droppers.positions": ("[2.5 m, 7.5 m]", [2.5, 7.5]),
    "line.dropper.stiffness": ("5 kN/m", 5e3),
    f"{MASSES}.0.mass": ("40 kg", 40),
    f"{MASSES}.0.stiffness": ("0.5 kN/m", 500),
    f"{MASSES}.0.damping": ("50 N s/m", 50),
    f"{MASSES}.1.mass": ("12 kg", 12),
    f"{MASSES}.1.stiffness": ("8 kN/m", 8e3),
    f"{MASSES}.1.damping": ("20 N s/m", 20),
    "line.contact_wire.tension": ("22 kN", 22e3),
    "line.messenger_wire.tension": ("18 kN", 18e3),
    "line.contact_wire.mass": ("1.35 kg/m", 1.35),
    "line.contact_wire.axial_stiffness": ("15 MN", 15e6),
    "line.contact_wire.bending_stiffness": ("0 N m2", 0),
    "line.contact_wire.damping.alpha": ("0.0125 1/s", 0.0125),
    "line.contact_wire.damping.beta": ("0.1 ms", 1e-4),
    "line.messenger_wire.mass": ("0.6 kg/m", 0.6),
    "line.messenger_wire.axial_stiffness": ("8 MN", 8e6),
    "line.messenger_wire.bending_stiffness": ("50 N m2", 50),
    "line.messenger_wire.damping.alpha": ("0.0125 1/s", 0.0125),
    "line.messenger_wire.damping.beta": ("0.1 ms", 1e-4),
    "line.dropper.damping": ("10 N s/m", 10),
    "line.dropper.slackens": ("true", True),
    "line.dropper.clamp_mass_contact_wire": ("1.5 kg", 1.5),
    "contact.friction_coefficient": ("0.1", 0.1),
    "travel.start": ("15 m", 15),
    "line.spans.0.count": ("40", 40),
    "solver.contact_wire_element": ("0.5 m", 0.5),
    "solver.messenger_wire_element": ("1.25 m", 1.25),
    "solver.time_step": ("1 ms", 1e-3),
    "solver.scheme": ("trapezoidal", {"name": "trapezoidal"}),
}


@pytest.mark.parametrize("path", NAMED_IN_THE_PAPER)
def test_every_parameter_of_the_paper_can_be_varied(path: str) -> None:
    text, expected = NAMED_IN_THE_PAPER[path]
    before = load("praks-340")
    name, value = parse_override(f"{path}={text}")  # as --set does
    changed = before.with_(**{name: value})
    assert value_at(changed, path) == expected != value_at(before, path)


def test_parameters_can_be_varied_together() -> None:
    changes = {path: parse_override(f"{path}={text}")[1] for path, (text, _) in _together().items()}
    changed = load("praks-340").with_(**changes)
    for path, (_, expected) in _together().items():
        assert value_at(changed, path) == expected


def _together() -> dict[str, tuple[str, Any]]:
    return {path: pair for path, pair in NAMED_IN_THE_PAPER.items() if path != "solver.time_step"}


def test_the_step_follows_speed_and_element() -> None:
    scenario = load("praks-360")
    assert scenario.with_(speed="180 km/h").time_step_s == 2 * scenario.time_step_s
    longer = scenario.with_(**{"solver.contact_wire_element": "0.5 m"})
    assert longer.time_step_s == 2 * scenario.time_step_s
    assert scenario.with_(**{"solver.time_step": "1 ms"}).time_step_s == 1e-3
