"""The page of the studio in Chromium without a GPU: pictures drawn in a second, and times in ms.

A picture counts where a view cleared its canvas and shows another time, or another range, than in
the frame before (studio_counters.js). Playwright is told of each message of the stream, which costs
the browser more than it costs that of a user.
"""

import json
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from tests.browser.browser import Browser
from tests.studio.studio import Studio, Window
from tests.support.long_run import write as write_samples

import arcless
from benchmarks.clock import REPEATS
from benchmarks.limits import least, most
from benchmarks.processes import processor
from benchmarks.watched_runs import LONG

COUNTERS = Path(__file__).with_name("studio_counters.js").read_text("utf-8")
LINES = Path(arcless.__file__).parent / "models" / "lines"
# The scenario of the first screen, in the plane; and one in space, with stagger and steady arms.
FIRST_DAY, IN_SPACE = "en50318-ac-simple-320-planar", "en50318-ac-simple-320"
# Their lines: 20 spans of 55 m.
EDITED = (("ac-simple-55", "planar"), ("ac-simple-55-3d", "in space"))
SIDE, SPACE = ".line-view.side canvas", ".space canvas"
# ms for which pictures and answers are counted. Shorter, one pause of the machine decides; longer,
# the replay of 11 s ends.
COUNTED = 5000
KEYS = 20
# ms for what takes seconds on a machine that does much else.
PATIENCE = 60_000
# After a key, ms: the line in full resolution is asked for when keys rest, and then saved.
REST = 700
# Natural frequencies come last, when a slider rests.
RESTS = "document.querySelector('.statics > .numbers').innerText.includes('Hz')"
Lines = Iterator[list[str]]
Measure = Callable[["Bench"], Lines]


@dataclass(frozen=True)
class Bench:
    """A browser, and a server on a folder that `prepare` made."""

    browser: Browser
    server: Studio

    @contextmanager
    def window(self) -> Iterator[Window]:
        """Return a window of 1400 × 900 in which pictures are counted."""
        page = self.server.open(before=COUNTERS)
        yield page
        # Drawing in software tells, whenever a picture is read, that it took a while.
        page.close(allowed="ReadPixels")

    def pictures(
        self, page: Window, what: str, limit: float, canvas: str, act: str = "undefined"
    ) -> list[str]:
        """Count pictures of a canvas: of a run that plays, or of a figure while `act` is done."""
        state = "measured.shownTime" if act == "undefined" else "undefined"
        if act == "undefined":
            page.js("measured.play()")
        before = processor(self.browser.processes)
        found = page.js(f"measured.pictures({json.dumps(canvas)}, {COUNTED}, {state}, {act})")
        each = (processor(self.browser.processes) - before) / max(found["all"], 1)
        more = f"{1e3 * each:.0f} ms of the processor each; {found['longest']:.0f} ms the longest"
        return least(what, limit, found["rate"], "pictures/s", f"{more} between two")


def prepare(folder: Path) -> Path:
    """Make a folder with runs whose motion is recorded, a run of a million samples, and lines."""
    for name in (FIRST_DAY, IN_SPACE):
        place = folder / "runs" / name
        place.mkdir(parents=True)
        arcless.run(arcless.load(name).with_(**{"output.motion": True})).save(place / "result.nc")
    write_samples(folder)
    for file in (*(LINES / f"{name}.yaml" for name, _ in EDITED), *LONG):
        shutil.copy(file, folder)
    return folder


def first_paint(bench: Bench) -> Lines:
    """Measure the first paint of a page that nothing is kept of, by a server that is up."""
    paint = "performance.getEntriesByName('first-contentful-paint')"
    found = []
    for _ in range(REPEATS):
        with bench.window() as page:
            page.until(f"{paint}.length")
            page.wait(".run-entry")
            found.append(page.js(f"[{paint}[0].startTime, performance.now()]"))
    paints, lists = zip(*found, strict=True)
    more = f"{max(paints):.0f} ms the longest of {REPEATS}; the folder is listed after"
    yield most("first paint", 500, median(paints), "ms", f"{more} {median(lists):.0f} ms")


def keystroke(bench: Bench) -> Lines:
    """Measure from a key in the text of a line to the picture of the new line."""
    for name, title in EDITED:
        with bench.window() as page:
            edit(page, name)
            page.click('.faces >> role=button[name="YAML"]')
            page.click(".yaml .cm-content")
            page.press("Control+Home", "Control+f")
            page.type("encumbrance: {value: 1.2")
            page.press("Enter", "Escape", "ArrowRight")
            # The first two have processes started, and are no typing.
            found = [_key(page, "Backspace" if n % 2 else "5") for n in range(KEYS + 2)][2:]
        times, answers = ([one[of] for one in found] for of in ("all", "answer"))
        more = f"{max(times):.0f} ms the longest of {KEYS}; the server takes"
        what = f"key in the text to line drawn, 20 spans {title}"
        yield most(what, 100, median(times), "ms", f"{more} {median(answers):.0f} ms")


