"""`arcless statics --droppers --supports`: schedules for workshop and site."""

import csv
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

import arcless as package
from arcless.simulate import StaticsResult

Command = Callable[..., Result]
# Lengths are written to 0.1 mm, forces to 0.1 N.
LENGTH, FORCE = 0.5e-4 + 1e-9, 0.05 + 1e-9


def read(path: str) -> list[dict[str, str]]:
    with Path(path).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


# Stitched, compound, two contact wires, in space and in the plane.
@pytest.mark.parametrize(
    "scenario",
    ["norway-s25-250", "shinkansen-compound-240", "spain-ca-160-3kv-160", "praks-250"],
)
def test_schedules_are_those_of_statics(arcless: Command, scenario: str) -> None:
    words = ("--droppers", "d.csv", "--supports", "s.csv", "--allowance", "30 mm")
    done = arcless("statics", scenario, "--json", "--quiet", *words)
    assert done.exit_code == 0
    found, droppers, supports = json.loads(done.stdout), read("d.csv"), read("s.csv")
    assert len(droppers) == len(found["droppers"]) > 0
    for row, told in zip(droppers, found["droppers"], strict=True):
        assert (row["dropper"], row["span"]) == (told["name"], str(told["span"]))
        assert (row["hangs from"], row["holds"]) == (told["from"], told["to"])
        for name, key in (("position", "x_m"), ("length between clamps", "length_m"),
                          ("unstretched length", "unstretched_length_m")):  # fmt: skip
            assert float(row[f"{name} [m]"]) == pytest.approx(told[key], abs=LENGTH)
        cut = told["unstretched_length_m"] + 0.030
        assert float(row["cut length [m]"]) == pytest.approx(cut, abs=LENGTH)
        assert float(row["force at rest [N]"]) == pytest.approx(told["force_N"], abs=FORCE)
        before = max(one["x_m"] for one in found["supports"] if one["x_m"] <= told["x_m"])
        along = float(row["distance from support [m]"])
        assert along == pytest.approx(told["x_m"] - before, abs=LENGTH)
    assert len(supports) == len(found["supports"])
    for row, told in zip(supports, found["supports"], strict=True):
        assert row["support"] == told["name"]
        load = told["messenger_force_N"]
        written = row["vertical load of messenger wire [N]"]
        assert written == "" if load is None else abs(float(written) - load) <= FORCE


def test_stretch_heights_and_stagger_have_known_values(arcless: Command) -> None:
    arcless("statics", "en50318-ac-simple-320", "--quiet", "--droppers", "d.csv", "--supports",
            "s.csv")  # fmt: skip
    for row in read("d.csv"):
        # Droppers of this line have 200 kN/m; without an allowance the unstretched length is cut.
        stretch = float(row["force at rest [N]"]) / 200e3
        free = float(row["unstretched length [m]"])
        between = float(row["length between clamps [m]"])
        assert between - free == pytest.approx(stretch, abs=2 * LENGTH)
        assert row["cut length [m]"] == row["unstretched length [m]"]
    inner = [row for row in read("s.csv") if row["steady-arm force [N]"]]
    assert {abs(float(row["stagger [m]"])) for row in inner} == {0.2}
    for row in inner:
        gap = float(row["height of messenger wire [m]"]) - float(row["height of contact wire [m]"])
        # System height 1.2 m; the springs that hold the wires give by 0.1 mm to 1 mm.
        assert gap == pytest.approx(1.2, abs=2e-3)


def test_a_line_without_a_messenger_wire_has_supports_and_no_droppers(arcless: Command) -> None:
    assert (
        arcless("statics", "conductor-rail-1-120", "--quiet", "--supports", "s.csv").exit_code == 0
    )
    assert all("vertical load of contact wire [N]" in row for row in read("s.csv"))
    done = arcless("statics", "conductor-rail-1-120", "--quiet", "--droppers", "d.csv")
    assert done.exit_code == 2
    assert "a line with droppers" in done.stderr
    assert not Path("d.csv").exists()


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--droppers", "d.csv", "--allowance", "30"], "length without a unit"),
        (["--droppers", "d.csv", "--allowance", "3e1"], "length without a unit"),
        (["--droppers", "d.csv", "--allowance", "-3 mm"], "negative length"),
        (["--droppers", "d.csv", "--allowance", "3 kN"], "--allowance"),
        (["--droppers", "d.csv", "--allowance", "3 m"], "longer than the fittings of a dropper"),
        (["--allowance", "3 mm"], "got no --droppers"),
        (["--droppers", "d.txt"], "not a .csv file"),
        (["--supports", "s"], "got a name without an ending"),
        (["--droppers", "absent/d.csv"], "no folder"),
        (["--droppers", "d.csv", "--supports", "./d.csv"], "one file for two schedules"),
    ],
)
def test_bad_input_is_told_before_anything_is_computed(
    arcless: Command, words: list[str], told: str
) -> None:
    done = arcless("statics", "norway-s25-250", "--quiet", *words)
    assert done.exit_code == 2
    assert told in done.stderr
    assert not list(Path().iterdir())


@pytest.fixture(scope="module")
def norway() -> StaticsResult:
    return package.statics(package.load("norway-s25-250"))


@pytest.mark.parametrize(
    ("given", "told"),
    [
        (-0.1, r"allowance: negative length: got -0\.1 m"),
        (30, r"allowance: longer than the fittings of a dropper: got 30 m"),
        ("3 m", r"allowance: longer than the fittings of a dropper"),
        ("30", r"allowance: length without a unit"),
        ("3 kN", r"allowance: "),
    ],
)
def test_a_wrong_allowance_is_refused_in_python(
    norway: StaticsResult, tmp_path: Path, given: float | str, told: str
) -> None:
    with pytest.raises(package.ModelError, match=told):
        norway.write_droppers(tmp_path / "d.csv", given)
    assert not list(tmp_path.iterdir())


def test_python_takes_an_allowance_with_its_unit(norway: StaticsResult, tmp_path: Path) -> None:
    norway.write_droppers(tmp_path / "text.csv", "30 mm")
    norway.write_droppers(tmp_path / "number.csv", 0.030)
    norway.write_droppers(tmp_path / "none.csv")
    written = [(tmp_path / f"{name}.csv").read_bytes() for name in ("text", "number", "none")]
    assert written[0] == written[1] != written[2]


@pytest.mark.parametrize("name", ["d.xlsx", "d"])
def test_schedules_are_csv_files_in_python_too(
    norway: StaticsResult, tmp_path: Path, name: str
) -> None:
    for write in (norway.write_droppers, norway.write_supports):
        with pytest.raises(package.OutputError, match=r"not a \.csv file"):
            write(tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_a_data_frame_without_an_allowance_has_no_lengths_to_cut(norway: StaticsResult) -> None:
    columns = norway.to_dataframe("droppers").columns
    assert any("unstretched" in str(name).lower() for name in columns)
    assert not any("cut" in str(name).lower() for name in columns)
