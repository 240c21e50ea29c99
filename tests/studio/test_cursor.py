"""One cursor and one selection in all views of a run and of its line; worst places lead there."""

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.browser.kinds import arcless
from tests.studio.studio import Studio, Window

Start = Callable[[Path], Studio]
TOLD = ".line-view.side .told"
READOUT = ".transport output.where"
SPEED = 320 / 3.6  # m/s


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a line, its scenario, and a run of it."""
    place = tmp_path_factory.mktemp("cursor")
    arcless("new", "line", "--from", "en50318-ac-simple-320-planar", "--to", place)
    arcless("run", place / "line.yaml", "--out", place / "runs" / "a", "--quiet", "--no-report")
    return place


@pytest.fixture
def page(studio: Start, folder: Path) -> Iterator[Window]:
    """Return a window that shows the line of the run and the fields of the line's file."""
    found = studio(folder).open()
    found.click('nav.left >> text="line-line"')
    found.wait(".form legend")
    found.click(".run-entry button.name")
    found.wait(".transport")
    found.until(f"document.querySelector('{READOUT}').textContent.includes(' m ')")
    yield found


def box(page: Window, selector: str) -> tuple[float, float, float, float]:
    """Return left, top, width and height of an element in px."""
    place = f"document.querySelector({selector!r}).getBoundingClientRect()"
    left, top, width, height = page.js(
        f"(({{x, y, width, height}}) => [x, y, width, height])({place})"
    )
    return left, top, width, height


def position(page: Window) -> float:
    """Return the position in m under the cursor, as the side view tells it."""
    page.until(f"/ · [\\d.]+ m · /.test(document.querySelector('{TOLD}').innerText)")
    found = re.search(r" · ([\d.]+) m · ", page.text(TOLD))
    assert found is not None
    return float(found[1])


def test_a_cursor_in_a_strip_stands_in_drawing_charts_and_tables(page: Window) -> None:
    page.wait(".strips canvas")
    left, top, width, height = box(page, ".strips canvas")
    page("mouse.move", left + 0.7 * width, top + height / 2)
    at = position(page)
    page.click('role=tab[name="Statics"]')
    page.wait(".statics tr.at-cursor")
    name = page.text(".statics tr.at-cursor th")
    assert int(name.split()[1]) == int(at // 55) + 1, "the table lists the span under the cursor"
    place = float(page.text(".statics tr.at-cursor td"))
    # Droppers are 5.75 m apart, and 9 m beside a support.
    assert abs(place - at) <= 4.5
    # A chart of statics moves it, too: the last mark is of the last span.
    left, top, width, height = box(page, ".statics .chart:nth-of-type(2) canvas")
    page("mouse.move", left + width - 20, top + height / 2)
    page.until("document.querySelector('.statics tr.at-cursor th').innerText.startsWith('span 20')")
    page.click('role=tab[name="Line"]')
    page.wait(".line-view.side canvas")
    assert page.text(TOLD) == "", "nobody points at the line"
    page("focus", ".line-view.side canvas")
    page.press("ArrowRight")
    assert position(page) > 19 * 55, "keys go on from where the cursor was"


def test_a_dropper_that_is_clicked_is_selected_everywhere(page: Window) -> None:
    page.wait(".line-view.side canvas")
    left, top, width, height = box(page, ".line-view.side canvas")
    for across in range(80, int(width) - 40, 4):
        page("mouse.move", left + across, top + 0.42 * height)
        if "dropper" in page.text(TOLD):
            break
    found = re.match(r"(span (\d+) dropper (\d+)) at ([\d.]+) m", page.text(TOLD))
    assert found is not None
    page("mouse.click", left + across, top + 0.42 * height)
    # Its position in the form, which counts from the support, and in the text.
    page.wait(".form input.here")
    offset = float(found[4]) - 55 * (int(found[2]) - 1)
    value = "document.querySelector('.form input.here').value"
    page.until(f"Math.abs(Number({value}) - {offset}) < 0.006")
    page.click('role=tab[name="Statics"]')
    page.wait(".statics tr[aria-selected=true]")
    assert page.text(".statics tr[aria-selected=true] th") == found[1]
    page.click('.faces >> role=button[name="YAML"]')
    page.wait(".yaml .cm-activeLine")
    text = page.js(
        "document.querySelector('.yaml').shadowRoot.querySelector('.cm-activeLine').innerText"
    )
    assert "positions" in text


def test_a_worst_place_leads_the_player_there_a_second_before(page: Window) -> None:
    page.click('role=tab[name="Why σ"]')
    page.wait("button.place")
    place = float(
        page.js("document.querySelector('button.place').closest('tr').cells[1].innerText")
    )
    page.click("button.place >> nth=0")
    wanted = place - SPEED
    where = f"Number(document.querySelector('{READOUT}').textContent.match(/([\\d.]+) m /)[1])"
    # Positions are told to 0.1 m.
    page.until(f"Math.abs({where} - {wanted}) < 0.2")
    number, count, at = re.fullmatch(
        r"worst place (\d+) of (\d+): \d+ N · ([\d.]+) m", page.text(TOLD)
    ).groups()  # type: ignore[union-attr]
    assert 1 <= int(number) <= int(count)
    assert abs(float(at) - place) < 0.1, "marked is the place itself"
    left, top, width, height = box(page, ".strips canvas")
    page("mouse.move", left + 0.7 * width, top + height / 2)
    position(page)
    page("mouse.move", left + 0.7 * width, 5)
    page.until(f"document.querySelector('{TOLD}').innerText.startsWith('worst place')")


def test_without_webgl_side_view_and_plan_stay(studio: Start, folder: Path) -> None:
    broken = (
        "const real = HTMLCanvasElement.prototype.getContext;"
        "HTMLCanvasElement.prototype.getContext = function (kind, ...more) {"
        " return kind.startsWith('webgl') ? null : real.call(this, kind, ...more); };"
    )
    page = studio(folder).open(before=broken)
    page.click(".run-entry button.name")
    page.wait(".line-view.side canvas")
    page.click('role=tab[name="3-D"]')
    page.wait("text=This browser offers no WebGL")
    assert page.axe() == []
    page.click('role=tab[name="Line"]')
    page.wait(".line-view.side canvas")
