"""The pages of evidence say what the records say."""

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest

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
