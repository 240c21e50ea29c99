"""The study file: read as it was meant, and patched where it is there."""

from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless import ModelError, study
from arcless.model.files.yaml_reader import parse
from arcless.studio.studies.fields import fields
from arcless.studio.studies.writing import written

DEFINITION: dict[str, Any] = {
    "name": "try",
    "scenario": "en50318-ac-simple-275-planar",
    "set": {
        "line.spans": [{"type": "standard", "count": 6}],
        "travel": {"start": "60 m", "end": "260 m"},
        "analysis": {"from": "100 m", "to": "240 m"},
    },
    "variables": {
        "tension": {"field": "line.contact_wire.tension", "range": ["18 kN", "26 kN"], "count": 3},
        "force": {"field": "pantographs.0.static_force", "values": ["100 N", "130 N"]},
    },
    "design": {"kind": "grid"},
    "outputs": {"sigma": "std_force_N", "ratio": "std_force_N / mean_force_N"},
}


def changed(**parts: Any) -> dict[str, Any]:
    return {**DEFINITION, **parts}


def test_a_study_is_read_as_it_was_written(tmp_path: Path) -> None:
    text = written(DEFINITION, None)
    data, _ = parse(text, "study")
    assert data == {"format": "arcless-study/1", **DEFINITION}
    loaded = study.load_text(text, tmp_path / "try.yaml", tmp_path)
    assert loaded.plan.count == 6
    assert loaded.plan.values(5) == (26_000.0, 130.0)


def test_a_file_that_is_there_keeps_its_comments() -> None:
    before = written(DEFINITION, None).replace("count: 3", "count: 3   # enough")
    before = before.replace("outputs:", "# What the client asked for.\noutputs:") + "seed: 4\n"
    variables = {
        "tension": {**DEFINITION["variables"]["tension"], "count": 5},
        "mass": {"field": "line.contact_wire.mass", "range": [1.2, 1.5], "count": 2},
    }
    after = written(changed(variables=variables), before)
    assert "count: 5   # enough" in after
    assert "# What the client asked for." in after
    data, _ = parse(after, "study")
    assert data == {"format": "arcless-study/1", **changed(variables=variables), "seed": 4}


def test_what_says_the_same_changes_no_byte() -> None:
    before = written(DEFINITION, None).replace("{kind: grid}", "{kind: grid}  # all of them")
    assert written(DEFINITION, before) == before


def test_an_unknown_field_is_refused() -> None:
    with pytest.raises(ModelError, match="one of: name"):
        written(changed(keep="results"), None)


def test_a_scenario_outside_of_the_folder_is_refused(tmp_path: Path) -> None:
    inside = tmp_path / "project"
    inside.mkdir()
    (tmp_path / "s.yaml").write_text(
        "format: arcless-scenario/1\nname: s\nbase: en50318-ac-simple-275-planar\n"
    )
    text = written(changed(scenario="../s.yaml"), None)
    assert study.load_text(text, inside / "try.yaml").scenario.name == "s"
    with pytest.raises(ModelError, match="scenario"):
        study.load_text(text, inside / "try.yaml", inside)


def test_fields_are_what_set_takes_and_their_ranges_are_valid() -> None:
    scenario = arcless.load("en50318-ac-simple-275-planar")
    found = fields(scenario)
    names = [one.field for one in found]
    assert len(set(names)) == len(names)
    assert {"speed", "line.contact_wire.tension", "pantographs.0.model.masses.0.mass"} <= {*names}
    for one in found:
        if one.offered is None:
            assert one.value == 0.0, one.field
            continue
        low, high = one.offered
        assert low < high
        assert low <= one.value <= high, one.field
        # Each end is accepted where the value stands: the unit is that of the field.
        for end in one.offered:
            amount = f"{end:g} {one.unit}" if one.unit else end
            variable = {"field": one.field, "values": [amount]}
            study.load({**DEFINITION, "set": {}, "variables": {"x": variable},
                        "design": {"kind": "grid"}, "format": "arcless-study/1"})  # fmt: skip


def test_a_field_has_its_value_as_typed() -> None:
    found = {one.field: one for one in fields(arcless.load("en50318-ac-simple-275-planar"))}
    tension = found["line.contact_wire.tension"]
    assert (tension.typed, tension.unit, tension.value) == ("22 kN", "kN", 22.0)
    assert tension.offered == (19.8, 24.2)
    assert found["speed"].offered == (247.5, 302.5)  # km/h
