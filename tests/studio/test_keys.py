"""Keys of the window: each does what the list says, and is a letter where one types."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import arcless
from tests.browser.kinds import arcless as command
from tests.studio.studio import Studio, Window
from tests.support.small import small

Start = Callable[[Path], Studio]
KNOWN = Path(__file__).with_name("known_motion.js")
READOUT = ".transport output.where"
TIME = f"parseFloat(document.querySelector('{READOUT}').textContent.split('·').at(-1))"
POSITION = f"document.querySelector('{READOUT}').textContent"
HEIGHTS = "Number(document.querySelector('.drawing label[title=E] select').value)"
TAB = "document.querySelector('main [role=tab][aria-selected=true]').textContent"
# Keys of the list, as the window writes them.
LISTED = ("Space", "←", "→", "Shift→", "J", "K", "F", "E", "C", "CtrlEnter", "CtrlK", "?")


@pytest.fixture
def page(studio: Start, tmp_path: Path) -> Iterator[Window]:
    """Return a window in which a known motion is played, in a folder with a scenario."""
    command("new", "line", "--from", "en50318-ac-simple-320-planar", "--to", tmp_path)
    (tmp_path / "runs" / "a").mkdir(parents=True)
    arcless.run(small()).save(tmp_path / "runs" / "a" / "result.nc")
    found = studio(tmp_path).open(before=KNOWN.read_text("utf-8"))
    found.wait(".run-bar .speed")
    # Drawings begin with 20, until the line at rest is there and fitted; a run has one of its own.
    found.until(f"{HEIGHTS} !== 20")
    found.click(".run-entry button.name")
    found.wait(".transport")
    found.until(f"{POSITION}.includes('100.0 m')")
    found.wait(".transport >> text=Next worst place")
    yield found


def test_each_key_does_what_the_list_says(page: Window) -> None:
    # The run was clicked: Space is meant for the player, and does not open the run anew.
    page.press("Space")
    page.until(f"{TIME} > 0.1")
    page.press("Space")
    page.wait(".transport button[aria-label=Play]")
    page.press("Home")
    page.until(f"{TIME} === 0")
    page.press("ArrowRight", "ArrowRight", "ArrowRight", "ArrowLeft")
    page.until(f"{TIME} > 0.01 && {TIME} < 0.1")
    page.press("Home", "Shift+ArrowRight")
    page.until(f"{POSITION}.includes('150.0 m')")
    page.press("Shift+ArrowLeft")
    page.until(f"{POSITION}.includes('100.0 m')")
    # A second before worst places at 240 and 320 m, at 80 m/s.
    page.press("j", "j")
    page.until(f"{POSITION}.includes('240.0 m')")
    page.press("k")
    page.until(f"{POSITION}.includes('160.0 m')")
    before = page.js(HEIGHTS)
    page.press("e")
    page.until(f"{HEIGHTS} > {before}")
    page.press("Shift+E")
    page.until(f"{HEIGHTS} === {before}")
    page.press("f")
    page.until("!document.querySelector('.motion-tools input[type=checkbox]').checked")
    page.press("c")
    page.until(f"{TAB} === 'Compare'")
    page.press("Control+k")
    page.wait("dialog [role=option]")
    page.press("Escape")
    page.wait("dialog", "hidden")
    page.press("?")
    page.wait(".key-table")
    listed = page.js(
        "[...document.querySelectorAll('.key-table .keys > span')].map((one) => one.textContent)"
    )
    assert [key for key in LISTED if key not in listed] == []
    page.press("Escape")
    page.wait("dialog", "hidden")
    page.press("Control+Enter")
    page.until("known.opened === 2")


def test_keys_are_letters_in_fields_and_in_the_editor(page: Window) -> None:
    page.press("Shift+ArrowRight")
    page.until(f"{POSITION}.includes('150.0 m')")
    dialogs = "document.querySelectorAll('dialog').length"
    state = f"JSON.stringify([{POSITION}, {HEIGHTS}, {TAB}, {dialogs}])"
    before = page.js(state)
    keys = ("j", "k", "f", "e", "c", "?", "Space", "ArrowLeft", "ArrowRight", "Home")
    page.click(".run-bar .speed")
    page.press(*keys)
    assert page.js(state) == before
    assert "jkfec? " in page.js("document.querySelector('.run-bar .speed').value")
    # Where it is left, a row appears below it, which moves what is to be clicked.
    page.click(".motion-tools")
    page.wait("#speed-problem")
    page.click('.faces >> role=button[name="YAML"]')
    page.click(".yaml .cm-content")
    page.press(*keys)
    assert page.js(state) == before


def test_the_tree_by_keys(page: Window) -> None:
    # Not in the tree already, which the key would then hide.
    page.js("document.activeElement.blur()")
    page.press("Control+b")
    page.until("document.activeElement.closest('nav.left') !== null")
    name = "document.activeElement.closest('.run-entry') !== null"
    for _ in range(20):
        page.press("ArrowDown")
        if page.js(name):
            break
    box = page.js("document.activeElement.closest('.run-entry').querySelector('input').ariaLabel")
    title = page.text(".run-entry .run-title")
    assert box.startswith(f"Overlay {title}")
    ticked = "document.querySelector('.run-entry input').checked"
    was = page.js(ticked)
    page.press("Space")
    page.until(f"{ticked} !== {str(was).lower()}")
    page.press("Control+b")
    page.wait("nav.left", "hidden")


def test_the_palette_has_what_is_typed_at_once(page: Window) -> None:
    before = page.js(HEIGHTS)
    # Without waiting for anything: all keys in one task of the page.
    page.js(
        "for (const [key, ctrlKey] of [['k', true], ...[...'heights'].map((one) => [one, false])])"
        " document.activeElement.dispatchEvent(new KeyboardEvent('keydown',"
        " {key, ctrlKey, bubbles: true, cancelable: true}))"
    )
    page.wait("dialog [role=option]")
    page.until("document.activeElement.matches('dialog input')")
    assert page.js("document.activeElement.value") == "heights"
    assert page.js(HEIGHTS) == before
    page.press("Escape")


def test_the_focus_stays_where_a_run_was_begun(page: Window) -> None:
    page.click(".run-bar .speed")
    page.press("Control+Enter")
    page.until("known.opened === 2")
    assert page.js("document.activeElement.matches('.run-bar .speed')")
