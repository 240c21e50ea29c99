"""The section as_built: what it takes, what it refuses, and its CSV file."""

import re
from collections.abc import Callable
from math import cos, pi
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import ModelError
from arcless.model import AsBuilt, Ice, Scenario, Wind, load
from arcless.model.files.csv_tables import LISTS, read_table

Refused = Callable[..., str]
GOOD = "span, dropper, length_error mm\n# read on site\n3, 2, 12.1\n\n4, 1, -5\n"


def built(files: Path, text: str) -> Path:
    path = files / "scenario.yaml"
    path.write_text(path.read_text("utf-8") + f"as_built:\n  {text}\n", encoding="utf-8")
    return path


def complaint(files: Path, text: str) -> str:
    with pytest.raises(ModelError) as caught:
        load(built(files, text))
    return str(caught.value).replace(f"{files}/", "")


def test_nothing_differs_by_default(files: Path) -> None:
    scenario = load(files / "scenario.yaml")
    assert scenario.as_built == AsBuilt()
    assert scenario.as_built.is_empty


def test_a_csv_file_is_the_list_it_holds(files: Path) -> None:
    (files / "errors.csv").write_text(GOOD, encoding="utf-8")
    scenario = load(built(files, "dropper_length_errors: errors.csv"))
    found = [(e.span, e.dropper, e.length_error) for e in scenario.as_built.dropper_length_errors]
    assert found == [(3, 2, 0.0121), (4, 1, -0.005)]
    again = Scenario.model_validate(scenario.to_dict())
    assert again == scenario, "a result holds the values, not the name of a file"


@pytest.mark.parametrize("head", ["length_error mm", "length_error [mm]", "length_error(mm)"])
def test_a_unit_stands_in_brackets_or_not(files: Path, head: str) -> None:
    (files / "errors.csv").write_text(f"span,dropper,{head}\n3,2,12\n", encoding="utf-8")
    scenario = load(built(files, "dropper_length_errors: errors.csv"))
    assert scenario.as_built.dropper_length_errors[0].length_error == 0.012


def test_a_csv_file_may_say_where_it_comes_from(files: Path) -> None:
    (files / "errors.csv").write_text(GOOD, encoding="utf-8")
    text = "dropper_length_errors: {value: errors.csv, mark: assumed, note: measured}"
    scenario = load(built(files, text))
    assert len(scenario.as_built.dropper_length_errors) == 2
    assert scenario.provenance["as_built.dropper_length_errors"].note == "measured"


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("span,dropper\n1,1\n", ["errors.csv:1", "missing column", "no length_error"]),
        ("span,dropper,length_error\n1,1,2\n", ["unit missing", "length_error mm"]),
        ("span,dropper,length_error kg\n1,1,2\n", ["column length_error", '"kg"', "a mass"]),
        ("span m,dropper,length_error mm\n1,1,2\n", ["column span", "without unit"]),
        ("span,droper,length_error mm\n1,1,2\n", ["unknown column", "did you mean dropper?"]),
        ("span,span,length_error mm\n1,1,2\n", ["column given twice"]),
        ("span;dropper;length_error mm\n1;1;2\n", ["commas"]),
        ("span,dropper,length_error mm\n1,1,2\n1,2\n", ["errors.csv:3", "cells", "got 2"]),
        ("span,dropper,length_error mm\n1,1,2,5\n", ["errors.csv:2", "decimal point"]),
        ("span,dropper,length_error mm\n1,,2\n", ["errors.csv:2", "dropper: empty cell"]),
        ("span,dropper,length_error mm\n1,1.5,2\n", ['got "1.5"', "a whole number"]),
        ("span,dropper,length_error mm\n1,1,2 mm\n", ['"2 mm"', "a number in mm"]),
        ("span,dropper,length_error mm\n1,1,nan\n", ["length_error", "finite"]),
        ("span,dropper,length_error mm\n", ["empty table", "a header without rows"]),
        ("", ["empty table", "no header"]),
        ("span,dropper,length_error mm\n1,1,9000\n", ["length_error", "at most 2 m"]),
        ("span,dropper,length_error mm\n1,1,2\n1,1,3\n", ["given twice", "span 1 dropper 1"]),
        ("span,dropper,length_error mm\n3,7,2\n", ["unknown dropper", "mean span 3 dropper 4?"]),
    ],
)
def test_a_faulty_csv_file_is_refused(files: Path, text: str, parts: list[str]) -> None:
    (files / "errors.csv").write_text(text, encoding="utf-8")
    message = complaint(files, "dropper_length_errors: errors.csv")
    assert all(part in message for part in parts), message
    assert "scenario.yaml:8" in message


