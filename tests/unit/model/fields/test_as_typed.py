"""Values are kept as they were typed, outside the data: nothing that counts differs by them."""

import json
import pickle
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.model import load, load_line
from arcless.model.fields.as_typed import MOST_ITEMS
from arcless.model.scenario.as_typed import restore, typed_in
from arcless.report.model_data import Row, groups
from tests.unit.model.conftest import LINE


@pytest.fixture
def line(tmp_path: Path) -> Path:
    path = tmp_path / "line.yaml"
    text = LINE.replace("[10, 20, 35, 45]", "[10 m, 2000 cm, 35, 45]").replace(
        "tension: 16 kN", "tension: {value: 16 kN, mark: A, source: S}"
    )
    path.write_text(text + "sources: {S: a drawing}\n", encoding="utf-8")
    return path


def rows(scenario: arcless.Scenario) -> dict[str, Row]:
    return {row.path: row for group in groups(scenario) for row in group.rows}


def test_what_is_asked_for_by_path(line: Path) -> None:
    found = load_line(line)
    assert found.as_typed("contact_wire.tension") == "22 kN"
    assert found.as_typed("contact_wire.bending_stiffness") == "195 N m²"
    assert found.as_typed("messenger_wire.tension") == "16 kN"
    assert found.as_typed("span_types.standard.droppers.positions.1") == "2000 cm"
    assert found.as_typed("span_types.standard.droppers.positions.2") is None
    assert found.as_typed("contact_wire.damping.alpha") is None
    assert found.is_given("spans.0.count")
    assert found.is_given("contact_wire.damping.alpha") is False


def test_a_wire_of_the_catalogue_has_the_texts_of_the_catalogue() -> None:
    found = load_line("ac-simple-55")
    wire = {"catalogue": "Cu AC-100", "tension": "10.5 kN"}
    named = load_line(found.to_dict() | {"contact_wire": wire})
    assert named.as_typed("contact_wire.tension") == "10.5 kN"
    assert str(named.as_typed("contact_wire.axial_stiffness")).endswith("N")
    assert named.is_given("contact_wire.mass")


def test_nothing_that_counts_differs(data: dict[str, Any]) -> None:
    typed, plain = load(data), load(load(data).to_dict())
    assert typed.as_typed("speed") == "200 km/h"
    assert plain.as_typed("speed") is None
    assert typed == plain
    assert json.dumps(typed.to_dict()) == json.dumps(plain.to_dict())
    again = pickle.loads(pickle.dumps(typed))
    assert again == typed
    assert again.as_typed("speed") == "200 km/h"


def test_a_changed_copy_has_what_was_typed_for_it(data: dict[str, Any], line: Path) -> None:
    scenario = load(data | {"line": str(line)})
    changed = scenario.with_(
        **{"line.contact_wire.tension": "24 kN", "contact.stiffness": "60 kN/m"}
    )
    assert changed.line.as_typed("contact_wire.tension") == "24 kN"
    assert changed.line.as_typed("contact_wire.axial_stiffness") == "15 MN"
    assert changed.as_typed("speed") == "200 km/h"
    assert changed.line.is_given("contact_wire.damping.alpha") is False
    assert scenario.line.as_typed("contact_wire.tension") == "22 kN"
    number = scenario.with_(speed=50.0)
    assert number.as_typed("speed") == "50.0"  # where it comes from says so
    assert rows(number)["speed"].value == "50 m/s"
    other = changed.with_(line="norway-s25")
    assert other.line.as_typed("contact_wire.tension") == "15 kN"
    assert other.line.is_given("contact_wire.thermal_expansion") is False
    both = scenario.with_(**{"line": "norway-s25", "line.contact_wire.tension": "16 kN"})
    assert both.line.as_typed("contact_wire.tension") == "16 kN"
    assert both.line.as_typed("messenger_wire.tension") == "15 kN"


def test_the_table_of_a_report(data: dict[str, Any], line: Path) -> None:
    found = rows(load(data | {"line": str(line)}))
    tension = found["contact_wire.tension"]
    assert (tension.value, tension.si, tension.is_default) == ("22 kN", "22\u202f000 N", False)
    assert found["messenger_wire.tension"].value == "16 kN"
    assert found["speed"].value == "200 km/h"
    positions = found["span_types.standard.droppers.positions"]
    assert positions.value == "10 m, 2000 cm, 35 m, 45 m"
    assert positions.si == "10, 20, 35, 45 m"
    default = found["contact_wire.damping.alpha"]
    assert (default.value, default.si, default.is_default) == ("0 1/s", "", True)


def test_a_text_that_does_not_mean_the_value_is_left_out(data: dict[str, Any]) -> None:
    copied = load(data).model_copy(update={"speed": 50.0})
    assert rows(copied)["speed"].value == "50 m/s"


def test_a_scenario_that_was_read_again(data: dict[str, Any], line: Path) -> None:
    scenario = load(data | {"line": str(line)})
    again = load(scenario.to_dict())
    restore(again, json.loads(json.dumps(typed_in(scenario))))
    assert groups(again) == groups(scenario)
    # A result of an earlier version says nothing of it: the notes of sources are all there is.
    restore(again, None)
    assert rows(again)["messenger_wire.tension"].value == "16 kN"
    assert rows(again)["contact_wire.tension"].value == "22\u202f000 N"
    assert not any(row.is_default for row in rows(again).values())
    assert again.with_(speed="180 km/h").as_typed("speed") == "180 km/h"


def test_long_lists_are_not_kept(data: dict[str, Any]) -> None:
    points = [f"{100 + place} m" for place in range(MOST_ITEMS + 1)]
    scenario = load(data | {"output": {"points": points}})
    assert scenario.as_typed("output.points.0") is None
    assert scenario.is_given("output.points")
    short = load(data | {"output": {"points": points[:3]}})
    assert short.as_typed("output.points.0") == "100 m"
