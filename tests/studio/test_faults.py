"""Faults around the page: it says what happened, loses nothing, and recovers by itself."""

import re
import shutil
import signal
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from page.build import BUILT

from tests.browser.browser import Browser
from tests.drills.conftest import SHORT
from tests.studio.studio import Studio, Window
from tests.studio.test_editor import SAID, TEXT, find, yaml

Start = Callable[[Path], Studio]
GONE = "text=The server does not answer"
SAVE_STATE = "document.querySelector('.save-state [role=status]').textContent"
# Time in ms in which the page says that a server is silent: five looks, one each second.
SILENT = 10_000
RUN = 60_000  # ms
# Steps so short that a run takes some seconds, or less than one.
SLOW, QUICK = "0.05 ms", "2 ms"
# A scheme without damping, and steps too long for light wires: `tests/scenarios/test_choices.py`.
GROWS = """
format: arcless-scenario/1
name: grows
base: praks-340
set:
  contact.law: compliant
  solver.time_step: 1 ms
  solver.scheme: trapezoidal
  line.contact_wire.mass: 0.89 kg/m
  line.dropper.clamp_mass_contact_wire: 0 kg
"""


def scenario(folder: Path, name: str, time_step: str) -> Path:
    """Write a short scenario with a time step; return its file."""
    text = SHORT.read_text("utf-8").replace("name: short\n", f"name: {name}\n")
    file = folder / f"{name}.yaml"
    file.write_text(text.replace("{time_step: 2 ms}", f"{{time_step: {time_step}}}"), "utf-8")
    return file


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with a scenario whose run takes some seconds."""
    scenario(tmp_path, "slow", SLOW)
    return tmp_path


def begun(page: Window) -> None:
    """Begin the run of the chosen scenario, and wait until it steps and is played."""
    page.wait("button.run:not([aria-disabled=true])")
    page.press("Control+Enter")
    page.wait(".transport .live")


def progress(page: Window) -> float:
    return float(page.js("document.querySelector('.running progress')?.value ?? 1"))


def stopped_in_a_run(server: Studio, page: Window, seconds: float, *, with_all: bool) -> None:
    """Type, have all or the server alone stopped in the midst of a run, and see what came of it."""
    yaml(page)
    begun(page)
    before = progress(page)
    find(page, "160 km/h")
    with server.stopped(with_all=with_all):
        if not with_all:
            page.type("158 km/h")
            page.wait(GONE, patience=SILENT)
            assert page.js("document.title").startswith("No server")
        time.sleep(seconds)
    if with_all:
        page.type("158 km/h")
    page.wait(GONE, "hidden")
    page.until(f"{SAVE_STATE} === 'Saved'")
    assert "speed: 158 km/h" in (server.folder / "slow.yaml").read_text("utf-8")
    assert before < 1.0
    page.until("document.querySelectorAll('.run-entry').length === 1", RUN)
    page.wait(".verdict-of .numbers")
    assert page.count(".messages li") == 0
    page.server_is_gone()


@pytest.mark.evidence
def test_a_server_that_is_stopped_is_said_not_to_answer(studio: Start, folder: Path) -> None:
    server = studio(folder)
    stopped_in_a_run(server, server.open(), 0.0, with_all=False)


@pytest.mark.evidence
def test_server_and_page_stopped_as_on_a_closed_laptop(studio: Start, folder: Path) -> None:
    server = studio(folder)
    page = server.open()
    # Whether the page says for a moment that nobody answers.
    page.js("new MutationObserver(() => { window.said ||= !!document.querySelector('.lost'); })"
            ".observe(document.body, {childList: true, subtree: true})")  # fmt: skip
    stopped_in_a_run(server, page, 4.0, with_all=True)
    assert not page.js("window.said")
    page.wait(TEXT)


@pytest.mark.evidence
def test_a_run_that_was_ended_with_its_server_is_offered_again(studio: Start, folder: Path) -> None:
    server = studio(folder)
    page = server.open()
    begun(page)
    server.signal(signal.SIGKILL)
    page.wait(GONE)
    server.start(server.port)
    server.open(beside=page).wait("button.run")
    page.wait("text=was ended with the server that computed it.")
    page.wait(".transport .live", "hidden")
    page.wait(".running", "hidden")
    page.server_is_gone()
    assert page.axe() == []
    scenario(folder, "slow", QUICK)
    page.click(".messages >> text=Run again")
    page.until("document.querySelectorAll('.run-entry').length === 1", RUN)
    page.wait(".verdict-of .numbers")
    assert page.count(".messages li") == 0


@pytest.mark.evidence
def test_two_tabs_type_in_one_file(studio: Start, folder: Path) -> None:
    server = studio(folder)
    one = server.open()
    two = server.open(beside=one)
    for page in (one, two):
        page.wait("button.run:not([aria-disabled=true])")
        yaml(page)
    find(one, "160 km/h")
    find(two, "22 kN")
    # Both type before either of them has heard of the other: without a server nothing is saved.
    with server.stopped(with_all=False):
        one.type("158 km/h")
        two.type("24 kN")
        for page in (one, two):
            page.until(f"{SAVE_STATE} === 'Saving'")
    # The one that came later is asked, and has both texts beside one another.
    found = "document.querySelectorAll('.conflict').length"
    for page in (one, two):
        page.until(f"{found} === 1 || {SAVE_STATE} === 'Saved'")
    later, first = (one, two) if one.js(found) else (two, one)
    assert later.js(found) == 1
    assert first.js(found) == 0
    texts = later.text(".conflict .texts")
    assert all(typed in texts for typed in ("158 km/h", "24 kN"))
    # The tension stands above the speed: of each the piece is taken that was typed.
    sides = ("theirs", "mine") if later is one else ("mine", "theirs")
    for place, side in enumerate(sides):
        later("selectOption", f".conflict select >> nth={place}", side)
    later.events  # noqa: B018 - the browser says that a request was refused, as it was
    later.click('role=button[name="Save the pieces chosen below"]')
    for page in (one, two):
        page.until(f"{SAID}.includes('158 km/h') && {SAID}.includes('24 kN')")
        page.until(f"{SAVE_STATE} === 'Saved'")
    saved = (folder / "slow.yaml").read_text("utf-8")
    assert "speed: 158 km/h" in saved
    assert "tension: 24 kN" in saved


def test_two_tabs_see_one_run(studio: Start, folder: Path) -> None:
    server = studio(folder)
    one = server.open()
    two = server.open(beside=one)
    two.wait("button.run:not([aria-disabled=true])")
    begun(one)
    two.wait(".running progress")
    two.click("text=Watch")
    two.wait(".transport .live")
    for page in (one, two):
        page.until("document.querySelectorAll('.run-entry').length === 1", RUN)
        page.wait(".transport .live", "hidden")
    assert two.count(".messages li") == 0


def update(page: Path) -> None:
    """Give all built files of a page other names, as another version has them."""
    files = [file for file in page.rglob("*") if file.suffix in {".js", ".css", ".html"}]
    names = {file.name: f"{file.stem}0{file.suffix}" for file in files if file.suffix != ".html"}
    for file in files:
        text = file.read_text("utf-8")
        for old, new in names.items():
            text = text.replace(old, new)
        file.unlink()
        file.with_name(names.get(file.name, file.name)).write_text(text, "utf-8")


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    """Return a copy of the built page."""
    return shutil.copytree(BUILT, tmp_path / "page")


@pytest.mark.evidence
def test_a_part_of_a_page_that_was_updated(browser: Browser, folder: Path, copied: Path) -> None:
    with Studio(browser, folder, page=copied) as server:
        page = server.open()
        page.wait("button.run:not([aria-disabled=true])")
        page.type("170 km/h", into=".run-bar .speed")
        page.press("Enter")
        update(copied)
        page.click("role=tab[name=Statics]")
        page.wait("text=Arcless was updated")
        # What the browser says of files that are not there, and no error of the page.
        others = [one for one in page.events if "404" not in one and "MIME type" not in one]
        assert others == []
        assert page.axe() == []
        page.events  # noqa: B018 - axe looks for the style sheet that is not there
        page.click("text=Reload the page")
        page.wait("text=Arcless was updated", "hidden")
        page.until("document.querySelector('.run-bar .speed')?.value === '170 km/h'")
        page.wait(".statics")


@pytest.mark.evidence
def test_a_page_that_was_updated_while_the_server_was_away(
    browser: Browser, folder: Path, copied: Path
) -> None:
    with Studio(browser, folder, page=copied) as server:
        page = server.open()
        page.wait("button.run:not([aria-disabled=true])")
        yaml(page)
        find(page, "160 km/h")
        server.signal(signal.SIGKILL)
        page.wait(GONE)
        page.type("158 km/h")
        update(copied)
        server.start(server.port)
        # What another version would not read is in the draft all the same.
        assert "158 km/h" in page.js("Object.values(localStorage).join()")
        server.open(beside=page).wait("button.run")
        page.wait("text=Arcless was updated")
        page.until(f"{SAVE_STATE} === 'Saved'")
        assert "speed: 158 km/h" in (folder / "slow.yaml").read_text("utf-8")
        page.server_is_gone()
        page.click("text=Reload the page")
        page.wait("text=Arcless was updated", "hidden")
        yaml(page)
        page.until(f"{SAID}.includes('158 km/h')")


@pytest.mark.evidence
def test_a_run_that_grows_beyond_all_bounds(studio: Start, tmp_path: Path) -> None:
    (tmp_path / "grows.yaml").write_text(GROWS, "utf-8")
    page = studio(tmp_path).open()
    page.wait("button.run:not([aria-disabled=true])")
    page.press("Control+Enter")
    page.wait(".messages .error", patience=RUN)
    told = page.text(".messages .error")
    where = re.search(r"t = ([\d.]+) s, P1 at ([\d.]+) m: the motion grew beyond all bounds", told)
    assert where, told
    page.wait(".drawing .failed")
    # In the drawing the time has three digits, the position as many as in the message.
    assert f"t = {float(where[1]):.3f} s, P1 at {where[2]} m." in page.text(".drawing .failed")
    assert page.axe() == []
    page.click("text=Show the place")
    page.click("text=Replay up to t = ")
    page.until("document.querySelector('.transport button[aria-label=Pause]')")
    page.wait(".transport button[aria-label=Play]")  # it stops at the end
    end = float(page.text(".transport .where").split(" · ")[-1].removesuffix(" s"))
    # The last row of motion, one each 10 ms, is before the step that failed; both are rounded.
    assert float(where[1]) - 0.03 < end <= float(where[1]) + 0.01
    assert not (tmp_path / "runs").exists() or list((tmp_path / "runs").iterdir()) == []
