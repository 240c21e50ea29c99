"""The report of a run on paper: all that the page says, with the same numbers."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless import report
from arcless.assess import assess
from arcless.assess.certainty_words import explained
from arcless.errors import OutputError
from arcless.report.paper import run_paper
from arcless.report.paper.blocks import Bars, Cell, Document, Pairs, Pictures, Table
from arcless.results import Result
from tests.support.pdf import blocks_of, cells_of, text_of
from tests.support.synthetic import scenario_data, synthetic_dataset
from tests.unit.report.test_page import BARE, NAMES, REFERENCE, Page, noise, result_of

# A bound for a document of a kilometre, in bytes: figures are vectors with some 10 000 points each.
MOST_BYTES = 3_000_000


@pytest.fixture(scope="module", params=["plain", "rich"])
def case(request: pytest.FixtureRequest) -> tuple[Result, dict[str, Any]]:
    """Return a result, and what its report is asked for: plain, or with all there may be."""
    if request.param == "plain":
        return result_of(synthetic_dataset()), {}
    dataset = synthetic_dataset(pantographs=NAMES, stagger_m=0.2, attrs={"warnings": ["beware"]})
    section = assess(dataset, section=(250.0, 350.0))
    return result_of(dataset), {"assessment": section, "reference_rows": [REFERENCE]}


@pytest.fixture(scope="module")
def both(case: tuple[Result, dict[str, Any]]) -> tuple[Page, Document]:
    """Return page and document of one run."""
    result, options = case
    return Page(report.html(result, **options)), run_paper.document(result, **options)


def test_every_cell_of_a_table_stands_on_the_page(both: tuple[Page, Document]) -> None:
    page, document = both
    text = page.text
    cells = cells_of(document)
    margins = [row["margin"] for row in _criteria(document)]
    assert len(cells) > 150
    # The page has values in SI under the pointer, and no margins.
    shown = [cell for cell in cells if cell not in margins and cell not in _si(document)]
    assert [cell for cell in shown if " ".join(cell.split()) not in text] == []


def _criteria(document: Document) -> list[dict[str, str]]:
    (table,) = [one for one in document.sections[1].blocks if isinstance(one, Table)]
    titles = [column.title for column in table.columns]
    return [dict(zip(titles, map(_text, row), strict=True)) for row in table.rows]


def _text(cell: Cell | str) -> str:
    return cell if isinstance(cell, str) else cell.text


def _si(document: Document) -> set[str]:
    tables = [one for one in blocks_of(document, Table) if one.columns[0].title == "field"]
    cells = [row[1] for table in tables for row in table.rows]
    return {cell.small for cell in cells if isinstance(cell, Cell)}


def test_figures_and_sections_are_those_of_the_page(both: tuple[Page, Document]) -> None:
    page, document = both
    figures = [one for block in blocks_of(document, Pictures) for one in block.figures]
    assert figures
    assert [one.title for one in figures if one.title not in page.titles] == []
    titles = [section.title for section in document.sections]
    own = {"Summary", "Sources", "Certainty of the numbers"}
    assert [title for title in titles if title not in page.titles and title not in own] == []
    assert all(one.alt for one in figures)


def test_the_verdict_is_that_of_the_page(both: tuple[Page, Document]) -> None:
    page, document = both
    assert document.verdict is not None
    assert document.verdict.text in page.text
    (bars,) = blocks_of(document, Bars)
    assert all(one.limit in page.text for group in bars.groups for one in group)
    for label, text in document.identity:
        assert f"{label} {text}" in page.text


def test_margins_are_distances_to_the_limit() -> None:
    dataset = synthetic_dataset(force=lambda t: 100.0 + 10.0 * np.sin(2.0 * np.pi * t))
    rows = {row["criterion"]: row for row in _criteria(run_paper.document(result_of(dataset)))}
    sigma = rows["standard deviation σ"]
    # σ = 10/√2 = 7.1 N, limit 0.3 · 100 N; to 0.1 N, the decimals of the table.
    assert float(sigma["margin"]) == pytest.approx(30.0 - 10.0 / 2**0.5, abs=0.11)
    lowest = rows["statistical minimum F_m − 3σ"]
    assert float(lowest["margin"]) == pytest.approx(100.0 - 30.0 / 2**0.5, abs=0.2)


def test_a_margin_beyond_the_limit_is_negative_and_counts_the_tolerance() -> None:
    dataset = synthetic_dataset(force=lambda t: 0.0 * t + 300.0)
    rows = {row["criterion"]: row for row in _criteria(run_paper.document(result_of(dataset)))}
    mean = rows["mean contact force F_m, upper limit"]
    limit, tolerance = (float(one) for one in mean["limit"].removeprefix("≤ ").split(" + "))
    assert mean["margin"].startswith("−")
    assert -float(mean["margin"][1:]) == pytest.approx(limit + tolerance - 300.0, abs=0.02)


def test_a_document_that_is_signed_has_no_times_of_a_machine() -> None:
    document = run_paper.document(result_of(synthetic_dataset()))
    labels = [label for block in blocks_of(document, Pairs) for label, _ in block.rows]
    assert "time steps" in labels
    assert [label for label in labels if "wall time" in label or "real-time" in label] == []
    method = {
        "wall_time_s": {"starts": 27.9, "other_family": 76.1}, "student_factor": 2.36, "runs": 8,
        "starts_m": [60.0, 112.5], "coverage": 0.95, "other_family": None,
    }  # fmt: skip
    assert "27.9 s of computing" in " ".join(explained(method))
    assert "of computing" not in " ".join(explained(method, with_times=False))


def test_a_verdict_that_is_unsure_is_not_coloured_as_met() -> None:
    assert run_paper.tone_of("met") == "met"
    assert run_paper.tone_of("missed") == run_paper.tone_of("outside") == "not_met"
    assert run_paper.tone_of("not met (unverified)") == run_paper.tone_of("not judged") == "open"
    assert run_paper.tone_of("absent") == run_paper.tone_of("") == ""


@pytest.fixture
def pdf(tmp_path: Path) -> Callable[..., Path]:
    pytest.importorskip("typst", reason="typst is not installed")
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")

    def write(result: Result, **options: Any) -> Path:
        file = tmp_path / "run.pdf"
        result.write_pdf(file, **options)
        return file

    return write


def test_numbers_of_the_file_are_those_of_the_assessment(
    case: tuple[Result, dict[str, Any]], pdf: Callable[..., Path]
) -> None:
    result, options = case
    text = text_of(pdf(result, fields={"author": "A. Smith", "document": "X-1"}, **options))
    numbers = (options.get("assessment") or result.assessment).pantographs
    for one in numbers:
        for value in (one.mean_force_N, one.std_force_N, one.max_force_N):
            assert f"{value:.1f}" in text
    assert "Prepared A. Smith" in text or "Author A. Smith" in text
    assert "X-1" in text
    assert "page 1 of" in text


EVIL = '#eval("…") $x$ *b* <a> @cite \\'


def test_users_words_are_shown_as_they_are(pdf: Callable[..., Path]) -> None:
    data = scenario_data(name=EVIL, description=EVIL, line__name=EVIL)
    attrs = {"command": EVIL, "warnings": [EVIL]}
    dataset = synthetic_dataset(scenario=data, pantographs=(EVIL, "$$x^2$$"), attrs=attrs)
    text = text_of(pdf(result_of(dataset)))
    # Title, description, line, headings of the model, warning, command, heads of pages.
    assert text.count(EVIL) > 10
    assert "$$x^2$$" in text


def test_a_record_with_little_in_it(pdf: Callable[..., Path]) -> None:
    attrs = {"command": None, "warnings": None, "setup_time_s": None, "slack_droppers_max": None}
    assert pdf(result_of(synthetic_dataset(without=BARE, attrs=attrs))).stat().st_size > 0


def test_a_kilometre_of_noise_is_bounded(pdf: Callable[..., Path]) -> None:
    dataset = synthetic_dataset(
        duration_s=40.0, speed_m_s=25.0, pantographs=("front", "rear"), force=noise,
        section=(200.0, 800.0), stagger_m=0.2,
    )  # fmt: skip
    assert pdf(result_of(dataset)).stat().st_size < MOST_BYTES


def test_the_same_result_is_the_same_file(pdf: Callable[..., Path]) -> None:
    dated = {"created": "2026-03-04T05:06:07+00:00"}
    first = pdf(result_of(synthetic_dataset(attrs=dated))).read_bytes()
    assert pdf(result_of(synthetic_dataset(attrs=dated))).read_bytes() == first


def test_a_file_of_another_kind_is_refused_before_anything_is_drawn(tmp_path: Path) -> None:
    class Untouched:
        """A result that nobody may look at."""

    with pytest.raises(OutputError, match=r"ends in \.pdf"):
        run_paper.write(Untouched(), tmp_path / "run.html")  # type: ignore[arg-type]


def test_the_scenario_is_told_once_with_its_sources() -> None:
    dataset = synthetic_dataset()
    document = run_paper.document(result_of(dataset))
    name = json.loads(dataset.attrs["scenario"])["name"]
    assert document.title == name
    assert document.sections[-1].title == "Sources"
