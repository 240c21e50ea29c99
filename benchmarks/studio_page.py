"""The page of the studio in Chromium without a GPU: pictures drawn in a second, and times in ms.

A picture counts where a view cleared its canvas and shows another time, or another range, than in
the frame before (studio_counters.js); frames in which the page drew nothing new do not.
"""

import json
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import median
from typing import Any

from benchmarks.clock import REPEATS
from benchmarks.watched_runs import LONG
from tests.browser.browser import Browser
from tests.studio.studio import Studio, Window
from tests.support.long_run import write as write_long

import arcless

COUNTERS = Path(__file__).with_name("studio_counters.js").read_text("utf-8")
MODELS = Path(arcless.__file__).parent / "models"
# That of the first screen, in the plane, and a line in space with stagger and steady arms.
FIRST_DAY, IN_SPACE = "en50318-ac-simple-320-planar", "en50318-ac-simple-320"
SIDE, SPACE = ".line-view.side canvas", ".space canvas"
# Each is counted for so many ms: shorter, one pause of the machine decides; longer, the replay ends.
COUNTED_MS = 5000
KEYS = 20
# Natural frequencies come last, when a slider rests.
RESTS = "document.querySelector('.statics > .numbers').innerText.includes('Hz')"
# In ms, for what takes seconds on a machine that does much else.
PATIENCE = 60_000


class Row(list[str]):
    """A line of the table: what, the limit, what was reached, whether that meets it, and more."""

    def __init__(self, what: str, limit: str, reached: float, met: bool, unit: str, more: str = "") -> None:
        text = f"{reached:.3g}" if abs(reached) < 100.0 else f"{reached:.0f}"
        super().__init__([what, limit, f"{text} {unit}".strip(), "yes" if met else "**no**", more])


def most(what: str, limit: float, reached: float, unit: str, more: str = "") -> Row:
    """Return the row of a number that must not be above its limit."""
    return Row(what, f"≤ {limit:g} {unit}".strip(), reached, reached <= limit, unit, more)


def least(what: str, limit: float, reached: float, unit: str, more: str = "") -> Row:
    """Return the row of a number that must not be below its limit."""
    return Row(what, f"≥ {limit:g} {unit}".strip(), reached, reached >= limit, unit, more)


def prepare(folder: Path) -> Path:
    """Make a folder with runs whose motion is recorded, a run of a million samples, and lines."""
    for name in (FIRST_DAY, IN_SPACE):
        place = folder / "runs" / name
        place.mkdir(parents=True)
        arcless.run(arcless.load(name).with_(**{"output.motion": True})).save(place / "result.nc")
    write_long(folder)
    for name in ("ac-simple-55", "ac-simple-55-3d"):
        shutil.copy(MODELS / "lines" / f"{name}.yaml", folder)
    for file in LONG:
        shutil.copy(file, folder)
    return folder


@contextmanager
def window(server: Studio, **more: Any) -> Iterator[Window]:
    """Return a window of 1400 × 900 whose pictures are counted."""
    page = server.open(before=COUNTERS, **more)
    yield page
    # Drawing in software tells, whenever a picture is read, that it took a while.
    page.close(allowed="ReadPixels")


def first_paint(server: Studio) -> Row:
    """Measure the first paint of a page that nothing is kept of, by a server that is up."""
    found = []
    for _ in range(REPEATS):
        with window(server) as page:
            page.until("performance.getEntriesByName('first-contentful-paint').length")
            page.wait(".run-entry")
            found.append(page.js(
                "[performance.getEntriesByName('first-contentful-paint')[0].startTime,"
                " performance.now()]"
            ))  # fmt: skip
    paints, lists = zip(*found, strict=True)
    more = f"largest of {REPEATS}: {max(paints):.0f} ms; the runs of the folder are listed after {median(lists):.0f} ms"
    return most("first paint", 500, median(paints), "ms", more)


def keystroke(server: Studio) -> list[Row]:
    """Measure from a key in the text of a line of 20 spans to the picture of the new line."""
    rows = []
    for name, title in (("ac-simple-55", "planar"), ("ac-simple-55-3d", "in space")):
        with window(server) as page:
            edit(page, name)
            page.click('.faces >> role=button[name="YAML"]')
            page.click(".yaml .cm-content")
            page.press("Control+Home", "Control+f")
            page.type("encumbrance: {value: 1.2")
            page.press("Enter", "Escape", "ArrowRight")
            # The first one has processes started, and is no typing.
            found = [_key(page, "Backspace" if n % 2 else "5") for n in range(KEYS + 2)][2:]
        times = sorted(one["all"] for one in found)
        answers = median(one["answer"] for one in found)
        more = f"largest of {KEYS}: {times[-1]:.0f} ms; of the median the answer is {answers:.0f} ms"
        rows.append(most(f"key in the text → line drawn, 20 spans {title}", 100, median(times), "ms", more))
    return rows


def _key(page: Window, key: str) -> dict[str, float]:
    page.js(f"void (window.following = measured.follows({json.dumps(SIDE)}))")
    page.press(key)
    found: dict[str, float] = page.js("window.following")
    page.js("new Promise((on) => setTimeout(on, 500))")  # the line in full resolution follows
    return found


