"""Figures of a line at rest draw what the mesh holds."""

from typing import Any

import numpy as np
import pytest

from arcless.figures.description import Curve, Figure, Points, Segments, Strip, Texts
from arcless.figures.statics import LineData, elasticity, figures, forces, line_data, views
from arcless.model import load
from arcless.simulate import StaticsResult, statics
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.overlaps import overlap_data

STAGGERED = {"stagger_contact_wire": [0.2, -0.2], "contact_wire_height": 5.3, "encumbrance": 1.4}
ARM = {"kind": "arm", "length": 1.2, "slope": 0.1}


@pytest.fixture(
    scope="module",
    params={
        "stitched": stitched_data(),
        "compound": compound_data(),
        "staggered": stitched_data(geometry=STAGGERED, steady_arm=ARM),
        "overlap": overlap_data(),
    }.items(),
    ids=lambda item: item[0],
)
def found(request: pytest.FixtureRequest) -> StaticsResult:
    return statics(load(scenario_data(request.param[1])))


def named(figure: Figure, kind: type) -> dict[str, Any]:
    """Return the layers of a kind by their names in the legend."""
    return {layer.name: layer for layer in figure.layers if isinstance(layer, kind)}


def side(found: StaticsResult) -> Figure:
    return views.side_view(LineData(found))[0]


def test_every_wire_of_the_mesh_is_drawn_through_its_nodes(found: StaticsResult) -> None:
    drawn, mesh = named(side(found), Curve), found.equilibrium.mesh
    wires = {name: rows for name, rows in mesh.wire_rows.items() if rows}
    # Contact and messenger wire, and stitch or auxiliary wires where there are any.
    assert len(wires) == (2 if found.scenario.name == "overlaps" else 3)
    ends = mesh.elements["nodes"]
    for name, rows in wires.items():
        points = found.equilibrium.positions[np.unique(ends[rows])]
        curve = drawn[views.NAMES.get(name, name.replace("_", " "))]
        whole = np.isfinite(curve.x)
        shown = set(zip(curve.x[whole], curve.y[whole], strict=True))
        assert shown == {(point[0], point[2]) for point in points}


def test_one_wire_is_one_line_and_several_leave_gaps(found: StaticsResult) -> None:
    drawn, mesh = named(side(found), Curve), found.equilibrium.mesh
    # One gap behind the end of each wire: two in two tension lengths.
    assert np.isnan(drawn["contact wire"].x).sum() == len(mesh.contact_wires)
    if "stitch wires" in drawn:
        assert np.isnan(drawn["stitch wires"].x).sum() == len(mesh.stitches) > 1


def test_droppers_end_on_the_wires_that_they_join(found: StaticsResult) -> None:
    layer = named(side(found), Segments)["dropper"]
    lengths = next(tip.values for tip in layer.tips if tip.label == "length between clamps")
    assert len(layer.x0) == len(found.droppers)
    points = found.equilibrium.positions
    for place, top, foot, length in zip(
        found.equilibrium.mesh.droppers, layer.y0, layer.y1, lengths, strict=True
    ):
        assert (top, foot) == tuple(points[list(place.nodes), 2])
        # Upright within 0.2 m of stagger over more than half a metre of height.
        assert top - foot == pytest.approx(length, rel=0.1)


def test_plan_view_only_where_something_is_off_the_middle(found: StaticsResult) -> None:
    drawn = views.plan_view(LineData(found))
    assert len(drawn) == int(found.scenario.line.is_spatial)
    if not drawn:
        return
    plan = drawn[0]
    wires = np.concatenate([curve.y for curve in named(plan, Curve).values()])
    # The wires fill the figure, whatever the length of the steady arms.
    assert plan.y.high == pytest.approx(1.25 * np.nanmax(np.abs(wires)))
    assert plan.y.low == -plan.y.high
    if found.scenario.line.steady_arm.kind != "arm":  # overlaps: two wires side by side
        return
    # Anchors hold the wire exactly; an arm's far end moves it by its own stretch, below 1 mm.
    staggers = named(plan, Points)["stagger"].y
    assert staggers == pytest.approx([0.2, -0.2, 0.2, -0.2, 0.2, -0.2, 0.2], abs=1e-3)
    arms = named(plan, Segments)["steady arm"]
    assert len(arms.x0) == 5  # at the inner supports
    # 1.2 m long, 0.1 rad against the horizontal: outwards, away from the middle of the track.
    assert np.abs(arms.y1 - arms.y0) == pytest.approx(1.2 * np.cos(0.1), abs=0.01)


