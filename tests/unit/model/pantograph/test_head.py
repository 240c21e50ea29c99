"""Collector heads: what is taken, and what is refused with which sentence."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load_pantograph

Data = dict[str, Any]

ROLL: Data = {"inertia": "0.8 kg m²", "stiffness": "1.7 kN m/rad", "damping": "11 N m s/rad"}
MODE: Data = {"frequency": 60, "modal_mass": 1.9, "shape": [1, -0.2, -0.6, -0.2, 1]}
PLACES = [-0.8, -0.4, 0, 0.4, 0.8]


def with_head(**changes: Any) -> Data:
    head = {
        "strip_spacing": "580 mm",
        "half_length": 0.8,
        "mass": 3.75,
        "stiffness": "3.5 kN/m",
        "damping": 22.5,
        **changes,
    }
    head = {name: value for name, value in head.items() if value is not None}
    masses = [{"mass": 6, "stiffness": 160, "damping": 100, "aerodynamic": 0.01}]
    return {"name": "two strips", "masses": masses, "head": head}


def refusal(data: Data) -> str:
    with pytest.raises(ModelError) as caught:
        load_pantograph(data)
    return str(caught.value)


def test_units_coordinates_and_round_trip() -> None:
    pantograph = load_pantograph(with_head(roll=ROLL, shape_positions=PLACES, modes=[MODE]))
    assert pantograph.head is not None and pantograph.head.roll is not None
    assert pantograph.head.roll.stiffness == 1700.0
    # One mass; then height, roll angle and one mode of each strip.
    assert pantograph.size == 7
    assert pantograph.heights == [0, 1, 4]
    assert pantograph.rolls == [2, 5]
    assert pantograph.head.offsets() == (-0.29, 0.29)
    assert load_pantograph(pantograph.to_dict()) == pantograph


def test_every_strip_takes_its_share_of_the_air() -> None:
    pantograph = load_pantograph(with_head(aerodynamic=0.02))
    assert pantograph.lift_at(10.0) == pytest.approx((0.01 + 2 * 0.02) * 100.0)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"strip_spacing": None}, "head.strip_spacing: strip spacing: got none, expected a dist"),
        (
            {"strips": 1},
            "head.strip_spacing: strip spacing: got 0.58 m, expected none for a single strip",
        ),
        ({"strips": 9}, "head.strips"),
        ({"half_length": None}, "head.half_length: missing field"),
        ({"stiffness": 0}, "head.stiffness"),
        ({"roll": {**ROLL, "stiffness": 0}}, "head.roll.stiffness"),
        ({"modes": [MODE]}, "modes and shape_positions belong together: got modes alone"),
        ({"shape_positions": PLACES}, "got shape_positions alone, expected both, or neither"),
        (
            {"modes": [MODE], "shape_positions": [-0.8, -0.4, 0, 0.4, 0.7]},
            "head.shape_positions: the mode shapes do not reach over the strip: got -0.8 m to"
            " 0.7 m, expected at least -0.8 m to 0.8 m",
        ),
        (
            {"modes": [{**MODE, "shape": [1, 1]}], "shape_positions": PLACES},
            "head.modes.0.shape: wrong number of values: got 2 values, expected 5",
        ),
        (
            {"modes": [{**MODE, "shape": [0] * 5}], "shape_positions": PLACES},
            "head.modes.0.shape: a mode without a shape",
        ),
        (
            {"modes": [MODE], "shape_positions": [-0.8, 0.4, 0, 0.4, 0.8]},
            "head.shape_positions.2: positions out of order: got 0 m after 0.4 m",
        ),
        ({"modes": [MODE], "shape_positions": [-1, 1]}, "too few points of a mode shape: got 2"),
    ],
)
def test_bad_heads_are_refused_with_the_place(changes: Data, message: str) -> None:
    assert message in refusal(with_head(**changes))


def test_a_head_needs_masses_below_it() -> None:
    data = with_head()
    data["masses"] = []
    data["matrices"] = {
        "mass": [[6]],
        "damping": [[0]],
        "stiffness": [[160]],
        "strip": [1],
        "preload": [1],
    }
    assert "head: a head on matrices" in refusal(data)


def test_a_head_has_its_own_length() -> None:
    assert "half_length: half_length given twice" in refusal({**with_head(), "half_length": 0.8})
