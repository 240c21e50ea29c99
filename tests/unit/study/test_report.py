"""The report of a study: what it says, of which rows, and that its commands compute a row again."""

import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import StudyError
from arcless.model import load as load_scenario
from arcless.model import parse_override
from arcless.study import StudyFolder, load, run
from arcless.study.report import html, write
from arcless.study.report.commands import Commands
from arcless.study.report.effects import effect
from arcless.study.report.record import Column, Record, shortened
from arcless.study.report.tables import best
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
    assert "sigma over force" in page
    assert "default-src 'none'" in page  # a browser refuses whatever would be loaded


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
    assert "Outputs over variables" not in page


def test_no_row_yet(tmp_path: Path) -> None:
    made = study()
    place = StudyFolder(made, tmp_path)
    place.make()
    place.write_state()
    assert "Incomplete: 0 of 6 variants computed, 6 missing" in html(made, tmp_path)


def test_words_one_variable_and_one_value(tmp_path: Path) -> None:
    law = {"law": {"field": "contact.law", "values": ["compliant", "rigid"]}}
    made = filled(tmp_path, variables=law, design={"kind": "list"})
    page = html(made, tmp_path)
    assert "sigma over law" in page
    assert "Two variables at a time" not in page
    assert Record(made, tmp_path).variables[0].words == ("compliant", "rigid")


def test_thousands_of_variants_are_thinned(tmp_path: Path) -> None:
    force = {**VARIABLES["force"], "values": None, "range": ["60 N", "90 N"]}
    many = {"variables": {"force": force}, "design": {"kind": "monte-carlo", "count": 5000}}
    page = html(filled(tmp_path, **many), tmp_path)
    assert "4000 of 5000 variants, evenly chosen" in page
    assert len(page) < 4e6


def test_texts_of_users_are_no_markup(tmp_path: Path) -> None:
    outputs = {"sigma": {"expression": "std_force_N", "unit": "<i>x</i>"}}
    page = html(filled(tmp_path, outputs=outputs, description="<script>1</script>"), tmp_path)
    assert "<script>1</script>" not in page
    assert "<i>x</i>" not in page.replace("\\u003c", "<").split("<script", 1)[0]
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


def test_the_best_of_an_optimisation(tmp_path: Path) -> None:
    design = {"kind": "optimise", "trials": 6, "objectives": {"sigma": "minimise"}}
    force = {"force": {**VARIABLES["force"], "values": None, "range": [60, 90]}}
    made = study(variables=force, design=design)
    run(made, tmp_path)
    page = html(made, tmp_path)
    record = Record(made, tmp_path)
    assert "Best variants" in page
    assert "optimise: minimise sigma; 6 variants" in page
    lowest = min(record.done, key=lambda row: row.outputs["sigma"] or 0.0)
    found = best(record)
    assert found is not None
    assert [leader.variant for leader in found] == [lowest.variant]


def test_no_study_there(tmp_path: Path) -> None:
    with pytest.raises(StudyError, match="no study was begun here"):
        write(study(), tmp_path)
