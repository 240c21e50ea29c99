"""Resonance speeds in the report of a study: where they stand, and when there are none."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.figures.description import Rules
from arcless.study.report import html
from arcless.study.report.data.judge import judge
from arcless.study.report.data.record import Column, Record
from arcless.study.report.figures.canvas import Canvas, is_path
from arcless.study.report.figures.scatters import Scatters
from arcless.study.report.figures.speeds import marks, rows_of
from tests.support.bokeh_pages import document_in, mistakes_of
from tests.support.studies import filled

SPEED = {"field": "speed", "range": ["60 km/h", "240 km/h"], "count": 19}
SWEEP: dict[str, Any] = {"variables": {"v": SPEED}, "design": {"kind": "list"}}


def test_a_sweep_of_speed_has_them(tmp_path: Path) -> None:
    made = filled(tmp_path, **SWEEP)
    page = html(made, tmp_path)
    assert "<h2>Resonance speeds</h2>" in page
    assert not mistakes_of(document_in(page))
    record = Record(made, tmp_path)
    found = marks(record)
    assert found is not None
    numbers = [number for number, one in found.numbered if number is not None]
    assert numbers == list(range(1, len(numbers) + 1))
    assert len(numbers) > 2
    for number, one in found.numbered:
        # 60 and 240 km/h are in the range.
        assert (number is not None) == (60.0 <= 3.6 * one.speed.middle <= 240.0)
    for row, (_, one) in zip(found.rows(), found.numbered, strict=True):
        assert row["speed"] == f"{3.6 * one.speed.middle:.0f}"
        assert row["name"] in page
        assert row["source"].replace("&", "&amp;") in page


def test_they_are_drawn_over_the_speed_and_only_there(tmp_path: Path) -> None:
    variables = {"v": SPEED, "force": {"field": "pantographs.0.static_force", "range": [60, 96],
                                       "count": 19}}  # fmt: skip
    record = Record(filled(tmp_path, **{**SWEEP, "variables": variables}), tmp_path)
    found = marks(record)
    ((_, panels), *_) = Scatters(Canvas(record, judge(record)), found).effects()
    rules = [
        [layer for layer in one.layers if isinstance(layer, Rules) and layer.axis == "x"]
        for one in panels
    ]
    assert len(rules[0]) > 1  # over the speed: a layer for each kind
    assert not rules[1]  # over the force
    assert found is not None
    places = [x for one in rules[0] for x in one.at]
    assert all(60.0 <= x <= 240.0 for x in places)  # in km/h, as the axis is
    drawn = len(places)
    assert drawn == sum(number is not None for number, _ in found.numbered)


def test_without_a_speed_there_are_none(tmp_path: Path) -> None:
    made = filled(tmp_path)
    assert marks(Record(made, tmp_path)) is None
    assert "Resonance speeds" not in html(made, tmp_path)


def test_other_variables_are_told(tmp_path: Path) -> None:
    tension = {"field": "line.contact_wire.tension", "values": ["20 kN", "24 kN"]}
    variables = {"v": {"field": "speed", "values": ["100 km/h", "120 km/h"]}, "tension": tension}
    record = Record(filled(tmp_path, variables=variables), tmp_path)
    found = marks(record)
    assert found is not None
    assert any("its own values of tension" in note for note in found.notes)


def test_speeds_of_a_distance_that_is_varied_are_left_out(tmp_path: Path) -> None:
    variables = {
        "v": {"field": "speed", "values": ["60 km/h", "240 km/h"]},
        "gap": {"field": "pantographs.1.distance", "values": ["50 m", "100 m"]},
    }
    two = {"scenario": "ac-simple-320-two-pantographs", "set": {}, "variables": variables}
    found = marks(Record(filled(tmp_path, **two), tmp_path))
    assert found is not None
    assert not [one for _, one in found.numbered if one.kind.startswith("spacing")]
    assert any("left out, as gap is varied" in note for note in found.notes)


def test_a_line_without_equilibrium_has_none_and_a_report(tmp_path: Path) -> None:
    loose = {"line.dropper.stiffness": "200 kN/m", "line.span_types.span.droppers.presag":
             [0, "-0.9 m", 0, "-0.9 m", 0]}  # fmt: skip
    from tests.support.studies import QUICK

    page = html(filled(tmp_path, **SWEEP, set={**QUICK, **loose}), tmp_path)
    assert "no resonance speeds:" in page
    assert "sigma over v" in page


def test_numbers_do_not_stand_on_each_other() -> None:
    assert rows_of([0.0, 1.0, 2.0, 50.0], 200.0) == [0, 1, 2, 0]
    assert rows_of([0.0, 10.0, 20.0], 100.0) == [0, 0, 0]
    assert set(rows_of([0.0] * 9, 100.0)) == {0, 1, 2, 3}


@pytest.mark.parametrize(
    ("values", "sweep"), [([1, 2, 3], True), ([1, 3, 2], False), ([1, 1, 2], False)]
)
def test_what_rises_is_a_sweep(values: list[float], *, sweep: bool) -> None:
    one = Column("x", "", "", np.array(values, dtype=float))
    constant = Column("y", "", "", np.ones(3))
    assert is_path([one, constant]) is sweep
    assert not is_path([constant])
    assert not is_path([one, Column("w", "", "", np.arange(3.0), ("a", "b", "c"))])