def _key(page: Window, key: str) -> dict[str, float]:
    page.js(f"void (window.following = measured.follows({json.dumps(SIDE)}))")
    page.press(key)
    found: dict[str, float] = page.js("window.following")
    page.js(f"new Promise((on) => setTimeout(on, {REST}))")
    return found


def edit(page: Window, name: str) -> None:
    """Open a line and wait for its drawing."""
    page.click(f'nav >> text="{name}" >> nth=0')
    label = f"document.querySelector('{SIDE}')?.getAttribute('aria-label') ?? ''"
    page.until(f"/20 spans/.test({label})")


def statics(bench: Bench) -> Lines:
    """Count how often a second other numbers are seen while a slider moves."""
    for name, title in EDITED:
        with bench.window() as page:
            edit(page, name)
            page.click("role=tab[name=Statics]")
            page.wait("main input[type=range]")
            page.wait(".statics table")
            page.until(RESTS, PATIENCE)
            slider = json.dumps("#slider-contact_wire\\.tension")
            found = page.js(f"measured.slide({slider}, {COUNTED})")
            page.until(RESTS, PATIENCE)
            full = page.js(f"measured.full('contact_wire.tension', 'kN', 22, {COUNTED})")
        coarse = f"{100 * found['coarse']:.0f} % of them on coarse elements"
        more = f"{coarse}; without drawing, on fine elements: {full:.1f} answers/s"
        what = f"statics while a slider moves, 20 spans {title}"
        yield least(what, 10, found["rate"], "answers/s", more)


def replay(bench: Bench) -> Lines:
    """Count pictures of stored runs: side view and 3-D, alone and beside a run that steps."""
    for run, title in ((FIRST_DAY, "planar"), (IN_SPACE, "in space")):
        with played(bench, run) as page:
            yield bench.pictures(page, f"side view, replay {title}", 50, SIDE)
    with played(bench, IN_SPACE) as page:
        space(page)
        yield bench.pictures(page, "3-D, replay", 25, SPACE)
    with played(bench, IN_SPACE) as page:
        space(page)
        order = {"scenario": LONG[0].name, "changes": {}, "record_motion": False}
        given = {
            "method": "POST", "body": json.dumps(order | {"keep_both": True}),
            "headers": {"Content-Type": "application/json"},
        }  # fmt: skip
        page.js(f"fetch('api/runs', {json.dumps(given)}).then((one) => one.json())")
        page.wait(".running >> text=stepping", patience=PATIENCE)
        yield bench.pictures(page, "3-D, replay during a run", 15, SPACE)
        cancel(page)


@contextmanager
def played(bench: Bench, run: str) -> Iterator[Window]:
    """Return a window in which a run is open, drawn from the side."""
    with bench.window() as page:
        page.click(f".run-entry .name[title^='runs/{run}']")
        page.until("/\\d m ·/.test(document.querySelector('.transport .where')?.textContent ?? '')")
        yield page


def space(page: Window) -> None:
    """Show the line in space."""
    page.click('role=tab[name="3-D"]')
    page.wait(SPACE)


def cancel(page: Window) -> None:
    """Cancel the run that steps."""
    page.click(".running >> text=Cancel")
    page.wait(".running", "hidden", PATIENCE)


def live(bench: Bench) -> Lines:
    """Count pictures of a run of 50 km while it steps, at its newest time."""
    with bench.window() as page:
        page("selectOption", ".run-bar .scenario select", LONG[0].name)
        page.click(".run-bar button.run")
        page.wait(".transport .live", patience=PATIENCE)
        yield bench.pictures(page, "side view of a run that steps, 50 km", 50, SIDE)
        space(page)
        yield bench.pictures(page, "3-D of a run that steps, 50 km", 15, SPACE)
        cancel(page)


def charts(bench: Bench) -> Lines:
    """Count pictures of a figure of a million samples while it is zoomed and moved."""
    chart, title = "figure.chart[data-measured]", "Contact force"
    with bench.window() as page:
        page("check", ".run-entry:has(.name[title^='runs/long']) input")
        page.click("role=tab[name=Results]")
        page.wait(f'figure.chart h4:text-is("{title}")', "attached", PATIENCE)
        page.js(f"measured.mark('{title}')")
        page.wait(f"{chart} canvas", patience=PATIENCE)
        for kind, done in (("zoom", "zoomed in and out"), ("move", "moved to and fro")):
            act = f"measured.gesture('{chart}', '{kind}')"
            what = f"force of 10⁶ samples, {done}"
            yield bench.pictures(page, what, 50, f"{chart} canvas", act)


MEASURES: tuple[Measure, ...] = (
    first_paint, keystroke, statics, replay, live, charts,
)  # fmt: skip
