"""Test runs laid over runs on paper: positions, bands and tolerances are those of the page."""

from pathlib import Path

import pytest

from arcless.comparison import compare
from arcless.comparison.page import html
from arcless.comparison.paper import document
from tests.support.beside import run, test_run
from tests.support.pdf import cells_of
from tests.unit.report.test_page import Page


def test_page_and_paper_say_the_same(tmp_path: Path) -> None:
    found = compare([run(), test_run(tmp_path / "test.csv", offset_m=3.2)])
    paper, page = document(found, found.figures), Page(html(found, found.figures))
    titles = [section.title for section in paper.sections]
    assert {"Bands", "Simulation against line test"} <= set(titles)
    assert "Changed fields" not in titles  # one run differs from none
    sources = {one.source for one in found.acceptance}  # under the pointer on the page
    cells = [" ".join(cell.split()) for cell in cells_of(paper)]
    assert len(cells) > 100
    assert [c for c in cells if c not in page.text and c not in {"pantographs", *sources}] == []


def test_measurements_alone_have_no_date(tmp_path: Path) -> None:
    pytest.importorskip("typst", reason="typst is not installed")
    other = test_run(tmp_path / "other.csv", offset_m=33.0, begin_m=120.0)
    found = compare([test_run(tmp_path / "one.csv"), other])
    assert document(found, found.figures).date == ""
    found.write_pdf(tmp_path / "both.pdf")
    assert b"<xmp:CreateDate>1970-01-01T00:00:00" in (tmp_path / "both.pdf").read_bytes()
