"""A study on paper: what its page says, all variants, in whatever state it is."""

import re
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import StudyError
from arcless.report.paper.blocks import Cell, Pictures, Table
from arcless.study import StudyFolder, load, run
from arcless.study.report import html, variants, write_pdf
from arcless.study.report.data.record import Record
from arcless.study.report.paper import ON_SIDE, document
from tests.support.pdf import blocks_of, cells_of, text_of
from tests.support.studies import VARIABLES, filled, study, written
from tests.unit.report.test_page import Page

FORCE = {**VARIABLES["force"], "values": None, "range": ["60 N", "90 N"]}
CASES: dict[str, dict[str, Any]] = {
    "grid": {},
    "list": {"variables": {"force": {**VARIABLES["force"], "values": ["70 N", "80 N", "90 N"]}},
             "design": {"kind": "list"}},
    "sample": {"variables": {"force": FORCE}, "design": {"kind": "monte-carlo", "count": 30}},
    "indices": {"variables": {"force": FORCE, "tension": {**VARIABLES["tension"], "count": None}},
                "design": {"kind": "sobol-indices", "count": 4}},
    "optimise": {"variables": {"force": FORCE}, "design": {
        "kind": "optimise", "objectives": {"sigma": "minimise"}, "trials": 4}},
}  # fmt: skip


@pytest.mark.parametrize("name", [name for name in CASES if name != "optimise"])
def test_page_and_paper_say_the_same(name: str, tmp_path: Path) -> None:
    made = filled(tmp_path, **CASES[name])
    page, paper = Page(html(made, tmp_path)), document(Record(made, tmp_path))
    told = " ".join(page.text.split())
    cells = [" ".join(cell.split()) for cell in cells_of(paper)]
    assert len(cells) > 20
    missing = [cell for cell in cells if cell not in told]
    # The first screen of the page has the ends of a range in lines of their own.
    ends = [part for cell in missing for part in cell.split("; ")]
    assert [end for end in ends if end not in told] == []
    titles = [figure.title for one in blocks_of(paper, Pictures) for figure in one.figures]
    assert titles
    assert [title for title in titles if title not in page.titles] == []


def test_an_optimisation_names_the_best(tmp_path: Path) -> None:
    made = study(**CASES["optimise"])
    run(made, tmp_path)
    paper = document(Record(made, tmp_path))
    assert "Best variants" in [section.title for section in paper.sections]
    (best,) = [section for section in paper.sections if section.title == "Best variants"]
    (table,) = [block for block in best.blocks if isinstance(block, Table)]
    assert table.rows
    assert all(str(row[1]).startswith("sigma = ") for row in table.rows)


def test_states_without_values(tmp_path: Path) -> None:
    failed = document(Record(filled(tmp_path / "a", error="no contact"), tmp_path / "a"))
    titles = [section.title for section in failed.sections]
    assert "Variants without a value" in titles
    assert "Outputs" not in titles
    assert failed.appendices == []
    assert failed.verdict is not None
    assert failed.verdict.text == "No variant has a value: 6 failed"
    made = study()
    place = StudyFolder(made, tmp_path / "b")
    place.make()
    place.write_state("")
    assert document(Record(made, tmp_path / "b")).verdict is not None


def test_many_columns_stand_on_pages_on_their_side(tmp_path: Path) -> None:
    outputs = {f"o{k}": "std_force_N" for k in range(30)}
    paper = document(Record(filled(tmp_path, outputs=outputs), tmp_path))
    appendix = paper.appendices[0]
    tables = [one for one in appendix.blocks if isinstance(one, Table)]
    assert appendix.on_side
    assert all(len(one.columns) <= ON_SIDE for one in tables)
    assert {one.columns[0].title for one in tables} == {"variant"}
    names = [column.title for one in tables for column in one.columns]
    assert [f"o{k}" for k in range(30)] == [name for name in names if re.match(r"o\d", name)]


def test_thousands_of_variants_are_bounded(tmp_path: Path) -> None:
    many = {"variables": {"force": FORCE}, "design": {"kind": "monte-carlo", "count": 1000}}
    paper = document(Record(filled(tmp_path, **many), tmp_path))
    (table, *_) = [one for one in paper.appendices[0].blocks if isinstance(one, Table)]
    assert len(table.rows) == variants.PRINTED
    assert any("300 of 1000 variants" in getattr(one, "text", "")
               for one in paper.appendices[0].blocks)  # fmt: skip


def test_the_file(tmp_path: Path) -> None:
    pytest.importorskip("typst", reason="typst is not installed")
    made = filled(tmp_path / "study", name="$x$ #panic() *b*")
    for name in ("a.pdf", "b.pdf"):
        write_pdf(made, tmp_path / name, tmp_path / "study", fields={"author": "A. Smith"})
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    text = text_of(tmp_path / "a.pdf")
    assert text.count("$x$ #panic() *b*") > 3
    assert "Study of pantograph and overhead line" in text
    assert "A Variants" in text


def test_commands_are_broken_only_between_their_words(tmp_path: Path) -> None:
    pytest.importorskip("typst", reason="typst is not installed")
    speed = {"field": "speed", "range": ["38 m/s", "61.111111111111114 m/s"]}
    made = load(written(tmp_path, variables={"v": {**speed, "count": 2}}))
    run(made, tmp_path / "study")
    paper = document(Record(made, tmp_path / "study"))
    rows = [row for one in blocks_of(paper, Table) for row in one.rows]
    commands = [row[0] for row in rows if isinstance(row[0], Cell) and row[0].command]
    assert len(commands) == 2
    write_pdf(made, tmp_path / "a.pdf", tmp_path / "study")
    text = text_of(tmp_path / "a.pdf")
    for one in commands:
        assert len(one.text) > 200  # longer than a line
        assert one.text in text


def test_a_study_that_was_not_begun_is_refused(tmp_path: Path) -> None:
    pytest.importorskip("typst", reason="typst is not installed")
    with pytest.raises(StudyError):
        write_pdf(study(), tmp_path / "a.pdf", tmp_path / "none")
    assert not (tmp_path / "a.pdf").exists()
