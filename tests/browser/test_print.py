"""The page on paper: every figure is there and painted, and nothing is cut at the right."""

import base64
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from tests.browser.browser import PAPER, Page, rgb

on_a_desk = pytest.mark.parametrize("opened", [1400], indirect=True, scope="session")
# Of a figure's pixels: axes and one curve are several times as many.
PAINTED = 0.01
# Outlines by which a figure is found in a picture of paper.
FRAMED = """[...document.querySelectorAll(".plot")].forEach((one, number) => {
  one.style.outline = `3px solid rgb(255, 0, ${4 * number + 3})`;
})"""


@on_a_desk
def test_every_figure_is_painted_on_paper(page: Page, tmp_path: Path) -> None:
    if not shutil.which("pdftoppm"):
        pytest.skip("pdftoppm (poppler-utils) is missing: pages on paper are not looked at")
    page("emulateMedia", {"colorScheme": "dark"})
    page.do(FRAMED)
    paper = tmp_path / "paper.pdf"
    paper.write_bytes(base64.b64decode(page("pdf", {"format": "A4"})))
    sheets = pictures(paper)
    for number, key in enumerate(page.js("tried.keys()")):
        # An outline is drawn outside of its figure: an edge alone may lie on the next sheet.
        found = [
            inside for sheet in sheets for inside in framed(sheet, 4 * number + 3) if inside.size
        ]
        assert len(found) == 1, f"{key} is not on one sheet"
        assert np.mean((found[0] < 0.9).any(axis=2)) > PAINTED, f"{key} is blank"


def pictures(paper: Path) -> list[np.ndarray]:
    """Return the sheets as colours from 0 to 1, 60 pixels an inch."""
    from matplotlib.image import imread

    plain = ["-r", "60", "-aa", "no", "-aaVector", "no", "-png"]
    subprocess.run(["pdftoppm", *plain, paper, paper.with_suffix("")], check=True)
    return [imread(file)[..., :3] for file in sorted(paper.parent.glob("*.png"))]


def framed(sheet: np.ndarray, blue: int) -> list[np.ndarray]:
    """Return what lies inside of the outline with this share of blue, on a sheet that has it."""
    at = np.argwhere((np.round(255 * sheet) == (255, 0, blue)).all(axis=2))
    if not len(at):
        return []
    (top, left), (bottom, right) = at.min(axis=0) + 4, at.max(axis=0) - 4
    return [sheet[top:bottom, left:right]]


@on_a_desk
def test_nothing_is_cut_on_paper(page: Page) -> None:
    page("setViewportSize", PAPER)
    page("emulateMedia", {"media": "print", "colorScheme": "dark"})
    page.do("dispatchEvent(new Event('beforeprint'))")
    assert page.js("tried.overflow()") <= 0
    # A table that scrolls on a screen cannot do so on paper.
    assert (
        page.js("tried.clipped('.scroll, .plot, .paper, .paper text, h1, h2, h3, td, th, pre, dd')")
        == []
    )
    assert page.js("tried.keys().flatMap(tried.cut)") == []
    assert page.js("tried.wrong_colours('light')") == []
    assert page.js("tried.background()") == rgb(page.js("arcless.data.schemes.light.paper"))
    assert page.js("document.querySelectorAll('details:not([open], [data-screen])').length") == 0
    page.do("dispatchEvent(new Event('afterprint'))")
