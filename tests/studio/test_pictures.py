"""The pictures of the guide show what the page says now, and are small."""

import json
from pathlib import Path

import pytest
from docs import make_studio

from tests.browser.browser import Browser


@pytest.mark.evidence
def test_the_words_in_the_pictures_are_those_of_the_page(browser: Browser, tmp_path: Path) -> None:
    kept = json.loads(make_studio.WORDS.read_text("utf-8"))
    for name, page in make_studio.every(browser, tmp_path):
        assert make_studio.words(page) == kept.pop(name), f"{name}: `make pictures` takes them anew"
    assert kept == {}


def test_the_pictures_are_small_and_all_there() -> None:
    files = {file.stem: file.stat().st_size for file in make_studio.FOLDER.glob("*.webp")}
    assert set(files) == {"start", *make_studio.VIEWS}
    assert sum(files.values()) <= make_studio.MOST