def test_heights_of_supports_from_a_csv_file(files: Path) -> None:
    (files / "heights.csv").write_text("support,height_error mm\n2,12\n5,-8.5\n", "utf-8")
    scenario = load(built(files, "support_height_errors: heights.csv"))
    found = [(e.support, e.height_error) for e in scenario.as_built.support_height_errors]
    assert found == [(2, 0.012), (5, -0.0085)]
    assert not scenario.as_built.is_empty


def test_a_support_of_an_overlap_needs_its_tension_length() -> None:
    base = load("ac-simple-overlap-275")
    number = base.line.tension_length_list()[1].from_span + 1
    error: dict[str, Any] = {"support": number, "height_error": "3 mm"}
    with pytest.raises(ModelError, match=r"fits several supports.*tension length 1.* or tension"):
        base.with_(**{"as_built.support_height_errors": [error]})
    both = [{**error, "tension_length": length} for length in (1, 2)]
    found = base.with_(**{"as_built.support_height_errors": both}).as_built
    assert len(found.support_height_errors) == 2


def test_a_csv_file_that_is_not_there(files: Path) -> None:
    message = complaint(files, "dropper_length_errors: eror.csv")
    assert "eror.csv" in message
    assert "no such file" in message


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("missing_droppers: [span 3 dropper 9]", ["span 3 dropper 4?", "span 3 has 4 droppers"]),
        ("missing_droppers: [span 12 dropper 1]", ["did you mean span 8 dropper 1?"]),
        ("missing_droppers: [dropper 3]", ["not a dropper", "span 3 dropper 2"]),
        ("missing_droppers: [{span: 0, dropper: 1}]", ["unknown dropper", "span 1 dropper 1"]),
        ("missing_droppers: [span 1 dropper 1, span 1  dropper 1]", ["given twice"]),
        (
            "missing_droppers: [span 1 dropper 1]\n"
            "  dropper_length_errors: [{span: 1, dropper: 1, length_error: 3 mm}]",
            ["length error of a missing dropper"],
        ),
        (
            "support_height_errors: [{support: 1, height_error: 3 mm}]",
            ["no support that holds wires: got support 1", "a support from 2 to 8", "anchored"],
        ),
        ("support_height_errors: [{support: 99, height_error: 3 mm}]", ["got support 99"]),
        (
            "support_height_errors: [{support: 2, height_error: 1}, {support: 2, height_error: 1}]",
            ["support given twice: got support 2"],
        ),
        ("support_height_errors: [{support: 2, height_error: 3}]", ["at most 2 m"]),
        ("temperature_difference: 30 kg", ["a temperature difference (K)", "unit of a mass"]),
        ("ice: {contact_wire: 2 kg}", ["a mass per length"]),
        ("wear: []", ["unknown field", "contact_wire_wear"]),
        ("contact_wire_wear: [{from: 400, to: 500, fraction: 0.1}]", ["outside the line", "440"]),
        ("contact_wire_wear: [{from: 50, to: 40, fraction: 0.1}]", ["behind from, 50 m"]),
        ("contact_wire_wear: [{from: 50, to: 60, fraction: 1}]", ["at most 0.8"]),
        (
            "contact_wire_wear: [{from: 5, to: 9, fraction: 0.1}, {from: 8, to: 9, fraction: 0.1}]",
            ["overlap", "8 m"],
        ),
        ("wind: {speed: 30 m/s}", ["planar line", "solver.dimension to spatial"]),
        ("wind: {speed: 30 m/s}\nsolver: {dimension: planar}", ["dimension planar"]),
        ("wind: {speed: 30 m/s}\nsolver: {dimension: spatial}", ["line.contact_wire.diameter"]),
    ],
)
def test_what_does_not_fit_is_refused(files: Path, text: str, parts: list[str]) -> None:
    message = complaint(files, text)
    assert all(part in message for part in parts), message