def test_the_elasticity_covers_all_spans_and_agrees_in_the_middle_one(found: StaticsResult) -> None:
    line = LineData(found)
    x = line.elasticity[0]
    assert np.all(np.diff(x) > 0.0)
    assert (x[0], x[-1]) == (line.supports[0], line.supports[-1])
    assert set(line.supports) <= set(x)
    left, right = found.equilibrium.middle_span()
    # The same places, asked for with others: equal to round-off of the solution of one system.
    assert line.elasticity_of(left, right) == pytest.approx(found.elasticity_m_per_N, rel=1e-9)


def test_the_range_of_the_middle_span_is_that_of_the_numbers(found: StaticsResult) -> None:
    line = LineData(found)
    figure = elasticity.by_span(line)[0]
    ranges = named(figure, Segments)["lowest to highest"]
    assert list(ranges.x0) == [number for number, _, _ in line.spans]
    row = found.middle_span - 1
    known = 1e3 * np.array(found.elasticity_m_per_N)
    assert (ranges.y0[row], ranges.y1[row]) == pytest.approx((known.min(), known.max()), rel=1e-9)
    strips = [layer for layer in figure.layers if isinstance(layer, Strip)]
    assert len(strips) == (3 if found.scenario.name == "overlaps" else 0)


def test_spans_that_are_alike_have_one_range_of_elasticity() -> None:
    line = LineData(statics(load("spain-ca-220-220")))
    ranges = named(elasticity.by_span(line)[0], Segments)["lowest to highest"]
    row = line.found.middle_span - 1
    beside = [row - 1, row + 1]
    # A span nearer to an end of the line is stiffer by 0.2 %; a place that misses a dropper is 3 %.
    assert ranges.y0[beside] == pytest.approx(ranges.y0[row], rel=5e-3)
    assert ranges.y1[beside] == pytest.approx(ranges.y1[row], rel=5e-3)


def test_forces_are_those_of_the_tables(found: StaticsResult) -> None:
    line = LineData(found)
    drawn = forces.dropper_forces(line)[0]
    marks = [layer for layer in drawn.layers if isinstance(layer, Points)]
    shown = sorted((x, y) for layer in marks for x, y in zip(layer.x, layer.y, strict=True))
    assert shown == sorted((one["x_m"], one["force_N"]) for one in found.droppers)
    held = [
        one["messenger_force_N"] for one in found.supports if one["messenger_force_N"] is not None
    ]
    layer = named(forces.support_forces(line)[0], Points)["vertical force"]
    assert list(layer.y) == held
    arms = [one for one in found.supports if one["steady_arm_force_N"] is not None]
    assert len(forces.steady_arm_forces(line)) == int(bool(arms))


def test_every_figure_has_an_alternative_text_with_numbers(found: StaticsResult) -> None:
    for made in figures(LineData(found)).values():
        for figure in made:
            assert any(letter.isdigit() for letter in figure.alt), figure.key


def test_a_long_line_is_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    found = statics(load(scenario_data(stitched_data())))
    monkeypatch.setattr(line_data, "DRAWN", 150.0)
    line = LineData(found)
    x = named(side(found), Curve)["contact wire"].x
    left, right = found.equilibrium.middle_span()
    middle = 0.5 * (left + right)
    assert line.cut
    # Elements, at most 1.45 m long, whose middle is inside.
    assert np.nanmin(x) == pytest.approx(middle - 75, abs=0.8)
    assert np.nanmax(x) == pytest.approx(middle + 75, abs=0.8)
    # Whole spans within these 150 m alone are numbered.
    texts = next(layer for layer in side(found).layers if isinstance(layer, Texts))
    assert len(texts.texts) == len(line.spans) < len(line.supports) - 1
