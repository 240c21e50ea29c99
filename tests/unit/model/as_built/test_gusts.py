"""Gusts in a scenario: what is taken from lists and files, and what is refused."""

from pathlib import Path

import pytest

from arcless.errors import ModelError
from arcless.model import Scenario, load

SPATIAL = "solver: {dimension: spatial}\n"
GOOD = """# mast 7 and mast 12
time [s], position [m], speed [m/s], vertical [km/h]
0, 120, 8, 0
0, 60, 5, 0
60, 60, 9, 3.6
60, 120, -2, 7.2
"""


def blown(files: Path, text: str = "  gusts: gusts.csv\n", *, spatial: str = SPATIAL) -> Path:
    path = files / "scenario.yaml"
    changes = f"{spatial}as_built:\n{text}"
    path.write_text(path.read_text("utf-8") + changes, encoding="utf-8")
    line = files / "line.yaml"
    wide = line.read_text("utf-8")
    for name in ("contact_wire", "messenger_wire"):
        wide = wide.replace(f"{name}:\n", f"{name}:\n  diameter: 12 mm\n", 1)
    line.write_text(wide, encoding="utf-8")
    return path


def complaint(path: Path) -> str:
    with pytest.raises(ModelError) as caught:
        load(path)
    return str(caught.value).replace(f"{path.parent}/", "")


def test_a_file_holds_readings_of_several_places(files: Path) -> None:
    (files / "gusts.csv").write_text(GOOD, encoding="utf-8")
    scenario = load(blown(files))
    gusts = scenario.as_built.gusts
    assert gusts is not None
    assert gusts.stations() == {60.0: [1, 2], 120.0: [0, 3]}
    assert gusts.vertical == (0.0, 0.0, 1.0, 2.0)
    assert scenario.as_built.is_empty, "at rest the line is as designed"
    assert Scenario.model_validate(scenario.to_dict()) == scenario


def test_a_file_may_say_where_it_comes_from(files: Path) -> None:
    (files / "gusts.csv").write_text(GOOD, encoding="utf-8")
    scenario = load(blown(files, "  gusts: {value: gusts.csv, mark: assumed, note: sonic}\n"))
    assert scenario.as_built.gusts is not None
    assert scenario.provenance["as_built.gusts"].note == "sonic"
    rows = "".join(f"{t}, {5 + t % 3}\n" for t in range(2000))
    (files / "gusts.csv").write_text(f"time s, speed m/s\n{rows}", encoding="utf-8")
    given = load(files / "scenario.yaml").provenance["as_built.gusts"].given
    assert given.startswith("{time: [0.0, 1.0,") and len(given) < 3000


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("time s\n0\n", "gusts.csv:1 (named in scenario.yaml:9): missing column: got no speed"),
        (
            "time s, speed\n0, 1\n",
            "column speed: unit missing: expected a speed (m/s, km/h, mph, ft/s)",
        ),
        ("time s, speed m\n0, 1\n", "m is the unit of a length"),
        ("time s, speed m/s\n0, 1\n2,\n", "gusts.csv:3 (named in"),
        ("time s, speed m/s\n0, 1\n", "too few readings: got 1, expected at least 2"),
        ("time s, speed m/s\n0, 1\n1, 2\n1, 3\n", "readings out of order: got 1 s after 1 s"),
        (
            "time s, position m, speed m/s\n0, 5, 1\n9, 5, 2\n0, 8, 2\n",
            "too few readings at 8 m: got 1",
        ),
        ("time s, speed m/s\n0, 1\n0.1, 2\n", "the gusts do not cover the run: got 0 to 0.1 s"),
        (
            "time s, position m, speed m/s\n0, 5, 1\n99, 5, 2\n1, 8, 2\n99, 8, 2\n",
            "the gusts at 8 m do not cover the run: got 1 to 99 s, expected at least 0 to",
        ),
        ("time s, speed m/s\n0, 1\n99, 200\n", "as_built.gusts.speed.1: got 200.0, expected"),
    ],
)
def test_faulty_files_are_refused(files: Path, text: str, message: str) -> None:
    (files / "gusts.csv").write_text(text, encoding="utf-8")
    assert message in complaint(blown(files))


def test_lists_of_different_length_are_refused(files: Path) -> None:
    path = blown(files, "  gusts: {time: [0, 99], speed: [1]}\n")
    assert "as_built.gusts.speed: wrong number of values: got 1 values" in complaint(path)


def test_a_planar_line_cannot_be_blown(files: Path) -> None:
    (files / "gusts.csv").write_text(GOOD, encoding="utf-8")
    message = complaint(blown(files, spatial=""))
    assert "as_built.gusts: wind on a planar line" in message


def test_wires_need_a_diameter(files: Path) -> None:
    (files / "gusts.csv").write_text(GOOD, encoding="utf-8")
    path = blown(files)
    line = files / "line.yaml"
    line.write_text(line.read_text("utf-8").replace("  diameter: 12 mm\n", "", 1), "utf-8")
    assert "as_built.gusts: wind on a wire without diameter" in complaint(path)