def edit(page: Window, name: str) -> None:
    """Open a line and wait for its drawing."""
    page.click(f'nav >> text="{name}" >> nth=0')
    page.until(f"/20 spans/.test(document.querySelector('{SIDE}')?.getAttribute('aria-label') ?? '')")


def statics(server: Studio) -> list[Row]:
    """Count how often a second other numbers are seen while a slider moves."""
    rows = []
    for name, title in (("ac-simple-55", "planar"), ("ac-simple-55-3d", "in space")):
        with window(server) as page:
            edit(page, name)
            page.click("role=tab[name=Statics]")
            slider = "#slider-contact_wire\\\\.tension"
            page.wait("main input[type=range]")
            page.wait(".statics table")
            page.until(RESTS, PATIENCE)
            found = page.js(f"measured.slide('{slider}', {COUNTED_MS})")
            page.until(RESTS, PATIENCE)
            full = page.js(f"measured.full('contact_wire.tension', 'kN', 22, {COUNTED_MS})")
        coarse = f"{100 * found['coarse']:.0f} % of them on coarse elements"
        more = f"{coarse}; the server alone, in full resolution: {full:.1f} a second"
        rows.append(least(f"statics while a slider moves, 20 spans {title}", 10, found["rate"], "a second", more))
    return rows


def replay(server: Studio) -> list[Row]:
    """Count pictures of the player: side view and 3-D, a stored run, and beside one that steps."""
    rows = []
    for name, title in ((FIRST_DAY, "planar"), (IN_SPACE, "in space")):
        with window(server) as page:
            play(page, name)
            rows.append(pictures(page, SIDE, f"side view, replay {title}", 50))
    with window(server) as page:
        play(page, IN_SPACE)
        page.click('role=tab[name="3-D"]')
        page.wait(SPACE)
        rows.append(pictures(page, SPACE, "3-D, replay", 25))
    with window(server) as page:
        play(page, IN_SPACE)
        page.click('role=tab[name="3-D"]')
        page.wait(SPACE)
        with stepping(page):
            rows.append(pictures(page, SPACE, "3-D, replay beside a run that steps", 15))
    with window(server) as page:
        page("selectOption", ".run-bar .scenario select", LONG[0].name)
        page.click(".run-bar button.run")
        page.wait(".transport .live", patience=PATIENCE)
        page.click('role=tab[name="3-D"]')
        page.wait(SPACE)
        rows.append(pictures(page, SPACE, "3-D of the run that steps, at its newest time", 15))
        page.click("role=tab[name=Line]")
        rows.append(pictures(page, SIDE, "side view of the run that steps", 50))
        page.click(".running >> text=Cancel")
        page.wait(".running", "hidden", PATIENCE)
    return rows


def play(page: Window, run: str) -> None:
    """Open a run and wait for its first picture."""
    page.click(f'.run-entry:has(input[aria-label="Overlay runs/{run}"]) .name')
    page.wait(".transport")
    page.until("measured.shownTime() !== undefined")
    page.until("/\\d m ·/.test(document.querySelector('.transport .where').textContent)")


def pictures(page: Window, view: str, what: str, limit: float) -> Row:
    """Count the pictures of a view while it plays."""
    page.js("measured.goOn()")
    found = page.js(f"measured.pictures({json.dumps(view)}, {COUNTED_MS}, measured.shownTime)")
    more = f"longest between two: {found['longest']:.0f} ms"
    return least(f"{what}: pictures", limit, found["rate"], "a second", more)


@contextmanager
def stepping(page: Window) -> Iterator[None]:
    """Have a run of 50 km step, without a window that follows it."""
    order = {"scenario": LONG[0].name, "changes": {}, "record_motion": False, "keep_both": True}
    given = {"method": "POST", "body": json.dumps(order), "headers": {"Content-Type": "application/json"}}
    page.js(f"fetch('api/runs', {json.dumps(given)}).then((one) => one.json())")
    page.until("/^0*[1-9]/.test(document.querySelector('.running .numbers')?.innerText ?? '')", PATIENCE)
    yield
    page.click(".running >> text=Cancel")
    page.wait(".running", "hidden", PATIENCE)


def charts(server: Studio) -> list[Row]:
    """Count pictures of a figure of a million samples while it is zoomed and moved."""
    chart = 'figure.chart[data-measured]'
    with window(server) as page:
        page("check", 'input[aria-label="Overlay runs/long"]')
        page.click("role=tab[name=Results]")
        page.wait('figure.chart h4:text-is("Contact force")', "attached", PATIENCE)
        page.js(
            "(() => { const found = [...document.querySelectorAll('figure.chart')].find((one) =>"
            " one.querySelector('h4').textContent === 'Contact force');"
            " found.dataset.measured = ''; found.scrollIntoView(); })()"
        )
        page.wait(f"{chart} canvas", patience=PATIENCE)
        rows = []
        for kind, title in (("zoom", "zoomed in and out"), ("move", "moved")):
            found = page.js(
                f"measured.pictures('{chart} canvas', {COUNTED_MS}, undefined,"
                f" measured.gesture('{chart}', '{kind}'))"
            )
            more = f"longest between two: {found['longest']:.0f} ms"
            rows.append(least(f"force of 10⁶ samples {title}: pictures", 50, found["rate"], "a second", more))
    return rows
