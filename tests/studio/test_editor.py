"""The editor, the drawing and the line at rest, as somebody at the window uses them."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.model import load_line
from arcless.model.scenario.overrides import apply_to_line
from tests.studio.studio import DESK, PHONE, SMALL, Studio, Window

LINES = Path(arcless.__file__).parent / "models" / "lines"
Start = Callable[[Path], Studio]
FILE = "line.yaml"
CANVAS = "document.querySelector('.line-view.side canvas')"
DRAWN = f"{CANVAS}?.getAttribute('aria-label')"
TEXT = ".yaml .cm-content"
# Of a text in a shadow tree, whose lines outside of the window are not there.
SAID = "document.querySelector('.yaml').shadowRoot.querySelector('.cm-content').innerText"
# A tension in the file that nothing else in it has.
TYPED, CHANGED = "22 kN", "24 kN"
# A picture of what is drawn, as a text.
PIXELS = f"{CANVAS}.toDataURL()"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with a line in space."""
    (tmp_path / FILE).write_text((LINES / "ac-simple-55-3d.yaml").read_text("utf-8"), "utf-8")
    return tmp_path


def opened(studio: Start, folder: Path, size: Any = DESK) -> Window:
    """Return a window in which the line of the folder is drawn."""
    page = studio(folder).open(size)
    page.part("Project")
    page.click(f'nav >> text="{load_line("ac-simple-55-3d").name}" >> nth=0')
    page.until(f"/20 spans/.test({DRAWN} ?? '')")
    return page


def yaml(page: Window) -> None:
    """Show the text next to the drawing."""
    page.click('.faces >> role=button[name="YAML"]')
    page.wait(TEXT)


def find(page: Window, text: str) -> None:
    """Select a text where it stands first."""
    page.click(TEXT)
    page.press("Control+Home", "Control+f")
    page.type(text)
    page.press("Enter", "Escape")


def saved(folder: Path, page: Window) -> str:
    """Return the text on the disk once what was typed is there."""
    page.until("document.querySelector('.save-state [role=status]').textContent === 'Saved'")
    return (folder / FILE).read_text("utf-8")


def test_what_is_typed_is_drawn_saved_and_undone(studio: Start, folder: Path) -> None:
    page, before = opened(studio, folder), (folder / FILE).read_text("utf-8")
    yaml(page)
    find(page, TYPED)
    before_pixels = page.js(PIXELS)
    page.type(CHANGED)
    page.until(f"{PIXELS} !== {json.dumps(before_pixels)}")
    page.until(f"{SAID}.includes('{CHANGED}')")
    assert saved(folder, page) == before.replace(TYPED, CHANGED, 1)
    page.click('role=button[name="Undo"]')
    page.until("document.querySelector('.save-state [role=status]').textContent !== 'Saved'")
    assert saved(folder, page) == before


def test_a_line_that_is_wrong_stays_drawn_pale_and_is_said(studio: Start, folder: Path) -> None:
    page = opened(studio, folder)
    yaml(page)
    find(page, TYPED)
    page.type("22 km")
    page.wait(".drawing .wrong")
    assert "Drawn is the last valid line" in page.text(".drawing .wrong")
    page.wait(".problems .error")
    assert "tension" in page.text(".problems .error")
    assert page.axe() == []
    page.press("Control+z")
    page.wait(".drawing .wrong", "hidden")
    page.wait(".problems.none")


def test_fields_change_the_text_and_the_text_the_fields(studio: Start, folder: Path) -> None:
    page, before = opened(studio, folder), (folder / FILE).read_text("utf-8")
    field = 'input[id="field-contact_wire.tension"]'
    page.wait(field)
    page.type("24", field)
    page.press("Enter")
    page.until("document.querySelector('.save-state [role=status]').textContent !== 'Saved'")
    assert saved(folder, page) == before.replace(TYPED, CHANGED, 1)
    assert page.axe() == []
    page.click('role=button[name="Undo"]')
    page.until(f"document.querySelector('{field}').value === '22'")
    assert saved(folder, page) == before


def test_a_dropper_is_added_and_removed_in_all_lists(studio: Start, folder: Path) -> None:
    page = opened(studio, folder)
    before = load_line(folder / FILE).span_types["standard"].droppers
    rows = "document.querySelectorAll('.droppers tbody tr').length"
    page.until(f"{rows} === {len(before.positions)}")
    page.click('[aria-label="Add a dropper after dropper 2"]')
    page.wait("text=half way between its neighbours")
    page.until(f"{rows} === {len(before.positions) + 1}")
    saved(folder, page)
    added = load_line(folder / FILE).span_types["standard"].droppers
    assert added.positions[2] == pytest.approx(sum(before.positions[1:3]) / 2, abs=0.01)
    assert before.presag is not None
    assert added.presag is not None
    assert added.presag[2] == pytest.approx(sum(before.presag[1:3]) / 2, abs=1e-4)
    page.click('[aria-label="Remove dropper 3"]')
    page.until(f"{rows} === {len(before.positions)}")
    saved(folder, page)
    after = load_line(folder / FILE).span_types["standard"].droppers
    assert (after.positions, after.presag) == (before.positions, before.presag)


