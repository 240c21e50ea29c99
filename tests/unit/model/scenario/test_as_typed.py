"""Fields that were set for a run: which, as typed, and a digest of their values."""

from typing import Any

import pytest

from arcless.model import Scenario, load
from arcless.model.scenario.as_typed import changes_of, digest_of_changes

SCENARIO = load("en50318-ac-simple-320-planar")


def digest(scenario: Scenario) -> str:
    return digest_of_changes(scenario.to_dict())


def test_a_scenario_as_it_was_read_has_no_changes() -> None:
    assert SCENARIO.changes == {}


def test_changes_are_as_typed_in_one_order() -> None:
    changes = {
        "speed": "280 km/h",
        "pantographs.0.masses.0.mass": 7,
        "line.contact_wire.tension": "24 kN",
        "analysis.spans": [5, 8],
        "output.droppers": False,
        "travel.end": None,
    }
    expected = {
        "analysis.spans": "[5, 8]",
        "output.droppers": "false",
        "speed": "280 km/h",
        "travel.end": "null",
        "line.contact_wire.tension": "24 kN",
        "pantographs.0.model.masses.0.mass": "7",
    }
    one = SCENARIO.with_(**changes)
    other = SCENARIO
    for path, value in reversed(changes.items()):  # one after the other, from the last one
        other = other.with_(**{path: value})
    for found in (one.changes, other.changes):
        assert list(found.items()) == list(expected.items())
    assert digest(one) == digest(other)


def test_the_last_value_counts() -> None:
    twice = SCENARIO.with_(speed="280 km/h").with_(speed="250 km/h")
    assert twice.changes == {"speed": "250 km/h"}


def test_what_was_taken_back_is_no_change() -> None:
    profile: dict[str, Any] = {"time": [0, 60], "speed": ["280 km/h", "290 km/h"]}
    changed = SCENARIO.with_(speed="280 km/h").with_(speed_profile=profile)
    assert list(changed.changes) == ["speed_profile"]


def test_names_and_certainty_are_no_changes() -> None:
    found = SCENARIO.with_(name="other", description="words", certainty=8)
    assert found.changes == {}
    assert digest(found) != digest(SCENARIO)  # it is that of a name, too


def test_a_line_in_place_of_another_is_one_change() -> None:
    changed = SCENARIO.with_(**{"line": "ac-simple-55-3d", "line.contact_wire.tension": "24 kN"})
    assert changed.changes == {"line": "ac-simple-55-3d", "line.contact_wire.tension": "24 kN"}


def test_a_result_of_an_early_version_has_the_value_in_si() -> None:
    data = SCENARIO.with_(speed="280 km/h").to_dict()
    del data["provenance"]["speed"]["given"]
    assert float(changes_of(data)["speed"]) == pytest.approx(280 / 3.6, rel=1e-12)


def test_the_digest_is_of_whole_values() -> None:
    # Texts of long lists are cut, so that these two have one text.
    many = [f"{place} m" for place in range(300, 600)]
    one, other = (SCENARIO.with_(**{"output.points": [*many, last]}) for last in ("600 m", "601 m"))
    assert one.changes == other.changes
    assert digest(one) != digest(other)
    assert digest(one) == digest(SCENARIO.with_(**{"output.points": [*range(300, 600), 600.0]}))
