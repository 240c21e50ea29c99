"""Texts of model files for the editor: places, mistakes, common fields, changes."""

from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import ArclessError, ModelError
from arcless.model import Scenario
from arcless.model.load import load_text
from arcless.studio.model_text.about import about
from arcless.studio.model_text.check import check
from arcless.studio.model_text.form import form
from arcless.studio.model_text.places import places
from arcless.studio.model_text.routes import begun, patched
from arcless.studio.project.project import Project

MODELS = Path(arcless.__file__).parent / "models"
TEXT = (MODELS / "lines" / "ac-simple-55-3d.yaml").read_text("utf-8")


def checked(text: str, folder: Path = MODELS) -> dict[str, Any]:
    return check(text, "line.yaml", folder / "line.yaml", folder)


def fields(text: str) -> dict[str, Any]:
    return {one["field"]: one for group in form(text, "a")["groups"] for one in group["fields"]}


def test_places_hold_exactly_the_field() -> None:
    rows = TEXT.split("\n")
    found = places(TEXT, "a")
    place = found["contact_wire.tension"]
    row = rows[place["line"] - 1]
    assert place["line"] == place["end_line"]
    assert row[place["column"] - 1 : place["end_column"] - 1].startswith("tension: {value: 22 kN")
    assert row[place["end_column"] - 2] == "}"
    item = found["span_types.standard.droppers.positions.1"]
    assert rows[item["line"] - 1][item["column"] - 1 : item["end_column"] - 1] == "10.25"
    block = found["contact_wire"]
    assert rows[block["line"] - 1] == "contact_wire:"
    assert rows[block["end_line"] - 1].strip().startswith("ends:")


def test_mistakes_have_the_place_of_their_field_each() -> None:
    text = TEXT.replace("22 kN", "22 km", 1).replace("16 kN", "16 km", 1)
    assert checked(TEXT)["errors"] == []
    (error,) = checked(TEXT + "nonsense: 1\n")["errors"]
    assert (TEXT + "nonsense: 1").split("\n")[error["line"] - 1] == "nonsense: 1"
    assert error["where"].startswith("line.yaml:")
    one, other = checked(text)["errors"]
    assert "22 km" in text.split("\n")[one["line"] - 1]
    assert "16 km" in text.split("\n")[other["line"] - 1]
    broken = checked("format: arcless-line/1\na: [\n")
    assert broken["errors"][0]["line"] >= 2
    assert broken["kind"] == "line"


def test_a_reference_out_of_the_folder_is_a_mistake(tmp_path: Path) -> None:
    (tmp_path / "outside.yaml").write_text(TEXT, "utf-8")
    inside = tmp_path / "folder"
    inside.mkdir()
    text = "format: arcless-scenario/1\nname: a\nline: ../outside.yaml\nspeed: 100 km/h\n"
    text += "pantographs: [{model: dsa-380, static_force: 70 N}]\n"
    (error,) = checked(text, inside)["errors"]
    assert "outside of the folder" in error["text"]


def test_common_fields_are_as_typed_and_in_si() -> None:
    found = fields(TEXT)
    tension = found["contact_wire.tension"]
    assert (tension["typed"], tension["value"], tension["unit"]) == ("22 kN", 22e3, "N")
    assert tension["required"]
    assert "kN" in tension["units"]
    assert tension["minimum"] is not None
    stagger = found["geometry.stagger_contact_wire"]
    assert stagger["typed"] == ["0.20 m", "-0.20 m"]
    assert stagger["value"] == [0.2, -0.2]
    assert found["spans"]["typed"] == [{"type": "standard", "count": 20}]
    assert found["steady_arm.kind"]["choices"] == ["spring", "arm", "none"]
    assert "steady_arm.vertical_stiffness" not in found
    assert TEXT.split("\n")[tension["line"] - 1].strip().startswith("tension:")


@pytest.mark.parametrize(
    "file", sorted(path for kind in ("lines", "pantographs", "scenarios")
                   for path in (MODELS / kind).glob("*.yaml")), ids=lambda path: path.stem
)  # fmt: skip
def test_every_shipped_model_has_fields_that_can_be_changed(file: Path) -> None:
    text = file.read_text("utf-8")
    found = fields(text)
    assert found
    for field, own in found.items():
        assert own["description"], field
        if isinstance(own["value"], float):
            same = patched(text, {field: own["typed"]}, "a")
            assert same == text, field


def test_fields_of_a_line_in_a_scenario_and_none_of_what_is_no_model() -> None:
    inner = "\n".join(f"  {row}" for row in TEXT.splitlines())
    found = fields(f"format: arcless-scenario/1\nline:\n{inner}\n")
    assert found["line.contact_wire.tension"]["value"] == 22e3
    for text in ("", "a: [", "format: arcless-study/1\n", "format: arcless-line/1\na: b: c"):
        assert form(text, "a") == {"groups": []}


