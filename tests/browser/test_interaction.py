"""Zoom, cross hair, legends, buttons and touch, as a reader uses the figures along the track."""

import re
from pathlib import Path

import pytest

from tests.browser.browser import Browser, Page, rgb

desk = pytest.mark.parametrize("opened", [1400], indirect=True, scope="session")
phone = pytest.mark.parametrize("opened", [390], indirect=True, scope="session")
runs = pytest.mark.parametrize("file", ["two wires"], indirect=True, scope="session")
along_track = pytest.mark.parametrize(
    "file", ["two wires", "statics"], indirect=True, scope="session"
)

# A pixel of a frame 300 px wide (the narrowest one here), as a part of the range.
PIXEL = 1 / 300


def first(page: Page) -> str:
    """Return the first figure along the track."""
    found: str = page.js("tried.track()[0]")
    return found


def press(page: Page, selector: str) -> None:
    page("click", f"nav.contents {selector}")


@desk
@along_track
def test_a_box_zooms_all_figures_along_the_track(page: Page) -> None:
    start, end = page.js("tried.range()")
    before = page.js("tried.track().map((key) => tried.hash(key))")
    assert len(before) > 3
    page.drag(first(page), (0.25, 0.3), (0.5, 0.6))
    wanted = [start + part * (end - start) for part in (0.25, 0.5)]
    for found in page.js("tried.ranges()"):
        assert found == pytest.approx(wanted, abs=2 * PIXEL * (end - start))
    after = page.js("tried.track().map((key) => tried.hash(key))")
    assert all(one != other for one, other in zip(before, after, strict=True))
    page.drag(first(page), (0.2, 0.3), (0.8, 0.6))  # Bokeh itself would go back one step
    box = page.box(first(page))
    page("mouse.dblclick", box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page("mouse.move", 1, 1)
    assert page.js("tried.range()") == [start, end]
    assert page.js("tried.track().map((key) => tried.hash(key))") == before


@desk
@runs
def test_a_drag_moves_after_the_switch(page: Page) -> None:
    press(page, "[data-drag=pan]")
    assert page.js("document.querySelector('[data-drag=pan]').ariaPressed") == "true"
    assert page.js("document.querySelector('[data-drag=zoom]').ariaPressed") == "false"
    start, end = page.js("tried.range()")
    page.drag(first(page), (0.5, 0.5), (0.4, 0.5))
    shift = 0.1 * (end - start)  # there is more of the line than that beyond the run
    near = pytest.approx([start + shift, end + shift], abs=2 * PIXEL * (end - start))
    assert page.js("tried.range()") == near
    press(page, "[data-drag=zoom]")
    page.drag(first(page), (0.5, 0.5), (0.4, 0.7))
    found = page.js("tried.range()")
    assert found[1] - found[0] == pytest.approx(shift, abs=2 * PIXEL * (end - start)), found


@desk
@runs
def test_buttons_show_the_section_and_the_whole_run(page: Page) -> None:
    whole = page.js("tried.range()")
    section = page.js("arcless.data.track.section")
    assert section != whole
    press(page, "[data-show=section]")
    assert page.js("tried.ranges()") == [section] * page.js("tried.track().length")
    press(page, "[data-show=all]")
    assert page.js("tried.range()") == whole


@desk
@along_track
def test_the_cross_hair_stands_in_all_figures(page: Page) -> None:
    start, end = page.js("tried.range()")
    assert page.js("tried.track().map((key) => tried.ink(key, 'overlays'))") == [0] * page.js(
        "tried.track().length"
    )
    told = []
    for across in (0.3, 0.6):
        page.point(first(page), across, 0.5)
        place = page.js("tried.cross().location")
        assert place == pytest.approx(start + across * (end - start), abs=PIXEL * (end - start))
        assert all(page.js("tried.track().map((key) => tried.ink(key, 'overlays'))"))
        told.append(page.js("document.querySelector('.cursor').textContent"))
        assert re.fullmatch(rf"{place:.1f} m, span \d+.*", told[-1])
    assert told[0] != told[1]
    # The line is where the other figure has that place.
    other = page.js("tried.track()[1]")
    columns = page.js(f"tried.columns({other!r}, 'overlays')")
    box = page.js(f"tried.inner({other!r})")
    expected = box["left"] + 0.6 * box["width"]
    assert min(abs(column - expected) for column in columns) <= 2  # px, with the line's width


@desk
def test_entries_of_legends_hide_what_they_name(page: Page) -> None:
    """Each entry is pressed twice: [pressed, all visible, any visible] before, between, after."""
    seen = page.js("tried.entries()")
    assert seen
    for name, before, between, after in seen:
        assert before == [before[0]] * 3, name
        assert between == [not before[0]] * 3, name
        assert after == before, name


@desk
@along_track
def test_a_hidden_curve_is_not_painted(page: Page) -> None:
    key = first(page)
    before = page.js(f"tried.hash({key!r})")
    entry = f"#figure-{key} .legend li:first-child button"
    page("click", entry)
    page("mouse.move", 1, 1)
    assert page.js(f"tried.hash({key!r})") != before
    page("click", entry)
    page("mouse.move", 1, 1)
    assert page.js(f"tried.hash({key!r})") == before


@pytest.mark.parametrize("file", ["run"], indirect=True, scope="session")
def test_dark_by_the_system_and_by_the_button(browser: Browser, file: Path) -> None:
    with browser.open(file, dark=True) as page:
        schemes, key = page.js("arcless.data.schemes"), first(page)
        token = page.js(f"document.querySelector('#figure-{key} .swatch').style.cssText")
        name = token.split("--", 2)[2].rstrip(";) ").replace("-", "_")
        assert schemes["dark"][name] != schemes["light"][name]
        for scheme in ("dark", "light", "dark"):
            assert page.js("tried.background()") == rgb(schemes[scheme]["paper"])
            assert page.js(f"tried.wrong_colours({scheme!r})") == []
            # What the legend names first lies on top.
            assert page.js(f"tried.coloured({key!r}, {schemes[scheme][name]!r})") > 0
            press(page, "[data-scheme-switch]")
        assert page.events == []


@phone
@along_track
def test_a_finger_over_a_figure_scrolls_the_page(page: Page) -> None:
    tools = "arcless.plots.flatMap((one) => one.toolbar.tools)"
    drags = f"{tools}.filter((one) => /Zoom|Pan|Select/.test(one.type))"
    assert page.js(f"{drags}.length") > 0
    assert page.js(f"{drags}.filter((one) => one.active).length") == 0
    box, before, whole = page.box(first(page)), page.js("scrollY"), page.js("tried.range()")
    x, y = box["x"] + 100, box["y"] + box["height"] / 2
    touch(page, "touchStart", {"x": x, "y": y})
    for step in range(1, 11):
        touch(page, "touchMove", {"x": x, "y": y - 15 * step})
    touch(page, "touchEnd")
    # Of 150 px the browser takes some to tell a scroll from a tap.
    assert page.js("scrollY") - before > 100
    assert page.js("tried.range()") == whole


def touch(page: Page, kind: str, *points: dict[str, float]) -> None:
    page("send", "Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
