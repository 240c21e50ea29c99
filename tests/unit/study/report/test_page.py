"""The report of a study: what it says, of which rows, and that its commands compute a row again."""

import json
import re
import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import StudyError
from arcless.model import load as load_scenario
from arcless.model import parse_override
from arcless.study import Study, StudyFolder, load, run
from arcless.study.evaluation.variants import scenario
from arcless.study.folder import table
from arcless.study.report import html, write
from arcless.study.report.commands import Commands
from arcless.study.report.data.effects import effect
from arcless.study.report.data.judge import judge
from arcless.study.report.data.record import Column, Record, shortened
from arcless.study.report.figures.canvas import Canvas
from arcless.study.report.figures.scatters import Scatters
from arcless.study.report.tables import best
from tests.support.bokeh_pages import data_in, document_in, mistakes_of
from tests.support.studies import VARIABLES, filled, rows, study, written


def test_a_whole_study(tmp_path: Path) -> None:
    made = study()
    run(made, tmp_path)
    target = write(made, tmp_path)
    page = target.read_text()
    assert target == tmp_path / "report.html"
    assert "Complete: 4 of 6 variants computed, 2 invalid" in page
    assert "got -5.0, expected a force" in page
    assert "pantographs.0.static_force" in page
    assert "sigma by force and tension" in page
    assert "sigma over force" in page
    assert "default-src 'none'" in page  # a browser refuses whatever would be loaded
    assert not mistakes_of(document_in(page))


def test_a_study_that_is_going_on_says_so(tmp_path: Path) -> None:
    made = filled(tmp_path, of=2)
    assert "Incomplete: 2 of 6 variants computed, 4 missing; it is not being" in html(
        made, tmp_path
    )
    with StudyFolder(made, tmp_path).open_journal():
        assert "it is being computed now" in html(made, tmp_path)


def test_nothing_but_failures(tmp_path: Path) -> None:
    page = html(filled(tmp_path, error="<b>no</b> contact"), tmp_path)
    assert "No variant has a value: 6 failed" in page
    assert "&lt;b&gt;no&lt;/b&gt; contact" in page
    assert 'id="effects"' not in page
    assert 'id="variants"' not in page


def test_no_row_yet(tmp_path: Path) -> None:
    made = study()
    place = StudyFolder(made, tmp_path)
    place.make()
    place.write_state("")
    assert "Incomplete: 0 of 6 variants computed, 6 missing" in html(made, tmp_path)


def test_words_one_variable_and_one_value(tmp_path: Path) -> None:
    law = {"law": {"field": "contact.law", "values": ["compliant", "rigid"]}}
    made = filled(tmp_path, variables=law, design={"kind": "list"})
    page = html(made, tmp_path)
    assert "sigma over law" in page
    assert not mistakes_of(document_in(page))
    assert "Two variables at a time" not in page
    assert Record(made, tmp_path).variables[0].words == ("compliant", "rigid")


def test_thousands_of_variants_are_thinned(tmp_path: Path) -> None:
    force = {**VARIABLES["force"], "values": None, "range": ["60 N", "90 N"]}
    many = {"variables": {"force": force}, "design": {"kind": "monte-carlo", "count": 5000}}
    page = html(filled(tmp_path, **many), tmp_path)
    # Evenly chosen, and the ends of two outputs, which may be among those already.
    found = re.search(r"(\d+) of 5000 variants, evenly chosen", page)
    assert found is not None
    drawn = int(found[1])
    assert 3990 < drawn <= 4000
    assert len(re.findall(r"^<tr><td>\d", page, re.MULTILINE)) == drawn
    assert f"300 of {drawn} rows are printed" in page
    assert len(page) < 4e6


def test_texts_of_users_are_no_markup(tmp_path: Path) -> None:
    outputs = {"sigma": {"expression": "std_force_N", "unit": "<i>x</i>"}}
    page = html(filled(tmp_path, outputs=outputs, description="<script>1</script>"), tmp_path)
    assert "<script>1</script>" not in page
    assert "<i>x</i>" not in page  # in the data of the script < is written \\u003c
    assert "&lt;i&gt;x&lt;/i&gt;" in page