def test_a_change_keeps_all_else_and_none_takes_a_field_away() -> None:
    changes: dict[str, Any] = {"contact_wire.tension": "24 kN", "support.vertical_damping": None}
    after = patched(TEXT, changes, "a")
    kept = [row for row in TEXT.split("\n") if "vertical_damping" not in row]
    assert after == "\n".join(kept).replace("22 kN", "24 kN", 1)
    with pytest.raises(ModelError):
        patched(TEXT, {"contact_wire.nothing": None}, "a")


def test_lists_of_the_same_droppers_are_told_to_be_together() -> None:
    found = fields(TEXT)
    own = "span_types.standard.droppers"
    assert {one["field"] for one in found.values() if one["together"] == own} == {
        f"{own}.positions", f"{own}.presag",
    }  # fmt: skip
    assert found["spans"]["together"] is None


def test_nothing_is_known_of_what_is_no_field() -> None:
    assert about("line", ("nothing",)) is None


def test_a_model_begins_as_a_copy_of_a_shipped_one_and_of_nothing_else(tmp_path: Path) -> None:
    folder = tmp_path / "folder"
    folder.mkdir()
    project = Project.of(folder)
    assert begun(project, "mine", "shipped:line/ac-simple-55-3d", False) == "mine.yaml"
    assert "tension: {value: 22 kN" in (folder / "mine.yaml").read_text("utf-8")
    (tmp_path / "outside.yaml").write_text(TEXT, "utf-8")
    shipped = "shipped:line/ac-simple-55"
    two = "shipped:scenario/germany-re-200-200"
    assert begun(project, "pair", two, False, "tsi") == "pair.yaml"
    assert "distance: {value: tsi" in (folder / "pair.yaml").read_text("utf-8")
    with pytest.raises(ArclessError, match="begin with a scenario"):
        begun(project, "b", shipped, False, "tsi")
    wrong = [("mine", shipped), ("../a", shipped), ("a", "shipped:line/nothing")]
    wrong += [("a", "mine.yaml"), ("a", "../outside.yaml"), ("a", f"{tmp_path}/outside.yaml")]
    for name, source in wrong:
        with pytest.raises(ArclessError):
            begun(project, name, source, False)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["folder", "outside.yaml"]


def test_the_form_of_a_variant_has_what_it_sets_and_what_its_base_has() -> None:
    text = (
        "format: arcless-scenario/1\nname: v\nbase: en50318-ac-simple-275-planar\nset:\n"
        "  line.contact_wire.tension: 24 kN\n  pantographs.0.mean_force: {value: 150 N, mark: D}\n"
    )
    file = Path("v.yaml").absolute()
    scenario = load_text(text, file, file.parent)
    assert isinstance(scenario, Scenario)
    groups = form(text, "v.yaml", scenario)["groups"]
    found = {one["field"]: one for group in groups for one in group["fields"]}
    speed = found["set.speed"]
    assert (speed["typed"], speed["inherited"]) == (None, "275 km/h")
    assert speed["value"] == pytest.approx(275 / 3.6)
    tension = found["set.line.contact_wire.tension"]
    assert (tension["typed"], tension["value"], tension["line"]) == ("24 kN", 24e3, 5)
    assert tension["label"] == "Line contact wire: tension"
    force = found["set.pantographs.0.mean_force"]
    assert (force["typed"], force["inherited"], force["unit"]) == ("150 N", None, "N")
    assert found["set.pantographs.0.model"]["inherited"] == "ac-simple"
    # One excludes the other.
    assert "set.pantographs.0.static_force" not in found
    other = text.replace("mean_force: {value: 150 N, mark: D}", "static_force: 130 N")
    scenario_of_other = load_text(other, file, file.parent)
    assert isinstance(scenario_of_other, Scenario)
    names = [
        one["field"]
        for group in form(other, "v.yaml", scenario_of_other)["groups"]
        for one in group["fields"]
    ]
    assert "set.pantographs.0.static_force" in names
    assert "set.pantographs.0.mean_force" not in names
    # Each number that is offered can be typed over: the text is a variant that can be run.
    for field, one in found.items():
        if isinstance(one["value"], float):
            new = patched(text, {field: one["typed"] or one["inherited"]}, "v.yaml")
            load_text(new, file, file.parent)
    # What it sets is told, too, where the base cannot be read.
    alone = form(text, "v.yaml", None)["groups"]
    assert [group["title"] for group in alone] == ["Run", "Set by this variant"]
