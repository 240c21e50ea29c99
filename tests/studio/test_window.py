"""The window: first screen, keys, sizes, what it remembers, what it says without a server."""

import re
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.browser.browser import Browser
from tests.studio.studio import DESK, PHONE, SMALL, Studio

Start = Callable[[Path], Studio]


@pytest.fixture(scope="module")
def empty(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """Return the studio on an empty folder, for tests that leave it empty."""
    with Studio(browser, tmp_path_factory.mktemp("empty")) as found:
        yield found


def test_an_empty_folder_offers_an_example_and_all_shipped_models(empty: Studio) -> None:
    page = empty.open()
    page.wait("text=This folder has no models yet")
    assert "Copy and run it" in page.text(".example")
    assert page.count(".template") > 60
    page.type("germany 330", into=".start .search")
    page.until("document.querySelectorAll('.template').length < 5")
    assert "germany-re-330-300" in page.text(".templates")


@pytest.mark.parametrize("size", [DESK, SMALL, PHONE], ids=lambda size: f"{size['width']} px")
@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_accessible_and_nothing_is_wider_than_the_window(
    empty: Studio, size: dict[str, int], dark: bool
) -> None:
    page = empty.open(size, dark=dark)
    page.wait("text=This folder has no models yet")
    assert page.axe() == []
    assert page.js("document.documentElement.scrollWidth") <= size["width"]


def test_commands_and_keys(empty: Studio) -> None:
    page = empty.open()
    page.wait(".start")
    page.press("Control+k")
    page.wait("dialog [role=option]")
    assert page.axe() == []
    page.type("hide project")
    page.press("Enter")
    page.wait("dialog", "hidden")
    page.wait("nav.left", "hidden")
    page.press("Control+b")
    page.wait("nav.left")
    page.press("?")
    page.wait("text=On a Mac")
    assert page.axe() == []
    page.press("Escape")
    page.wait("dialog", "hidden")
    # In a field a question mark is a letter.
    page.click(".start .search")
    page.press("?")
    assert page.count("dialog") == 0


def test_a_speed_that_is_none_is_refused_where_it_is_typed(studio: Start, tmp_path: Path) -> None:
    text = "format: arcless-scenario/1\nname: mine\nbase: en50318-ac-simple-275-planar\n"
    (tmp_path / "mine.yaml").write_text(text)
    page = studio(tmp_path).open(DESK)
    run = "document.querySelector('.run-bar button.run')"
    page.until(f"{run}?.ariaDisabled === 'false'")
    page.type("abc", into=".run-bar .speed")
    page.press("Tab")
    page.wait("#speed-problem")
    assert "abc" in page.text("#speed-problem")
    assert page.js(f"{run}.ariaDisabled === 'true' && {run}.title.includes('abc')")
    assert page.count(".variant") == 0
    assert page.axe() == []
    page.type("250", into=".run-bar .speed")
    page.press("Tab")
    page.wait("text=/Variant of mine: speed 250 km.h/i")
    page.until(f"{run}.ariaDisabled === 'false'")


def test_sizes_are_remembered(empty: Studio) -> None:
    page = empty.open()
    page.wait(".start")
    before = page.js("document.querySelector('nav.left').clientWidth")
    page("focus", ".splitter.at-left")
    page.press("ArrowRight", "ArrowRight")
    wider = page.js("document.querySelector('nav.left').clientWidth")
    assert wider == before + 32
    page("reload")
    page.wait(".start")
    assert page.js("document.querySelector('nav.left').clientWidth") == wider


def test_a_scheme_is_chosen(empty: Studio) -> None:
    page = empty.open(dark=True)
    page.wait(".start")
    paper = "getComputedStyle(document.body).backgroundColor"
    dark = page.js(paper)
    page.press("Control+k")
    page.wait("dialog [role=option]")
    page.type("light, dark")
    page.press("Enter")
    page.until(f"{paper} !== {dark!r}")
    page("reload")
    page.wait(".start")
    assert page.js(paper) != dark


def test_a_file_that_cannot_be_read_is_in_the_tree_with_its_error(
    studio: Start, tmp_path: Path
) -> None:
    (tmp_path / "broken.yaml").write_text("format: arcless-line/1\nname: [\n", "utf-8")
    page = studio(tmp_path).open()
    page.wait(".broken")
    assert "broken" in page.text(".entry")
    assert re.search(r"broken.yaml:\d", page.text(".broken"))


def test_the_server_is_killed_and_started_again(studio: Start, tmp_path: Path) -> None:
    server = studio(tmp_path)
    page = server.open()
    page.wait(".start")
    port = server.port
    page.type("germany", into=".start .search")
    server.signal(signal.SIGKILL)
    page.wait("text=The server does not answer")
    assert page.js("document.title").startswith("No server")
    server.start(port)
    page.wait("text=Open the address that it printed")
    # A file made meanwhile is there, once the browser has the new server's cookie.
    (tmp_path / "new.yaml").write_text("format: arcless-line/1\nname: [\n", "utf-8")
    page.server_is_gone()
    beside = server.open(beside=page)
    beside.wait("main")
    page.wait(".lost", "hidden")
    page.wait("text=new")
    page.server_is_gone()
