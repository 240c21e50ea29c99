"""The page of the initial configuration draws what the mesh holds."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.errors import OutputError
from arcless.model import load
from arcless.report import rest_page
from arcless.simulate import StaticsResult, statics
from tests.support.bokeh_pages import document_in, mistakes_of
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.overlaps import overlap_data, plain_data

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


def named(fig: Any) -> dict[str, Any]:
    """Return the drawn data by their names in the legend."""
    return {item.label.value: item.renderers[0].data_source.data for item in fig.above[0].items}


def side(found: StaticsResult) -> dict[str, Any]:
    return named(rest_page._View(found).view(rest_page.UP, "side", "height", 300))


def test_every_wire_of_the_mesh_is_drawn_through_its_nodes(found: StaticsResult) -> None:
    drawn, mesh = side(found), found.equilibrium.mesh
    wires = {name: rows for name, rows in mesh.wire_rows.items() if rows}
    # Contact and messenger wire, and stitch or auxiliary wires where there are any.
    assert len(wires) == (2 if found.scenario.name == "overlaps" else 3)
    ends = mesh.elements["nodes"]
    for name, rows in wires.items():
        points = found.equilibrium.positions[np.unique(ends[rows])]
        x, z = (np.asarray(drawn[name.replace("_", " ")][axis], dtype=float) for axis in "xy")
        whole = np.isfinite(x)
        shown = set(zip(x[whole], z[whole], strict=True))
        assert shown == {(point[0], point[2]) for point in points}


def test_one_wire_is_one_line_and_several_leave_gaps(found: StaticsResult) -> None:
    drawn, mesh = side(found), found.equilibrium.mesh
    # One gap behind the end of each wire: two in two tension lengths.
    assert np.isnan(drawn["contact wire"]["x"]).sum() == len(mesh.contact_wires)
    if "stitch wire" in drawn:
        stitches = found.equilibrium.mesh.stitches
        assert np.isnan(drawn["stitch wire"]["x"]).sum() == len(stitches) > 1


def test_droppers_end_on_the_wires_that_they_join(found: StaticsResult) -> None:
    data = side(found)["dropper"]
    assert len(data["x0"]) == len(found.droppers)
    points = found.equilibrium.positions
    for place, *ends in zip(
        found.equilibrium.mesh.droppers, data["y0"], data["y1"], data["length"], strict=True
    ):
        top, bottom, length = ends
        assert (top, bottom) == tuple(points[list(place.nodes), 2])
        # Upright within 0.2 m of stagger over more than half a metre of height.
        assert top - bottom == pytest.approx(length, rel=0.1)


def test_plan_view_only_where_something_is_off_the_middle(found: StaticsResult) -> None:
    plan = rest_page._View(found).view(rest_page.ACROSS, "plan", "across", 260)
    if not found.scenario.line.is_spatial:
        assert plan is None
        return
    drawn = named(plan)
    if found.scenario.line.steady_arm.kind != "arm":  # overlaps: two wires side by side
        assert np.ptp(found.equilibrium.positions[:, 1]) > 0
        return
    staggers = np.asarray(drawn["stagger"]["y"])
    # Anchors hold the wire exactly; an arm's far end moves it by its own stretch, below 1 mm.
    assert staggers == pytest.approx([0.2, -0.2, 0.2, -0.2, 0.2, -0.2, 0.2], abs=1e-3)
    arms = drawn["steady arm"]
    assert len(arms["x0"]) == 5  # at the inner supports
    # 1.2 m long, 0.1 rad against the horizontal: outwards, away from the middle of the track.
    reach = np.asarray(arms["y1"]) - np.asarray(arms["y0"])
    assert np.abs(reach) == pytest.approx(1.2 * np.cos(0.1), abs=0.01)


def test_page_is_whole_and_says_that_heights_are_exaggerated(
    found: StaticsResult, tmp_path: Path
) -> None:
    path = tmp_path / "line.html"
    rest_page.write(found, path)
    text = path.read_text("utf-8")
    assert text.rstrip().endswith("</html>") and path.stat().st_size < 2e6
    assert not re.search(r"<(?:script|link|img)[^>]*(?:src|href)=[\"']https?:", text)
    factor = rest_page._View(found).exaggeration
    assert f"Heights are drawn larger than lengths, about {factor:g} times" in text
    assert f"{found.elasticity_nonuniformity * 100:.1f} %" in text
    assert [p.name for p in tmp_path.iterdir()] == ["line.html"]
    assert not mistakes_of(document_in(text))


def test_a_long_line_is_cut_and_the_page_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    found = statics(load(scenario_data(stitched_data())))
    monkeypatch.setattr(rest_page, "DRAWN", 150.0)
    x = np.asarray(side(found)["contact wire"]["x"])
    left, right = found.equilibrium.middle_span()
    middle = 0.5 * (left + right)
    # Elements, at most 1.45 m long, whose middle is inside.
    assert np.nanmin(x) == pytest.approx(middle - 75, abs=0.8)
    assert np.nanmax(x) == pytest.approx(middle + 75, abs=0.8)
    assert "The line is longer than what is drawn" in rest_page.html(found)


def test_a_file_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    found = statics(load(scenario_data(stitched_data())))
    with pytest.raises(OutputError, match="cannot be written"):
        rest_page.write(found, tmp_path / "none" / "line.html")
    assert list(tmp_path.iterdir()) == []


def test_sag_is_that_of_the_wire_that_runs_through_the_span() -> None:
    """At the border of an overlap the neighbour's wire hangs half a metre higher at its anchor."""
    plain, overlap = (
        statics(load(scenario_data(data))) for data in (plain_data(11), overlap_data())
    )
    # The same span and droppers, far enough from both ends.
    assert overlap.contact_wire_sag_m == pytest.approx(plain.contact_wire_sag_m, rel=1e-6)
