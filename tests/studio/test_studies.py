"""Studies as somebody at the window makes them: define, watch, pick, open as a scenario."""

from collections.abc import Callable
from pathlib import Path

import pytest

import arcless
from arcless import study
from tests.studio.studio import DESK, PHONE, Studio, Window

Start = Callable[[Path], Studio]
# Short, so that a variant takes some hundredths of a second.
SCENARIO = """format: arcless-scenario/1
name: short
base: en50318-ac-simple-275-planar
set:
  line.spans: [{type: standard, count: 5}]
  travel: {start: 60 m, end: 180 m}
  analysis: {from: 100 m, to: 170 m}
  pantographs.0.static_force: 130 N
"""
ROWS = "document.querySelectorAll('.rows tbody tr:not([aria-hidden])').length"
CANVAS = "document.querySelector('.parallel canvas')"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with a short scenario."""
    (tmp_path / "short.yaml").write_text(SCENARIO)
    return tmp_path


def defining(studio: Start, folder: Path) -> Window:
    """Return a window in which two fields are ticked, each with three values."""
    page = studio(folder).open(DESK)
    page.click('nav >> text="short" >> nth=0')
    page.click('role=tab[name="Studies"]')
    for words, label in (("contact tension", "contact wire: tension"), ("speed", "speed")):
        page.type(words, into=".fields input[type=search]")
        page.click(f".fields label:has-text('{label}') input")
    page.until("document.querySelectorAll('.varied').length === 2")
    for number in (1, 2):
        page.type("3", into=f".varied:nth-of-type({number}) input[type=number]")
        page.press("Tab")
    page.wait("text=9 variants")
    return page


def test_a_study_is_defined_watched_and_a_variant_opened(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    assert page.axe() == []
    page.click('role=button[name="Save and start"]')
    page.until("document.querySelector('.state [role=status]')?.innerText.startsWith('9 of 9')")
    page.until(f"{ROWS} === 9")
    loaded = study.load(folder / "short-study.yaml")
    assert loaded.plan.count == 9
    page.click(".rows tbody tr:nth-child(4)")
    page.wait("text=Variant 4 >> nth=0")
    assert page.axe() == []
    page.click('role=button[name="Open as scenario"]')
    page.wait("text=is the scenario short-study-4.yaml")
    made = arcless.load(folder / "short-study-4.yaml")
    assert "base: short.yaml" in (folder / "short-study-4.yaml").read_text()
    # The fourth of a grid of three by three: the second tension, the first speed.
    assert made.line.contact_wire.tension == pytest.approx(22e3)
    assert made.speed == pytest.approx(0.9 * 275 / 3.6)


def test_brushes_by_mouse_and_by_keyboard(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    page.click('role=button[name="Save and start"]')
    page.until(f"{ROWS} === 9")
    page.type("21", into='[aria-label="Lowest tension"]')
    page.press("Tab")
    page.until(f"{ROWS} === 6")
    page.type("23", into='[aria-label="Highest tension"]')
    page.press("Tab")
    page.until(f"{ROWS} === 3")
    page.click('role=button[name="Show all"]')
    page.until(f"{ROWS} === 9")
    # The first axis stands below the middle of its head.
    x, y = page.js(
        f"(() => {{ const head = document.querySelector('.head').getBoundingClientRect();"
        f" return [head.x + head.width / 2, {CANVAS}.getBoundingClientRect().y]; }})()"
    )
    page("mouse.move", x, y + 8)
    page("mouse.down")
    page("mouse.move", x, y + 60)
    page("mouse.up")
    page.until(f"{ROWS} === 3")  # the highest tension alone
    page.click(".rows")
    page.press("ArrowDown")
    page.wait(".picked strong")


def test_what_is_wrong_is_said_before_anything_is_saved(studio: Start, folder: Path) -> None:
    page = defining(studio, folder)
    page.type("10 bananas", into=".varied:nth-of-type(1) .how input >> nth=0")
    page.wait(".define .problem")
    assert "bananas" in page.text(".define .problem")
    assert page.js("[...document.querySelectorAll('.define button.main')].every((b) => b.disabled)")
    assert not (folder / "short-study.yaml").exists()


def test_failed_variants_are_listed_with_their_sentence(studio: Start, folder: Path) -> None:
    (folder / "bad.yaml").write_text(
        """format: arcless-study/1
name: bad
scenario: short.yaml
variables:
  force: {field: pantographs.0.static_force, values: [130 N, -1 N]}
design: {kind: grid}
outputs: [mean_force_N]
"""
    )
    page = studio(folder).open(PHONE)
    page.click('nav >> text="short" >> nth=0')
    page.click('role=tab[name="Studies"]')
    page.click('.studies >> role=button[name="Watch"]')
    page.click('.choice >> role=button[name="Start"]')
    page.click(".failed summary")
    assert "static_force" in page.text(".failed li")
    page.click(".failed li button")
    page.wait(".picked .problem")
    assert page.js("document.documentElement.scrollWidth") <= PHONE["width"]