def test_effects_are_means_and_their_errors() -> None:
    x = np.repeat([1.0, 2.0, 3.0], 2)
    y = np.array([1.0, 3.0, 5.0, 5.0, 2.0, 8.0])
    found = effect(Column("x", "", "", x), Column("y", "", "", y))
    assert found is not None
    assert found.mean.tolist() == [2.0, 5.0, 5.0]
    # Standard error of the mean of two values: half of their difference.
    assert found.error.tolist() == pytest.approx([1.0, 0.0, 3.0], rel=1e-12)
    # Between the means 2·(2² + 1² + 1²) of 12 + 2 + 0 + 18.
    assert found.share == pytest.approx(12.0 / 32.0, rel=1e-12)


def test_effects_of_many_values_and_of_too_few() -> None:
    x = np.arange(100.0)
    found = effect(Column("x", "", "", x), Column("y", "", "", 2.0 * x))
    assert found is not None
    assert len(found.x) == 10
    assert found.mean.tolist() == (2.0 * found.x).tolist()
    assert effect(Column("x", "", "", x[:3]), Column("y", "", "", x[:3])) is None
    assert effect(Column("x", "", "", x[:0]), Column("y", "", "", x[:0])) is None


def test_long_words_stay_different() -> None:
    assert shortened(["a" * 40, "a" * 41, "b"]) == [f"{'a' * 27}… (1)", f"{'a' * 27}… (2)", "b"]