def test_an_error_is_told_once_and_by_the_state_of_the_file(studio: Start, folder: Path) -> None:
    page = opened(studio, folder)
    page.type("5 m", into='[aria-label="Position of dropper 3"]')
    page.press("Tab")
    page.wait(".problems .error")
    page.wait(".save-state >> text=Saved, with an error")
    page.until("document.body.innerText.split('droppers out of order').length === 2")


@pytest.mark.evidence
def test_a_text_that_was_changed_elsewhere_is_shown_beside(studio: Start, folder: Path) -> None:
    page = opened(studio, folder)
    yaml(page)
    find(page, TYPED)
    page.type(CHANGED)
    other = (folder / FILE).read_text("utf-8").replace("1.20 m", "1.30 m", 1)
    (folder / FILE).write_text(other, "utf-8")
    page.wait(".conflict")
    page.events  # noqa: B018 - the browser says that a request was refused, as it was
    assert page.axe() == []
    page("selectOption", ".conflict select >> nth=1", "theirs")
    page.click('role=button[name="Save the pieces chosen below"]')
    page.wait(".conflict", "hidden")
    assert saved(folder, page) == other.replace(TYPED, CHANGED, 1)


def test_a_dropper_is_dragged_and_its_field_is_shown(studio: Start, folder: Path) -> None:
    page, before = opened(studio, folder), (folder / FILE).read_text("utf-8")
    box = page.js(f"{CANVAS}.getBoundingClientRect().toJSON()")
    y = box["y"] + 0.42 * box["height"]
    page("mouse.move", box["x"] + 0.5 * box["width"], y)
    for _ in range(12):
        page("mouse.wheel", 0, -100)
    told = "document.querySelector('.line-view.side .told').textContent"
    for step in range(0, int(box["width"]) - 100, 3):
        x = box["x"] + 60 + step
        page("mouse.move", x, y)
        if "dropper 5" in str(page.js(told)):
            break
    else:
        pytest.fail("no dropper is told")
    page("mouse.down")
    page("mouse.move", x + 15, y)
    page("mouse.up")
    page.until("document.querySelector('.save-state [role=status]').textContent !== 'Saved'")
    positions = re.compile(r"positions: \{value: (\[.*?\])")
    was, now = (json.loads(positions.search(text)[1]) for text in (before, saved(folder, page)))  # type: ignore[index]
    assert [a != b for a, b in zip(was, now, strict=True)] == [n == 4 for n in range(9)]


@pytest.mark.evidence
def test_numbers_follow_a_slider_and_are_written(studio: Start, folder: Path) -> None:
    page, before = opened(studio, folder), (folder / FILE).read_text("utf-8")
    page.click('role=tab[name="Statics"]')
    slider = 'input[type=range][id="slider-contact_wire.tension"]'
    page.wait(slider)
    page.until("/Hz/.test(document.querySelector('.numbers')?.textContent ?? '')")
    page("focus", slider)
    page.press(*["ArrowRight"] * 5)
    page.wait(".numbers .change")
    # Five steps of a fifth of a kilonewton.
    page.until("document.querySelector('.statics .draft').textContent === ''")
    changes = {"contact_wire.tension": "23 kN"}
    known = arcless.statics(apply_to_line(load_line("ac-simple-55-3d"), changes))
    force = known.droppers[9 * 9]["force_N"]
    page.until(f"document.querySelector('.statics tbody').textContent.includes('{force:.1f}')")
    assert f"{1e3 * known.contact_wire_sag_m:.1f} mm" in page.text(".numbers")
    assert (folder / FILE).read_text("utf-8") == before
    assert page.axe() == []
    page.click('role=button[name="Write to file"]')
    page.until("document.querySelector('.save-state [role=status]').textContent !== 'Saved'")
    assert saved(folder, page) == before.replace(TYPED, "23 kN", 1)


@pytest.mark.evidence
@pytest.mark.parametrize("size", [SMALL, PHONE])
def test_it_is_used_without_a_large_screen(studio: Start, folder: Path, size: Any) -> None:
    page = opened(studio, folder, size)
    assert page.axe() == []


def test_a_shipped_model_is_read_only_and_copied(studio: Start, folder: Path) -> None:
    page = studio(folder).open()
    page.click("nav summary:has-text('Library')")
    page.click('nav >> text="norway-s25" >> nth=0')
    page.click('role=button[name="Copy to my folder"]')
    page.type("my-line", "input[required]")
    page.press("Enter")
    page.until("document.querySelector('.save-state .path').textContent === 'my-line.yaml'")
    assert (folder / "my-line.yaml").exists()