def test_changes_by_dotted_path(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (files / "errors.csv").write_text(GOOD, encoding="utf-8")
    monkeypatch.chdir(files)
    scenario = load("scenario.yaml").with_(
        **{
            "as_built.temperature_difference": "30 K",
            "as_built.ice.contact_wire": "0.5 kg/m",
            "as_built.dropper_length_errors": "errors.csv",
            "as_built.missing_droppers": [{"span": 2, "dropper": 1}, "span 5 dropper 3"],
        }
    )
    assert scenario.as_built.temperature_difference == 30.0
    assert scenario.as_built.ice.contact_wire == 0.5
    assert len(scenario.as_built.dropper_length_errors) == 2
    assert scenario.as_built.missing_droppers == ("span 2 dropper 1", "span 5 dropper 3")


def test_force_of_the_wind() -> None:
    across, up = Wind(speed=30, angle=0.1, air_density=1.25, drag_coefficient=1.2).force(0.012)
    # ½ · 1.25 · 900 · 1.2 · 0.012 = 8.1 N/m, by hand.
    assert across == pytest.approx(8.1 * cos(0.1), rel=1e-12)
    assert up == pytest.approx(8.1 * 0.0998334166, rel=1e-9)
    opposite = Wind(speed=-30, angle=0.1, air_density=1.25, drag_coefficient=1.2).force(0.012)
    assert opposite == pytest.approx((-across, up))


def test_a_coat_of_ice_is_as_thick_as_its_mass_says() -> None:
    diameter = Ice(density=900).diameter(0.012, 0.5)
    # Round-off; the square root is taken back.
    assert 900 * pi / 4 * (diameter**2 - 0.012**2) == pytest.approx(0.5, rel=1e-12)
    assert Ice().diameter(0.012, 0.0) == pytest.approx(0.012, rel=1e-12)


def test_the_example_of_the_guide_loads(tmp_path: Path) -> None:
    page = (Path(__file__).parents[4] / "docs/guide/as-built.md").read_text("utf-8")
    blocks = re.findall(r"```(?:yaml|csv)\n# ([a-z]+\.(?:yaml|csv))(.*?)```", page, re.DOTALL)
    assert [name for name, _ in blocks] == [
        "winter.yaml", "measured.csv", "survey.csv", "gusts.csv",
    ]  # fmt: skip
    for name, text in blocks:
        (tmp_path / name).write_text(f"# {text}", encoding="utf-8")
    built = load(tmp_path / "winter.yaml").as_built
    assert [e.length_error for e in built.dropper_length_errors] == [0.012, -0.0045]
    assert built.missing_droppers == ("span 10 dropper 5",)
    survey = read_table(tmp_path / "survey.csv", LISTS["measured_heights"])
    assert survey == {"position": [0, 4.5, 10.25], "height": [5.301, 5.299, 5.302]}
    wires = {f"line.{name}_wire.diameter": "12 mm" for name in ("contact", "messenger")}
    changes = {**wires, "as_built.gusts": str(tmp_path / "gusts.csv")}
    gusts = load("en50318-ac-simple-275").with_(**changes).as_built.gusts
    assert gusts is not None
    assert list(gusts.stations()) == [400, 700]


def test_the_shipped_scenarios_are_as_designed() -> None:
    for entry in arcless.library():
        if entry.kind == "scenario":
            found: Any = load(entry.name)
            assert found.as_built.is_empty, entry.name
