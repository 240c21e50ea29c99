"""The pages of evidence say what the records say."""

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest

from arcless.validate.evidence import Topic
from tests.support.evidence import Evidence

DOCS = Path(__file__).parents[3] / "docs"


@pytest.fixture
def maker(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.setattr(sys, "path", [str(DOCS), *sys.path])
    return importlib.import_module("make_evidence")


def test_pages_are_made_from_the_records(maker: ModuleType) -> None:
    made = maker.pages()
    assert len(made) > 1
    for name, text in made.items():
        page = DOCS / "validation" / name
        assert page.is_file() and page.read_text(encoding="utf-8") == text, (
            f"{name} is not what its records make: run `python docs/make_evidence.py`"
        )


def test_pictures_are_there_and_used(maker: ModuleType) -> None:
    topics = maker.recorded()
    files = [figure["file"] for topic in topics for figure in topic.figures]
    for file in files:
        assert (DOCS / "images" / "validation" / file).is_file()
    assert maker.orphans(topics) == []


def test_runs_beside_their_limit_are_shown_by_pantograph(maker: ModuleType) -> None:
    table = [[50.0, 0.4, 0.1, 0.2, 0.0, 0.3, 1.0]]
    table += [[100.0, 20.0, 160.0, 40.0, 0.0, 0.5, -0.25, 0.75]] * 2
    evidence = Evidence("test")
    evidence.below("seed 1: run", 0.75, 1.0, unit="of its goal", reason="a goal", table=table)
    evidence.same("seed 1: verdicts", compared=9, differing=0, reason="a reason")
    page = maker.evidence_topic.page("limits", [Topic("limits", "x", "X", rows=evidence.rows)])
    assert "| run | 1 | 1 | 75 % | ≤ 1 of its goal | a goal |" in page
    assert "| seed 1 | 1 | 100.0 | +0.00 | 20.0 | +0.50 | 160.0 | -0.25 | 40.0 | +0.75 |" in page
    assert page.count("| 2 | 100.0 |") == 1
