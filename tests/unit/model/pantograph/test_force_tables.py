"""Tables, friction and stops of pantographs: what is read, and what is refused."""

from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load, load_pantograph

Data = dict[str, Any]
SPRING: Data = {"elongation": ["-20 mm", 0, "0.1 m"], "force": ["-100 N", 0, "1 kN"]}
DAMPER: Data = {"velocity": [-1, 0, 1], "force": [-60, 0, 80]}


def chain(**joint: Any) -> Data:
    mass = {"mass": 8, "stiffness": 50, "damping": 1, **joint}
    return {"name": "chain", "masses": [{k: v for k, v in mass.items() if v is not None}]}


def general(**more: Any) -> Data:
    square = [[2, 0], [0, 2]]
    vectors = {"strip": [0, 1], "preload": [1, 0]}
    matrices = {"mass": square, "damping": square, "stiffness": square, **vectors, **more}
    return {"name": "general", "matrices": matrices}


def test_a_table_takes_the_place_of_a_number() -> None:
    mass = load_pantograph(chain(stiffness=None, stiffness_table=SPRING)).masses[0]
    assert mass.stiffness is None
    assert mass.stiffness_table is not None
    assert mass.stiffness_table.points == [(-0.02, -100.0), (0.0, 0.0), (0.1, 1000.0)]


def test_friction_is_a_steep_damper_up_to_the_sliding_speed() -> None:
    friction = load_pantograph(chain(friction={"force": 12})).masses[0].friction
    assert friction is not None
    assert friction.points == [(-2e-3, -12), (-1e-3, -12), (1e-3, 12), (2e-3, 12)]


@pytest.mark.parametrize(
    ("pantograph", "message"),
    [
        (
            chain(stiffness=None),
            "masses.0.stiffness: missing field: expected Spring to the mass below, or to the base"
            " frame: a stiffness (N/m, kN/m, N/mm, MN/m, kN/mm, daN/m, kgf/m, kgf/mm, lbf/ft,"
            " lbf/in), at least 0 N/m and at most"
            " 1e+13 N/m, or stiffness_table",
        ),
        (
            chain(damping_table=DAMPER),
            "masses.0.damping_table: both damping and damping_table given: expected damping or"
            " damping_table",
        ),
        (
            chain(stiffness=None, stiffness_table={"elongation": [0], "force": [0]}),
            "masses.0.stiffness_table.elongation: too few points: got 1, expected at least 2 of"
            " elongation and force, or a file",
        ),
        (
            chain(stiffness=None, stiffness_table={"elongation": [0, 1], "force": [0]}),
            "masses.0.stiffness_table.force: wrong number of values: got 1 values, expected 2, one"
            " for each of elongation",
        ),
        (
            chain(stiffness=None, stiffness_table={"elongation": [0, 0], "force": [0, 1]}),
            "masses.0.stiffness_table.elongation.1: points out of order: got 0 m after 0 m,"
            " expected elongation that increases",
        ),
        (
            chain(stiffness=None, stiffness_table={"elongation": [0, 1], "force": [0, -1]}),
            "masses.0.stiffness_table.force.1: falling force: got -1 N after 0 N, expected a force"
            " that does not fall while elongation grows",
        ),
        (
            chain(damping=None, damping_table={"velocity": [-1, 1], "force": [0, 10]}),
            "masses.0.damping_table.force: no force of zero at velocity 0: got 5 N, expected a"
            " damper that is without force at rest; hint: give the table the"
            " point 0 m/s with 0 N; what holds at rest is friction",
        ),
        (
            chain(damping=None, damping_table={"velocity": [1, 2], "force": [1, 2]}),
            "no force of zero at velocity 0: got 1 to 2 m/s",
        ),
        (chain(friction={"force": 0}), "masses.0.friction.force: got 0, expected a force"),
        (
            chain(friction={"force": 5, "sliding_speed": 0}),
            "masses.0.friction.sliding_speed: got 0, expected a speed",
        ),
        (
            general(joints=[{"between": [-1, 1]}]),
            "matrices.joints.0.between: nothing given: expected stops, stiffness_table,"
            " damping_table or friction",
        ),
        (
            general(joints=[{"between": [-1, 1, 0], "friction": {"force": 5}}]),
            "matrices.joints.0.between: wrong number of values: got 3 values, expected 2",
        ),
        (
            general(joints=[{"between": [0, 0], "friction": {"force": 5}}]),
            "matrices.joints.0.between: acts nowhere: got zeros",
        ),
        (
            general(lift_tables=[{"on": [1], "speed": [0, 9], "force": [0, 1]}]),
            "matrices.lift_tables.0.on: wrong number of values: got 1 values, expected 2",
        ),
    ],
)
def test_what_contradicts_itself_is_refused(pantograph: Data, message: str) -> None:
    with pytest.raises(ModelError) as caught:
        load_pantograph(pantograph)
    assert message in str(caught.value)


def test_a_table_comes_from_a_file_once(tmp_path: Path) -> None:
    (tmp_path / "spring.csv").write_text("elongation mm, force [kN]\n-20, -0.1\n0, 0\n100, 1\n")
    text = """
        format: arcless-pantograph/1
        name: filed
        masses:
          - {mass: 8 kg, damping: 1, stiffness_table: {file: spring.csv}}
        static_force: 80 N
    """
    (tmp_path / "filed.yaml").write_text("\n".join(line[8:] for line in text.splitlines()))
    pantograph = load_pantograph(tmp_path / "filed.yaml")
    table = pantograph.masses[0].stiffness_table
    assert table is not None
    assert table.points == [(-0.02, -100.0), (0.0, 0.0), (0.1, 1000.0)]
    (tmp_path / "spring.csv").unlink()
    assert load_pantograph(pantograph.to_dict()) == pantograph


def test_a_wrong_file_is_named_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "spring.csv").write_text("elongation mm, speed [kN]\n")
    (tmp_path / "filed.yaml").write_text(
        "format: arcless-pantograph/1\nname: filed\nmasses:\n"
        "  - {mass: 8 kg, damping: 1, stiffness_table: {file: spring.csv}}\n"
    )
    with pytest.raises(ModelError, match=r"spring\.csv:1 \(named in .*filed\.yaml:4\)"):
        load_pantograph(tmp_path / "filed.yaml")


def test_a_lift_table_beside_matrices_must_reach_over_the_speeds() -> None:
    table = {"on": [1, 0], "speed": [0, 40], "force": [0, 10]}
    short = {"line": "ac-simple-55", "speed": "160 km/h", "name": "short"}
    placement = {"model": general(lift_tables=[table]), "static_force": 80}
    with pytest.raises(ModelError, match=r"matrices\.lift_tables\.0\.speed: the table does not"):
        load({**short, "pantographs": [placement]})
    lifted = load({**short, "pantographs": [placement], "speed": "100 km/h"}).pantographs[0].model
    # raised · on = 1: all of the force reaches the strip.
    assert lifted.lift_at(20.0) == 5.0
