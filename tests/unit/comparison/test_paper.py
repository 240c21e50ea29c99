"""A comparison on paper: the tables of its page, dated by its latest run."""

from pathlib import Path

import pytest

from arcless.comparison import compare
from arcless.comparison.page import html
from arcless.comparison.paper import document
from arcless.errors import ComparisonError
from arcless.figures.comparison import MOST_RUNS
from arcless.report.paper.blocks import Pictures, Points
from tests.support.pdf import blocks_of, cells_of, text_of
from tests.unit.comparison.test_comparison import made
from tests.unit.report.test_page import Page

OTHER = {"line__contact_wire__tension": "11 kN", "speed": "80 km/h"}


def test_page_and_paper_say_the_same() -> None:
    found = compare([made(100.0, 10.0), made(110.0, 15.0, scenario=OTHER), made(90.0, 5.0)])
    paper, page = document(found, found.figures), Page(html(found, found.figures))
    cells = cells_of(paper)
    assert len(cells) > 100
    hidden = {text for field in found.fields for text in field.si}  # under the pointer on the page
    own = {"pantographs", *hidden}  # the page says `pantograph` of one alone
    missing = [one for one in cells if one not in own and " ".join(one.split()) not in page.text]
    assert missing == []
    titles = [figure.title for one in blocks_of(paper, Pictures) for figure in one.figures]
    assert [title for title in titles if title not in page.titles] == []


def test_equal_runs_and_different_sections() -> None:
    paper = document(found := compare([made(), made()]), found.figures)
    assert cells_of(paper)
    assert not blocks_of(paper, Points)
    other = compare([made(), made(section=(50.0, 150.0))])
    (warnings,) = blocks_of(document(other, other.figures), Points)
    assert any("sections differ" in text for text in warnings.items)


def test_the_date_is_that_of_the_latest_run() -> None:
    dates = ("2026-01-02T03:04:05+00:00", "2026-02-03T04:05:06+00:00", "2026-01-09T00:00:00+00:00")
    found = compare([made(attrs={"created": date}) for date in dates])
    assert document(found, found.figures).date == dates[1]


def test_the_file(tmp_path: Path) -> None:
    pytest.importorskip("typst", reason="typst is not installed")
    found = compare([made(100.0, 10.0), made(110.0, 15.0, scenario=OTHER)])
    found.write_pdf(tmp_path / "a.pdf", fields={"author": "A. Smith"})
    found.write_pdf(tmp_path / "b.pdf", fields={"author": "A. Smith"})
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    text = text_of(tmp_path / "a.pdf")
    assert "Comparison of 2 runs" in text
    assert "+10.0 (+10.0 %)" in text.replace("\u00a0", " ")


def test_too_many_runs_are_refused(tmp_path: Path) -> None:
    many = compare([made(mean) for mean in range(100, 101 + MOST_RUNS)])
    with pytest.raises(ComparisonError, match="at most 6"):
        many.write_pdf(tmp_path / "many.pdf")
    assert not (tmp_path / "many.pdf").exists()
