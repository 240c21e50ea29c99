"""Figures of two factors: map with verdicts and contour, a curve for each value."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from arcless.figures.description import Area, Curve, Figure, Map, Rules, Segments, Texts
from arcless.study.report.data.judge import judge
from arcless.study.report.data.record import Record
from arcless.study.report.figures.canvas import Canvas
from arcless.study.report.figures.contours import contour
from arcless.study.report.figures.grids import MOST_CURVES, Grids, factors
from tests.support.studies import filled_by

VARIABLES: dict[str, Any] = {
    "gap": {"field": "pantographs.0.static_force", "values": ["50 N", "70 N", "90 N"]},
    "v": {"field": "speed", "values": ["150 km/h", "250 km/h"]},
}
OUTPUTS = {"s": "std_force_N", "m": "mean_force_N"}


def grids(folder: Path, outputs_of: Callable[[dict[str, Any]], dict[str, Any]],
          **changes: Any) -> Grids:  # fmt: skip
    given = {"variables": VARIABLES, "outputs": OUTPUTS, **changes}
    made = filled_by(folder, outputs_of, **given)
    record = Record(made, folder)
    canvas = Canvas(record, judge(record))
    found = factors(canvas)
    assert found is not None
    return Grids(canvas, *found)


def rising(values: dict[str, Any]) -> dict[str, Any]:
    """Return σ of 29 N at 50 N, 31 N at 70 N, none at 90 N; a limit of 30 N."""
    sigma = {50.0: 29.0, 70.0: 31.0}.get(values["gap"])
    return {"s": sigma, "m": 100.0}


def layers(figure: Figure, kind: type) -> list[Any]:
    return [layer for layer in figure.layers if isinstance(layer, kind)]


def test_a_map_has_the_verdict_in_each_cell(tmp_path: Path) -> None:
    made = grids(tmp_path, rising)
    sigma = made.canvas.outputs[0]
    figure = made.map(sigma)
    assert figure.x.categories == ("150", "250")  # the speed along the axis, as it is typed
    assert (figure.x.unit, figure.y.unit) == ("km/h", "N")
    assert figure.y.categories == ("50", "70", "90")
    (cells,) = layers(figure, Map)
    assert cells.values[:2].tolist() == [[29.0, 29.0], [31.0, 31.0]]
    assert np.isnan(cells.values[2]).all()
    signs = {layer.name: layer for layer in layers(figure, Texts) if layer.name}
    assert set(signs) == {"✔ met, 2", "✘ not met, 2", "– no value, 2"}
    assert {round(float(y)) for y in signs["✘ not met, 2"].y} == {1}
    assert len({layer.colour for layer in signs.values()}) == 3
    assert "from 29 to 31 N" in figure.alt
    assert "2 not met" in figure.alt


def test_the_contour_lies_where_value_and_limit_are_equal(tmp_path: Path) -> None:
    made = grids(tmp_path, rising)
    (line, *_) = [one for one in layers(made.map(made.canvas.outputs[0]), Segments) if one.name]
    # Half-way between 29 and 31 N, by linear interpolation: exact but for rounding.
    assert np.allclose([line.y0, line.y1], 0.5, atol=1e-12)
    assert sorted([*line.x0, *line.x1]) == [0.0, 1.0]


def test_a_contour_crosses_saddles_and_leaves_gaps_empty() -> None:
    # The middle, 0.5, is on the side of the corners of 1 and 3: the line cuts off the others.
    saddle = contour(np.array([[1.0, -1.0], [-1.0, 3.0]]))
    assert saddle.tolist() == [[0.5, 0.0, 1.0, 0.25], [0.25, 1.0, 0.0, 0.5]]
    # And here, −0.5, on the side of the others.
    saddle = contour(np.array([[1.0, -3.0], [-1.0, 1.0]]))
    assert saddle.tolist() == [[1.0, 0.75, 0.5, 1.0], [0.0, 0.5, 0.25, 0.0]]
    assert contour(np.array([[1.0, np.nan], [-1.0, 2.0]])).shape == (0, 4)
    assert contour(np.ones((3, 3))).shape == (0, 4)


def test_a_curve_for_each_value_with_its_unit(tmp_path: Path) -> None:
    made = grids(tmp_path, lambda values: {"s": 20.0 + 0.1 * values["gap"], "m": 100.0})
    figure = made.curves(made.canvas.outputs[0])
    names = [layer.name for layer in layers(figure, Curve)]
    assert sorted(names) == ["gap: 50 N", "gap: 70 N", "gap: 90 N"]
    (limit,) = layers(figure, Rules)
    assert limit.at.tolist() == [30.0]
    assert limit.colour == "limit"
    assert figure.x.title == "v, km/h"
    assert not layers(figure, Segments)  # no standard errors: nothing is random here


def test_limits_that_differ_by_curve_are_curves(tmp_path: Path) -> None:
    made = grids(tmp_path, lambda values: {"s": 20.0, "m": values["gap"] + 10.0})
    figure = made.curves(made.canvas.outputs[0])
    assert not layers(figure, Area)
    dotted = {one.name: one.y for one in layers(figure, Curve) if one.dash == "dotted"}
    assert dotted["gap: 50 N"].tolist() == [18.0, 18.0]  # 0.3 of 60 N
    assert "Dotted: the limit of each curve." in figure.caption


def test_many_values_are_told_apart_by_the_map_alone(tmp_path: Path) -> None:
    forces = {"field": "pantographs.0.static_force", "range": ["50 N", "90 N"], "count": 50}
    speeds = {"field": "speed", "values": ["150 km/h", "160 km/h"]}
    made = grids(tmp_path, lambda values: {"s": values["gap"], "m": 100.0},
                 variables={"gap": forces, "v": speeds})  # fmt: skip
    figure = made.curves(made.canvas.outputs[0])
    assert len(layers(figure, Curve)) == MOST_CURVES
    assert f"{MOST_CURVES} of 50 values of gap are drawn" in figure.caption
    assert not layers(made.map(made.canvas.outputs[0]), Texts)  # no room for signs


def test_words_have_a_map_without_a_contour(tmp_path: Path) -> None:
    law = {"field": "contact.law", "values": ["compliant", "rigid"]}
    made = grids(
        tmp_path, lambda values: {"s": 29.0 if values["law"] == "rigid" else 31.0, "m": 100.0},
        variables={"law": law, "v": VARIABLES["v"]},
    )  # fmt: skip
    figure = made.map(made.canvas.outputs[0])
    assert figure.y.categories == ("compliant", "rigid")
    assert not [one for one in layers(figure, Segments) if one.name]


def test_other_designs_have_no_two_factors(tmp_path: Path) -> None:
    made = filled_by(tmp_path, rising, variables=VARIABLES, outputs=OUTPUTS,
                     design={"kind": "monte-carlo", "count": 5})  # fmt: skip
    record = Record(made, tmp_path)
    assert factors(Canvas(record, judge(record))) is None
