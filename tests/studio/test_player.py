"""The player in a browser, on a known motion: clock, views, keys, a lost stream."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import arcless
from tests.studio.studio import DESK, PHONE, Studio, Window
from tests.support.small import small

Start = Callable[[Path], Studio]
KNOWN = Path(__file__).with_name("known_motion.js")
READOUT = ".transport output.where"
TIME = f"parseFloat(document.querySelector('{READOUT}').textContent.split('·').at(-1))"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a run."""
    place = tmp_path_factory.mktemp("player")
    (place / "runs" / "a").mkdir(parents=True)
    arcless.run(small()).save(place / "runs" / "a" / "result.nc")
    return place


@pytest.fixture
def page(studio: Start, folder: Path) -> Iterator[Window]:
    """Return a window in which a known motion is played."""
    yield opened(studio, folder)


def until(page: Window, expression: str) -> None:
    """Wait until an expression in the page is true; its policy allows no text that is run later."""
    page.js(
        "new Promise((done) => { const look = () =>"
        f" ({expression}) ? done() : requestAnimationFrame(look); look(); }})"
    )


def opened(studio: Start, folder: Path, size: Any = DESK, more: str = "") -> Window:
    found = studio(folder).open(size, before=KNOWN.read_text("utf-8") + more)
    found.part("Project")
    found.click(".run-entry button.name")
    found.wait(".transport")
    until(found, f"document.querySelector('{READOUT}').textContent.includes('100.0 m')")
    return found


def test_it_plays_where_the_pantograph_is(page: Window) -> None:
    page.click(".transport button[aria-label=Play]")
    until(page, f"{TIME} > 0.4")
    page.click(".transport button[aria-label=Pause]")
    assert page.count(".line-view.side canvas") == 1, "a run that is opened is seen"
    text = page.text(READOUT)
    span, position, time = text.split(" · ")
    place = 100.0 + 80.0 * float(time.removesuffix(" s"))
    # Tenths of metres, hundredths of seconds.
    assert float(position.removesuffix(" m")) == pytest.approx(place, abs=0.05 + 0.005 * 80)
    assert span == f"span {int(float(position.removesuffix(' m')) // 50) + 1}"
    assert page.js("known.wants.length") < 12


def test_keys_step_rows_and_spans(page: Window) -> None:
    page.js("document.activeElement.blur()")
    page.press("Shift+ArrowRight")
    until(page, f"document.querySelector('{READOUT}').textContent.includes('150.0 m')")
    page.press("ArrowLeft")
    until(page, f"{TIME} < 0.625")
    page.press("Space")
    page.wait(".transport button[aria-label=Pause]")


def test_worst_places_one_after_the_other(page: Window) -> None:
    page.js("document.activeElement.blur()")
    for place in (240, 320, 240):
        page.press("j")
        # A second before the place.
        until(page, f"document.querySelector('{READOUT}').textContent.includes('{place - 80}.0 m')")
    page.press("k")
    until(page, f"document.querySelector('{READOUT}').textContent.includes('{320 - 80}.0 m')")


def test_a_lost_stream_is_opened_again(page: Window) -> None:
    until(page, "known.wants.length > 1")
    page.js("known.sockets.at(-1).close()")
    until(page, "known.opened === 2")
    page.js("document.activeElement.blur()")
    page.click(".transport button[aria-label=Play]")
    until(page, f"{TIME} > 3")


@pytest.mark.parametrize("tab", ["Line", "3-D"])
def test_what_is_not_known_of_a_pantograph_is_no_number(
    studio: Start, folder: Path, tab: str
) -> None:
    page = opened(studio, folder, more="known.beside = 1;")
    page.click(f'role=tab[name="{tab}"]')
    page.js("document.activeElement.blur()")
    page.press("Space")
    until(page, f"{TIME} > 1.2")
    page.press("Space")
    # Text, names and values of the page; what is drawn is as finite: a canvas takes no NaN.
    assert "NaN" not in page.js("document.documentElement.outerHTML + document.body.innerText")
    assert page.close(allowed="ReadPixels") == []


def test_in_space(page: Window) -> None:
    page.click('role=tab[name="3-D"]')
    page.wait(".space canvas, .no-space")
    page.wait(".space .names span")
    assert page.count(".space .names span") > 1
    # Drawing in software warns of the time that it takes to read a picture.
    assert page.close(allowed="ReadPixels") == []


@pytest.mark.parametrize("size", [DESK, PHONE])
def test_it_can_be_reached(studio: Start, folder: Path, size: Any) -> None:
    found = opened(studio, folder, size)
    assert found.axe() == []


def test_the_motion_of_a_stored_run_is_computed(studio: Start, tmp_path: Path) -> None:
    # Long enough to be explained, which the page asks for at once.
    place = tmp_path / "runs" / "a"
    place.mkdir(parents=True)
    arcless.run(arcless.load("en50318-ac-simple-320-planar")).save(place / "result.nc")
    found = studio(tmp_path).open()
    found.click(".run-entry button.name")
    found.click("text=Compute motion")
    found.wait(".motion-tools >> text=no recorded motion", "hidden")
    assert [one.name for one in place.iterdir()] == ["result.nc"]


def test_a_phone_shows_one_part_and_below_it_the_player_in_one_row(
    studio: Start, folder: Path
) -> None:
    found = opened(studio, folder, PHONE)
    assert found.count(".body[data-part=main]") == 1, "a run that is opened is seen"
    box = (
        "(({{top, bottom, height}}) => [top, bottom, height])"
        "(document.querySelector('{}').getBoundingClientRect())"
    )
    parts = found.js(box.format("nav.parts"))
    bar = found.js(box.format(".transport"))
    strips = found.js(box.format(".strips"))
    drawn = found.js(box.format(".line-view.side canvas"))
    assert parts[1] <= PHONE["height"]
    assert bar[2] < 60, "one row"  # px: a button of 34 px, spaces, a bar to scroll with
    assert drawn[2] > 150
    assert strips[1] <= bar[0] + 1, "strips are not behind the player"
    assert found.js("document.documentElement.scrollHeight") <= PHONE["height"]
    found.click("summary >> text=Options")
    menu = "document.querySelector('.run-bar .pop').getBoundingClientRect()"
    assert found.js(f"{menu}.right") <= PHONE["width"]
    found.press("Escape")
    found.part("Fields")
    assert found.js("document.querySelector('.slot.right').clientHeight") > 400
    found.press("Control+b")
    found.wait("nav.left .run-entry")
    found.until("document.activeElement.closest('nav.left') !== null")
