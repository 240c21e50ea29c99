"""Names with markup, quotes, formulas and marks of direction are text in pages and tooltips."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.browser import kinds
from tests.browser.browser import Browser, Page

ELEMENTS = "[...document.querySelectorAll('*')].map((one) => one.localName)"
HANDLERS = (
    "[...document.querySelectorAll('*')].flatMap((one) => one.getAttributeNames())"
    ".filter((name) => name.startsWith('on'))"
)


@pytest.mark.parametrize("make", kinds.HOSTILE_PAGES.values(), ids=kinds.HOSTILE_PAGES.keys())
def test_names_are_text(browser: Browser, tmp_path: Path, make: Callable[[Path], Path]) -> None:
    with browser.open(make(tmp_path)) as page:
        elements = page.js(ELEMENTS)
        assert {"img", "iframe", "mjx-container", "object"}.isdisjoint(elements)
        # The data, Bokeh's script and the page's own.
        assert elements.count("script") == page.js("document.scripts.length") == 3
        assert page.js(HANDLERS) == []
        assert kinds.HOSTILE in page.js("document.querySelector('h1').textContent")
        assert (
            page.js("getComputedStyle(document.querySelector('h1 bdi')).unicodeBidi") == "isolate"
        )
        told, inside = tooltips(page)
        assert {"img", "script"}.isdisjoint(inside)
        if make is kinds.hostile_run:
            assert any(kinds.HOSTILE in text for text in told)
        assert page.js("typeof window.hacked") == "undefined"
        assert page.js("tried.overflow()") <= 0
        assert page.events == []


def tooltips(page: Page) -> tuple[set[str], set[str]]:
    """Return texts and elements of the tooltips at a point of each figure."""
    texts: set[str] = set()
    elements: set[str] = set()
    points = page.js("tried.keys().map((key) => [key, tried.points(key)])")
    for key, places in points:
        for across, down in places:
            box = page.box(key)
            page("mouse.move", box["x"] + across, box["y"] + down)
            found = page.js("tried.tooltips()")
            # Between dollars, so that Bokeh sees no formula.
            texts.update(text.replace("\u200b", "") for text in found["texts"])
            elements.update(found["elements"])
    return texts, elements
