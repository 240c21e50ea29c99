"""The page of a line at rest: whole, offline, with the numbers of all spans."""

import re
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import OutputError
from arcless.figures.statics import line_data
from arcless.model import load
from arcless.report import statics_page
from arcless.simulate import StaticsResult, statics
from tests.support.bokeh_pages import data_in, document_in, mistakes_of, text_in
from tests.support.line_types import scenario_data, stitched_data
from tests.support.overlaps import overlap_data, plain_data

STAGGERED = {"stagger_contact_wire": [0.2, -0.2], "contact_wire_height": 5.3, "encumbrance": 1.4}
ARM = {"kind": "arm", "length": 1.2, "slope": 0.1}


@pytest.fixture(
    scope="module",
    params={
        "stitched": stitched_data(),
        "staggered": stitched_data(geometry=STAGGERED, steady_arm=ARM),
        "overlap": overlap_data(),
    }.items(),
    ids=lambda item: item[0],
)
def found(request: pytest.FixtureRequest) -> StaticsResult:
    return statics(load(scenario_data(request.param[1])))


def cells_of(page: str, table: str) -> list[list[str]]:
    """Return the texts of a table's body."""
    begin = page.index("<tbody>", page.index(f'id="table-{table}"'))
    body = page[begin : page.index("</tbody>", begin)]
    rows = re.findall(r"<tr>(.*?)</tr>", body, re.DOTALL)
    return [[text_in(cell) for cell in re.findall(r"<td.*?</td>", row)] for row in rows]


def test_the_page_is_whole_and_loads_nothing(found: StaticsResult, tmp_path: Path) -> None:
    path = tmp_path / "line.html"
    statics_page.write(found, path, resonance=found.resonance_speeds.to_dict())
    text = path.read_text("utf-8")
    assert text.rstrip().endswith("</html>") and path.stat().st_size < 2e6
    assert not re.search(r"<(?:script|link|img)[^>]*(?:src|href)=[\"']https?:", text)
    assert [p.name for p in tmp_path.iterdir()] == ["line.html"]
    assert not mistakes_of(document_in(text))
    shown = text_in(text)
    assert f"{found.elasticity_nonuniformity * 100:.1f} %" in shown
    assert f"{1e3 * found.contact_wire_sag_m:.1f} mm" in shown
    assert "Heights are drawn larger than lengths" in shown
    for one in found.resonance_speeds.to_dict()["speeds"]:
        assert one["source"] in shown
    assert "576 km/h" in shown
    assert f"Arcless {version('arcless')}, computed" in shown


def test_the_tables_have_every_dropper_and_support(found: StaticsResult) -> None:
    page = statics_page.html(found)
    rows = cells_of(page, "droppers")
    wanted = [
        [f"{one['x_m']:.2f}", f"{one['length_m']:.4f}", f"{one['unstretched_length_m']:.4f}",
         f"{one['force_N']:.1f}"] for one in found.droppers
    ]  # fmt: skip
    assert [row[-4:] for row in rows] == wanted
    assert len(cells_of(page, "supports")) == len(found.supports)
    assert all(f'data-download="table-{name}"' in page for name in ("droppers", "supports"))
    if found.stitch_wires:
        assert len(cells_of(page, "stitch-wires")) == len(found.stitch_wires)


def test_figures_along_the_track_share_one_axis(found: StaticsResult) -> None:
    data = data_in(statics_page.html(found))
    assert list(data["groups"]) == ["track"]
    ranges = [root["attributes"]["x_range"] for root in data["objects"]["roots"]]
    shared = [one for one in ranges if one["id"] == data["groups"]["track"]["range"]]
    # Side view, elasticity, droppers, supports at least; the figure by span has its own axis.
    assert len(shared) >= 4
    assert len(ranges) - len(shared) == 1
    assert data["track"]["whole"][0] < data["track"]["section"][0]


def test_a_straight_line_says_that_it_has_no_plan_view() -> None:
    text = text_in(statics_page.html(statics(load(scenario_data(stitched_data())))))
    assert "seen from above it is one line" in text


def test_a_long_line_is_cut_and_the_page_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    found = statics(load(scenario_data(stitched_data())))
    monkeypatch.setattr(line_data, "DRAWN", 150.0)
    page = statics_page.html(found)
    assert "Tables have all of it" in text_in(page)
    assert len(cells_of(page, "droppers")) == len(found.droppers)


def test_names_are_text() -> None:
    data: dict[str, Any] = stitched_data()
    data["name"] = '<b onclick="x">"'
    page = statics_page.html(statics(load(scenario_data(data))))
    assert "<b onclick" not in page
    assert "&lt;b onclick=&#34;x&#34;&gt;" in page


def test_a_file_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    found = statics(load(scenario_data(stitched_data())))
    with pytest.raises(OutputError, match="cannot be written"):
        statics_page.write(found, tmp_path / "none" / "line.html")
    assert list(tmp_path.iterdir()) == []


def test_sag_is_that_of_the_wire_that_runs_through_the_span() -> None:
    """At the border of an overlap the neighbour's wire hangs half a metre higher at its anchor."""
    plain, overlap = (
        statics(load(scenario_data(data))) for data in (plain_data(11), overlap_data())
    )
    # The same span and droppers, far enough from both ends.
    assert overlap.contact_wire_sag_m == pytest.approx(plain.contact_wire_sag_m, rel=1e-6)


def test_the_first_screen_has_the_numbers_of_the_drawing() -> None:
    staggered = stitched_data(geometry=STAGGERED, steady_arm=ARM)
    line = statics(load(scenario_data(staggered)))
    rows = {label: (value, unit) for label, value, unit in statics_page.main_numbers(line)}
    assert rows["stagger at the supports"] == ("−200 – 200", "mm")
    assert rows["height of the contact wire above rail"] == ("5.30", "m")
    assert rows["encumbrance (system height)"] == ("1.40", "m")
    tension = line.scenario.line.contact_wire.tension
    assert rows["tension of the contact wire, as designed"] == (f"{tension / 1e3:.2f}", "kN")
    straight = statics(load(scenario_data(stitched_data())))
    assert "stagger at the supports" not in {row[0] for row in statics_page.main_numbers(straight)}
