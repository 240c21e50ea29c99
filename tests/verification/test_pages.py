"""The pages of docs/validation say what the program says."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from arcless.results import Result
from arcless.validate import CASES, compare

PAGES = Path(__file__).parents[2] / "docs" / "validation"
RunOnce = Callable[..., Result]


def page_of(scenario: str) -> str:
    return "en50318-2002.md" if "2002" in scenario else "ac-simple.md"


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.scenario)
def test_values_are_current(run_once: RunOnce, case) -> None:
    text = (PAGES / page_of(case.scenario)).read_text(encoding="utf-8")
    speed = case.title.rpartition(", ")[2]
    printed = re.findall(rf"\| {speed} \| (.+?) \| .+? \| (-?[\d.]+) \|", text)
    rows = compare(case, run_once(case.scenario).assessment.to_dict())
    assert len(printed) == len(rows)
    for (quantity, value), row in zip(printed, rows, strict=True):
        assert quantity == f"{row.quantity} ({row.unit})"
        # One printed decimal, and what the rounding of another processor may grow to.
        assert float(value) == pytest.approx(row.value, rel=0.01, abs=0.3), quantity


@pytest.mark.parametrize("page", ["en50318-2002", "ac-simple", "convergence", "energy"])
def test_pages_say_how_they_were_made(page: str) -> None:
    text = (PAGES / f"{page}.md").read_text(encoding="utf-8")
    assert f"python docs/make_validation.py {page}" in text
    assert text.count("<!-- table: ") == text.count("<!-- end -->") > 0
    for name in re.findall(r"\]\((\w[\w-]*\.md)\)", text):
        assert (PAGES / name).is_file()