def test_the_command_computes_the_row_again(tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    made = load(written(tmp_path))
    run(made, tmp_path / "out")
    words = shlex.split(Commands(made).again(5))
    assert words[:2] == ["arcless", "run"]
    changes = dict(parse_override(text) for text in words[4::2])
    again = arcless.run(load_scenario(words[2]).with_(**changes))
    row = rows(tmp_path / "out" / "table.parquet")[4]
    assert again.assessment.pantographs[0].std_force_N == row["sigma"]  # the same bits


SPEEDS: dict[str, Any] = {
    "speed": {"field": "speed", "values": ["220 km/h", "61.1 m/s"]},
    "tension": {"field": "line.contact_wire.tension", "range": ["18.1 kN", "26 kN"]},
}


@pytest.mark.parametrize("kind", ["grid", "monte-carlo"])
def test_commands_have_values_with_units_and_the_same_bits(
    tmp_path: Path, monkeypatch: Any, kind: str
) -> None:
    monkeypatch.chdir(tmp_path)
    grid = kind == "grid"
    variables = {**SPEEDS, "tension": {**SPEEDS["tension"], **({"count": 7} if grid else {})}}
    made = load(written(
        tmp_path, variables=variables,
        design={"kind": kind} if grid else {"kind": kind, "count": 40},
    ))  # fmt: skip
    commands = Commands(made)
    if grid:
        assert commands.again(1).endswith(
            "--set 'speed=220 km/h' --set 'line.contact_wire.tension=18.1 kN'"
        )
    for number in range(1, made.plan.count + 1):
        words = shlex.split(commands.again(number))
        assert words[:2] == ["arcless", "run"]
        changes = dict(parse_override(text) for text in words[4::2])
        assert isinstance(changes["line.contact_wire.tension"], str)  # with its unit
        again, wanted = load_scenario(words[2]).with_(**changes), scenario(made, number)
        assert again.speed == wanted.speed
        assert again.line.contact_wire.tension == wanted.line.contact_wire.tension


def test_the_best_of_an_optimisation(tmp_path: Path) -> None:
    design = {"kind": "optimise", "trials": 6, "objectives": {"sigma": "minimise"}}
    force = {"force": {**VARIABLES["force"], "values": None, "range": [60, 90]}}
    made = study(variables=force, design=design)
    run(made, tmp_path)
    page = html(made, tmp_path)
    record = Record(made, tmp_path)
    assert "Best variants" in page
    assert "optimise: minimise sigma; 6 variants, seed 0" in page
    lowest = min(record.done, key=lambda row: row.outputs["sigma"] or 0.0)
    found = best(record)
    assert found is not None
    assert [leader.variant for leader in found] == [lowest.variant]


def test_the_table_and_the_figures_share_their_columns(tmp_path: Path) -> None:
    page = html(filled(tmp_path), tmp_path)
    (source,) = set(re.findall(r'data-selection="(\w+)"', page))
    names = re.findall(r'data-sort="(\w+)"', page)
    written = json.dumps(data_in(page)["objects"]["roots"])
    assert f'"name": "ColumnDataSource", "id": "{source}"' in written
    columns = document_in(page).get_model_by_id(source).data
    assert set(names) <= set(columns)
    assert len(columns[names[0]]) == len(re.findall(r"^<tr><td>\d", page, re.MULTILINE))


def test_nothing_that_could_be_an_axis(tmp_path: Path) -> None:
    errors = {"standard_deviation": "1 mm", "correlation_length": "10 m"}
    variables = {"e": {"field": "as_built.dropper_length_errors", "random_field": errors}}
    made = filled(tmp_path, variables=variables, outputs={"sigma": "std_force_N"},
                  design={"kind": "monte-carlo", "count": 3})  # fmt: skip
    page = html(made, tmp_path)
    assert 'id="variants"' in page
    assert "data-sort" not in page.split("<script")[0]  # no columns that a click could sort


def test_no_study_there(tmp_path: Path) -> None:
    with pytest.raises(StudyError, match="no study was begun here"):
        write(study(), tmp_path)


EVIL = "@variant{safe}<img src=x onerror=alert(1)>$x{safe}@{v0 word}{safe}"
OWN_VALUE = re.compile(r"@c\d+(\{0(\.0+)?(e\+0)?\})?")


def test_no_word_of_a_user_is_a_template_of_a_tooltip(tmp_path: Path) -> None:
    made = filled(
        tmp_path,
        name=EVIL,
        variables={
            "force": {**VARIABLES["force"], "description": EVIL},
            "word": {"field": "contact.law", "values": ["rigid", "compliant"], "description": EVIL},
        },
        outputs={
            "sigma": {"expression": "std_force_N", "unit": EVIL, "description": EVIL},
            "ratio": {"expression": "std_force_N / mean_force_N", "unit": EVIL},
        },
    )
    page = html(made, tmp_path)
    assert "<img" not in page
    roots = document_in(page).roots
    tips = [
        pair
        for plot in roots
        for tool in plot.toolbar.tools
        for pair in getattr(tool, "tooltips", None) or []
    ]
    assert len(tips) > 20
    assert all(OWN_VALUE.fullmatch(value) for _, value in tips), tips
    # A label is put into the page as text; a value has its unit there.
    assert f"sigma, {EVIL}" in [label for label, _ in tips]


KMH = {"field": "speed", "range": ["60 km/h", "240 km/h"], "count": 4}


def test_people_see_the_units_of_the_study_file(tmp_path: Path) -> None:
    tension = {"field": "line.contact_wire.tension", "values": [20000, "22 kN", "24000 N"]}
    arm = {"field": "line.steady_arm.vertical_stiffness", "values": [150.0, 300.0]}
    made = filled(tmp_path, variables={"v": KMH, "tension": tension, "arm": arm})
    record = Record(made, tmp_path)
    v, kn, plain = record.variables
    assert (v.label, sorted(set(v.values.round(9)))) == ("v, km/h", [60.0, 120.0, 180.0, 240.0])
    assert (kn.label, sorted(set(kn.values))) == ("tension, kN", [20.0, 22.0, 24.0])
    assert (plain.label, sorted(set(plain.values))) == ("arm, N/m", [150.0, 300.0])
    page = html(made, tmp_path)
    assert "v 60 km/h, tension 20 kN, arm 150 N/m" in page
    assert "m/s," not in page
    ((_, (over_speed, *_)), *_) = Scatters(Canvas(record, judge(record))).effects()
    assert (over_speed.x.label, over_speed.x.unit) == ("v", "km/h")
    assert over_speed.x.high is not None
    assert 240.0 < over_speed.x.high < 260.0
    # The table is for programs: SI, with the unit beside it.
    assert [row["v"] for row in rows_of_table(made, tmp_path)][:1] == [60 / 3.6]


def rows_of_table(made: Study, folder: Path) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = table.table(made, StudyFolder(made, folder).rows()).to_pylist()
    return found


@pytest.mark.parametrize(
    ("given", "unit"),
    [
        ({"range": [20, "300 km/h"]}, "km/h"),
        ({"values": [50, 60.0]}, "m/s"),
        ({"distribution": {"kind": "normal", "mean": "200 km/h", "standard_deviation": 2}}, "km/h"),
        ({"distribution": {"kind": "choice", "values": ["55 m/s", "200km/h"]}}, "m/s"),
    ],
)
def test_the_unit_is_the_first_that_is_typed(given: dict[str, Any], unit: str) -> None:
    sampled = {"design": {"kind": "monte-carlo", "count": 2}}
    (axis,) = study(variables={"v": {"field": "speed", **given}}, **sampled).axes
    assert (axis.unit, axis.typed_unit) == ("m/s", unit)
    assert axis.shown(50.0) == ("180 km/h" if unit == "km/h" else "50 m/s")
