"""Pantographs by matrices, lift tables, bump stops and roof motion: what is taken and refused."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load, load_pantograph
from arcless.model.files.csv_tables import parse_table
from arcless.model.pantograph.roof import POINTS

Data = dict[str, Any]

MATRICES: Data = {
    "mass": [[6.0, 0.0], [0.0, 7.5]],
    "damping": [[145.0, -45.0], [-45.0, 45.0]],
    "stiffness": [["7160 N/m", "-7 kN/m"], ["-7 kN/m", "7 kN/m"]],
    "strip": [0.0, 1.0],
    "preload": [1.0, 0.0],
}


def general(**changes: Any) -> Data:
    return {"name": "general", "matrices": {**MATRICES, **changes}}


def refusal(data: Data, load_it: Callable[[Data], Any] = load_pantograph) -> str:
    with pytest.raises(ModelError) as caught:
        load_it(data)
    return str(caught.value)


def test_matrices_take_units_and_survive_a_round_trip() -> None:
    pantograph = load_pantograph(general(lift=[0.0, "0.001 N/(km/h)2"]))
    assert pantograph.matrices is not None
    assert pantograph.matrices.stiffness == ((7160.0, -7000.0), (-7000.0, 7000.0))
    assert pantograph.size == 2
    # 0.001 N/(km/h)² is 0.001 · 3.6² N/(m/s)².
    assert pantograph.lift_at(10.0) == pytest.approx(0.1 * 3.6**2)
    assert load_pantograph(pantograph.to_dict()) == pantograph


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"stiffness": [[7160, -7000], [-7001, 7000]]},
            "matrices.stiffness.1.0: not symmetric: got -7001 in row 2, column 1, and -7000 in"
            " row 1, column 2, expected the same number twice",
        ),
        (
            {"stiffness": [[6000, -7000], [-7000, 7000]]},
            "matrices.stiffness: not positive definite or zero: got a motion of the first 2"
            " coordinates with negative energy, expected a matrix that gives every motion no"
            " negative energy",
        ),
        (
            {"damping": [[-1, 0], [0, 0]]},
            "matrices.damping: not positive definite or zero: got a motion of the first 1"
            " coordinates with negative dissipation",
        ),
        (
            {"mass": [[6, 0], [0, 0]]},
            "matrices.mass: not positive definite: got a motion of the first 2 coordinates with no"
            " inertia, expected a matrix that gives every motion positive inertia",
        ),
        (
            {"damping": [[1, 0]]},
            "matrices.damping: wrong number of values: got 1 rows, expected 2, as many as mass has",
        ),
        (
            {"mass": [[6, 0], [0]]},
            "matrices.mass.1: wrong number of values: got 1 values, expected 2, as many as rows",
        ),
        (
            {"lift": [1.0]},
            "matrices.lift: wrong number of values: got 1 values, expected 2, one for each row",
        ),
        ({"preload": [0, 0]}, "matrices.preload: acts nowhere: got zeros, expected a value"),
        (
            {"strip": [1, 1]},
            "matrices.strip: the strip does not rise with the pantograph: got 2 m when the whole"
            " pantograph is raised by 1 m, expected 1 m: strip and raised belong to the same"
            " coordinates; hint: raised is 1 for every coordinate that is a height; give it for"
            " others",
        ),
        ({"raised": [1, 0]}, "matrices.raised: the strip does not rise with the pantograph"),
        (
            {"stiffness": [["7 kg", 0], [0, 0]]},
            'matrices.stiffness.0.0: got "7 kg", expected a stiffness',
        ),
    ],
)
def test_matrices_that_are_no_pantograph_are_refused(changes: Data, message: str) -> None:
    assert message in refusal(general(**changes))


def test_rounding_of_written_matrices_is_no_asymmetry() -> None:
    rounded = [[7160.0, -7000.000001], [-7000.0, 7000.0]]
    assert load_pantograph(general(stiffness=rounded)).matrices is not None
    # A free mass: no stiffness at all.
    assert load_pantograph(general(stiffness=[[0, 0], [0, 0]])).matrices is not None


MASS: Data = {"mass": 8, "stiffness": 50, "damping": 1}


def chain(**more: Any) -> Data:
    return {"name": "chain", "masses": [{**MASS, **more}]}


@pytest.mark.parametrize(
    ("pantograph", "message"),
    [
        (
            {**chain(), "matrices": MATRICES},
            "matrices: both masses and matrices given: expected masses or matrices",
        ),
        (
            {"name": "none"},
            "masses: missing field: expected masses, from base to head, or matrices",
        ),
        (
            {"name": "none", "masses": []},
            "masses: missing field: expected masses, from base to head, or matrices",
        ),
        (
            chain(aerodynamic=0.1, lift={"speed": [0, 1], "force": [0, 1]}),
            "masses.0.lift: both aerodynamic and lift given: expected aerodynamic or lift",
        ),
        (
            chain(lift={"speed": [0, 10, 10], "force": [0, 1, 2]}),
            "masses.0.lift.speed.2: speeds out of order: got 10 m/s after 10 m/s, expected speeds"
            " that increase",
        ),
        (
            chain(lift={"speed": [0, 10, 20], "force": [0, 1]}),
            "masses.0.lift.force: wrong number of values: got 2 values, expected 3, one for each",
        ),
        (
            chain(stops={"stiffness": 1e6}),
            "masses.0.stops.below: no stop: expected below, above or both",
        ),
        (
            chain(stops={"below": 0.1, "above": 0.1, "stiffness": "rigid"}),
            "masses.0.stops.stiffness: rigid stops on both sides: got below and above, expected one"
            " of them, or a stiffness; hint: the forces of two rigid stops that block one motion"
            " are not unique",
        ),
        (
            chain(stops={"below": "-1 mm", "stiffness": 1e6}),
            'masses.0.stops.below: got "-1 mm", expected a length (m, mm, cm, km, in, ft, yd,'
            " chain, mi), at least 0 m",
        ),
        (
            chain(stops={"below": 0.1, "stiffness": "hard"}),
            'masses.0.stops.stiffness: got "hard", expected a stiffness',
        ),
    ],
)
def test_chains_that_contradict_themselves_are_refused(pantograph: Data, message: str) -> None:
    assert message in refusal(pantograph)


def test_matrices_take_the_place_of_masses_and_back(data: Data) -> None:
    path = "pantographs.0.model"
    scenario = load(data).with_(**{f"{path}.matrices": MATRICES})
    assert scenario.pantographs[0].model.masses == ()
    back = scenario.with_(**{f"{path}.masses": [MASS]})
    assert back.pantographs[0].model.matrices is None
    assert back.pantographs[0].model.size == 1


def test_a_file_takes_the_place_of_points_and_back(data: Data, tmp_path: Path) -> None:
    path = "pantographs.0.roof_motion"
    data["pantographs"][0]["roof_motion"] = {"time": [0, 100], "displacement": [0, "10 mm"]}
    scenario = load(data)
    for name, height in (("one.csv", 0.5), ("two.csv", 0.25)):
        (tmp_path / name).write_text(
            f"position [km], displacement [m]\n0,0\n2,{height}\n", encoding="utf-8"
        )
        scenario = scenario.with_(**{f"{path}.file": str(tmp_path / name)})
        roof = scenario.pantographs[0].roof_motion
        assert roof is not None
        assert (roof.over, roof.points, roof.displacement) == ("position", (0, 2000), (0, height))
    back = scenario.with_(**{f"{path}.time": [0, 50]}).pantographs[0].roof_motion
    assert back is not None
    assert (back.over, back.file) == ("time", None)


def test_a_file_lies_beside_the_scenario(files: Path) -> None:
    scenario = files / "scenario.yaml"
    text = scenario.read_text("utf-8")
    motion = "    roof_motion: {file: roof.csv}\nspeed"
    scenario.write_text(text.replace("speed", motion, 1), "utf-8")
    (files / "roof.csv").write_text("time [s], displacement [mm]\n0, 0\n60, 4\n", "utf-8")
    roof = load(scenario).pantographs[0].roof_motion
    assert roof is not None
    assert (roof.file, roof.time, roof.displacement) == ("roof.csv", (0, 60), (0, 0.004))
    (files / "roof.csv").write_text("time [s], displacement\n0, 0\n", "utf-8")
    with pytest.raises(ModelError, match=r"roof\.csv:1 \(named in .*scenario\.yaml:6\): column"):
        load(scenario)
    (files / "roof.csv").unlink()
    with pytest.raises(ModelError, match=r"roof\.csv \(named in .*scenario\.yaml:6\): no such"):
        load(scenario)


@pytest.mark.parametrize(
    ("roof", "message"),
    [
        ({}, "roof_motion.time: missing field: expected time or position, or a file"),
        (
            {"time": [0, 99], "position": [0, 1], "displacement": [0, 1]},
            "roof_motion.position: both time and position given: expected time or position",
        ),
        (
            {"time": [0, 99], "displacement": [0]},
            "roof_motion.displacement: wrong number of values: got 1 values, expected 2",
        ),
        ({"time": [0], "displacement": [0]}, "roof_motion.time: too few points: got 1"),
        (
            {"time": [0, 9, 9], "displacement": [0, 0, 0]},
            "roof_motion.time.2: points out of order: got 9 s after 9 s, expected a time that",
        ),
        (
            {"time": [0, 1], "displacement": [0, 0]},
            "roof_motion.time: the roof motion does not cover the run: got 0 to 1 s, expected at"
            " least 0 to",
        ),
        (
            {"position": [60, 9e5], "displacement": [0, 0]},
            "roof_motion.position: the roof motion does not cover the run: got 60 to 900000 m,"
            " expected at least 55 to",
        ),
        (
            {"time": [0, 99], "displacement": [0, 30]},
            "roof_motion.displacement.1: got 30, expected",
        ),
    ],
)
def test_roof_motions_that_do_not_fit_are_refused(data: Data, roof: Data, message: str) -> None:
    data["pantographs"][0]["roof_motion"] = roof
    assert message in refusal(data, load)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "roof.csv: empty table: got no header, expected the columns"),
        ("# nothing\n\n", "roof.csv: empty table"),
        ("time s, displacement m\n", "roof.csv: empty table: got a header without rows"),
        ("time, displacement [m]\n", "roof.csv:1: column time: unit missing"),
        ("time [s], height [m]\n", 'roof.csv:1: unknown column: got "height [m]"'),
        ("time [s, displacement [m]\n", 'roof.csv:1: unknown column: got "time [s"'),
        ("time [s], displacement [kg]\n", "kg is the unit of a mass"),
        ("time [s]\n0\n", "roof.csv:1: missing column: got no displacement, expected the columns"),
        ("displacement mm\n0\n", "missing column: got no time or position"),
        (
            "time [s], position [m], displacement [m]\n",
            "roof.csv:1: one column too many: got time and position, expected time or position",
        ),
        ("time [s], time [s]\n", 'roof.csv:1: column given twice: got "time"'),
        ("time [s], displacement [m]\n0, 0\n\n1,\n", "roof.csv:4: displacement: empty cell"),
        ("time [s], displacement [m]\n0, 0\n1\n", "roof.csv:3: wrong number of cells: got 1"),
        ("time [s], displacement [m]\n0, 0,5\n", "hint: write the decimal point as a point"),
        ("time [s], displacement [m]\n0, nan\n", 'displacement: got "nan", expected a number'),
        ("time [s], displacement [m]\n0, 1 mm\n", "roof.csv:2: displacement: got"),
    ],
)
def test_files_that_are_no_roof_motion_are_refused(text: str, message: str) -> None:
    with pytest.raises(ModelError) as caught:
        parse_table(text, "roof.csv", POINTS)
    assert message in str(caught.value)
