"""The page of reference cases: bars of values in their ranges, statements with their figures."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

from arcless.errors import OutputError
from arcless.model import load
from arcless.report import validation_page
from arcless.report.validation_page import entry, verdict
from arcless.report.validation_subject import Case, Conclusion, Evidence, Subject
from arcless.results import Result
from arcless.validate import Range, Row
from tests.support.bokeh_pages import document_in, mistakes_of, text_in
from tests.support.synthetic import scenario_data, synthetic_dataset

FORCE = Range("mean_force_N", "mean force <b>", "N", 110.0, 120.0, "A")
REMEMBERED = Range("std_force_N", "deviation", "N", 30.0, 40.0, "C*")
GAP = Range("max_gap_mm", "340 km/h: maximum gap", "mm", 1e-3, None, "A", strict=True, digits=3)


def row(allowed: Range, value: float | None, sure: float | None = None, **texts: str) -> Row:
    return Row.of("case", allowed, value, sure, **texts)


def results() -> list[Result]:
    made = []
    for speed in (50.0, 100.0):
        dataset = synthetic_dataset(
            duration_s=10.0,
            speed_m_s=speed,
            force=lambda t: 100.0 + 20.0 * np.sin(20.0 * t),
            gap=lambda t: 1e-4 * np.maximum(0.0, np.sin(5.0 * t)),
            scenario=scenario_data(speed=speed),
        )
        made.append(Result(dataset, load(json.loads(dataset.attrs["scenario"]))))
    return made


def subject(*, runs: bool = True, certainty: int | None = 8) -> Subject:
    rows = [row(FORCE, 115.0, 1.0), row(FORCE, 121.0, 0.5), row(REMEMBERED, 50.0)]
    holds = row(GAP, 0.1042, note="at 85 m <b>")
    conclusions = [
        Conclusion("1 first", "force", "the force", "2.5 kg", [holds]),
        Conclusion("2 second", "gap", "the gap", "none", [row(GAP, 0.0)]),
    ]
    topics = [Evidence("Closed forms", "sag & span", "1.0", 7, 4, 2, 0.5, 3)]
    return Subject(
        "all", certainty, [Case("case", "a standard", rows)], conclusions if runs else [],
        results() if runs else [], "a paper", topics,
    )  # fmt: skip


def test_the_headline_counts_what_decides() -> None:
    found = verdict([row(FORCE, 115.0), row(FORCE, 121.0), row(REMEMBERED, 50.0)])
    assert (found.state, found.text, found.rest) == (
        "missed", "Outside its verified range: 1 of 2 values", "1 inside",
    )  # fmt: skip
    assert "121.0 N, range 110 … 120 N (outside, mark A)" in found.items[0]
    assert found.items[1].startswith("0 of 1 values are inside ranges that are from memory")


def test_a_value_too_close_to_tell_is_neither() -> None:
    found = verdict([row(FORCE, 119.8, 0.5), row(FORCE, 115.0, 0.5)])
    assert (found.state, found.text, found.rest) == (
        "open", "1 of 2 values are inside the verified ranges", "1 too close to tell",
    )  # fmt: skip
    # A remembered range alone does not change what the headline says.
    assert verdict([row(FORCE, 115.0), row(REMEMBERED, 50.0)]).state == "met"


def test_a_bar_shows_the_value_in_its_range() -> None:
    bar = entry(row(FORCE, 115.0, 1.0)).bar
    assert bar is not None and bar.sure is not None
    begin, width = bar.band
    # The middle of the range is the middle of the band, and 1 N is a tenth of it.
    assert bar.value == pytest.approx(begin + 0.5 * width, abs=0.1)  # places have one decimal
    assert bar.sure[1] - bar.value == pytest.approx(0.1 * width, abs=0.1)
    far = entry(row(FORCE, 300.0)).bar
    assert far is not None
    assert 0.0 <= far.band[0] < sum(far.band) < far.value <= validation_page.LENGTH
    assert entry(row(GAP, 0.1)).bar is None  # no upper bound
    only = entry(row(Range("k", "loss", "%", 0.0, 0.0, "A"), 0.0)).bar
    assert only is not None and (only.band[1], only.value) == (0.0, only.band[0])


def test_a_value_is_told_apart_from_a_bound_next_to_it() -> None:
    shown = entry(row(FORCE, 120.04))
    assert (shown.value, shown.verdict) == ("120.04", "outside")
    assert entry(row(FORCE, 120.0)).value == "120.0"  # the bound itself
    assert entry(row(FORCE, None)).value == "–"


def test_the_page(tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    validation_page.write(subject(), file)
    page = file.read_text("utf-8")
    text = text_in(page)
    for words in (
        "F(t) at 180 km/h: 80.0 to 120.0 N", "F(t) at 360 km/h",
        "d(t) at 360 km/h: at most 0.10 mm",
        "Statement 1: first: holds", "Statement 2: second: does not hold",
        "Checked. the gap", "Assumption. 2.5 kg", "Source: a paper.", "Source: a standard.",
        "outside (unverified)", "mean force <b>", "115.0 ± 1.0 N", "sag & span",
        "7 values: 4 inside, 1 outside, 2 outside of unverified ranges",
        "arcless validate all --report page.html",
    ):  # fmt: skip
        assert words in text, words
    assert "d(t) at 180" not in text  # the paper shows gaps where there are some
    assert 'title="at 85 m &lt;b&gt;"' in page
    assert not re.search(r"(?:src|href)=[\"'](?!#|data:)", page[: page.index('id="data"')])
    assert len(page) < 2_000_000
    assert not mistakes_of(document_in(page))


def test_parts_that_there_are_none_of_are_left_out() -> None:
    page = text_in(validation_page.html(subject(runs=False, certainty=None)))
    assert "Founding paper" not in page
    assert "arcless validate all --once" in page


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(OutputError):
        validation_page.write(subject(runs=False), tmp_path / "no" / "page.html")
