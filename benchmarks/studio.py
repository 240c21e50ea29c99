"""The studio beside its limits: its page in Chromium, and what watching costs a run.

    make bench PARTS=studio                  some four minutes
    make bench PARTS="studio studio-long"    and a run of 50 km to its end; some four more

The page is that of `make page`, in a window of 1400 × 900 of Debian's Chromium without a GPU.
"""

import os
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from page.build import BUILT
from tests.browser import tools
from tests.browser.browser import Browser
from tests.studio.studio import Studio, Window

import arcless
from benchmarks.limits import HEAD, most, told
from benchmarks.processes import resident
from benchmarks.studio_page import FIRST_DAY, MEASURES, PATIENCE, Bench, prepare
from benchmarks.watched_runs import LONG, WAYS, Took, ratios, rounds

__all__ = ["HEAD", "long_rows", "rows"]

MEGABYTE = 1e6
RUNS = 300
# Spans of 5 km of the line of 50 km, and rounds of runs in each way.
SHORT_SPANS, SHORT_ROUNDS, LONG_ROUNDS = 92, 5, 2
# Time of a run beside that of the run alone, at most.
SLOWED = 1.1
CLOCKS = {
    "thread": "processor time of the thread that steps",
    "process": "processor time of all threads",
    "steps": "wall time of the steps",
}
# Between two looks at what the page keeps, s: each collects garbage first.
LOOK_S = 2.0
Say = Callable[[str], None]


def rows(say: Say) -> Iterator[list[str]]:
    """Measure the page, and what watching costs a run of 5 km."""
    with chromium(say) as browser, TemporaryDirectory() as place:
        if browser is None:
            return
        yield busy()
        say("studio: making runs")
        folder = prepare(Path(place) / "railway")
        with Studio(browser, folder) as server:
            for measure in MEASURES:
                say(f"studio: {measure.__name__.replace('_', ' ')}")
                yield from measure(Bench(browser, server))
        say(f"studio: a folder of {RUNS} runs")
        result = folder / "runs" / FIRST_DAY / "result.nc"
        yield from many_runs(browser, Path(place) / "many", result)
    say("studio: runs of 5 km, watched and recorded")
    yield from slowed("5 km", rounds(SHORT_SPANS, SHORT_ROUNDS))


def long_rows(say: Say) -> Iterator[list[str]]:
    """Measure what watching costs a run of 50 km, and what page and server keep of it."""
    with chromium(say) as browser, TemporaryDirectory() as place:
        if browser is None:
            return
        yield busy()
        say("studio: runs of 50 km, watched and recorded")
        alone = rounds(None, LONG_ROUNDS)
        yield from slowed("50 km", alone)
        say("studio: a run of 50 km watched in the page to its end")
        recorded = min(one["recorded"].steps for one in alone)
        yield from to_the_end(browser, Path(place), recorded)


def busy() -> list[str]:
    """Return how busy the machine is before anything is measured: rates are of a quiet one."""
    what = "programs that wanted to run before, on average"
    return told(what, os.getloadavg()[0], f"for {os.cpu_count()} cores")


@contextmanager
def chromium(say: Say) -> Iterator[Browser | None]:
    """Return the browser, or None where it or what drives it is missing."""
    sentence = tools.missing() or (
        "" if (BUILT / "index.html").is_file() else "no page: `make page`"
    )
    if sentence:
        say(f"studio: left out: {sentence}")
        yield None
        return
    browser = Browser()
    try:
        yield browser
    finally:
        browser.close()


def many_runs(browser: Browser, folder: Path, result: Path) -> Iterator[list[str]]:
    """Measure until the runs of a large folder are listed, by a server that does not know them."""
    for number in range(RUNS):
        place = folder / "runs" / f"run-{number:03}"
        place.mkdir(parents=True)
        # The same bytes under many names: reading each costs what reading another run would.
        os.link(result, place / "result.nc")
    with Studio(browser, folder) as server:
        for first in (True, False):
            with Bench(browser, server).window() as page:
                page.until(f"document.querySelectorAll('.run-entry').length === {RUNS}", PATIENCE)
                taken = page.js("performance.now()") / 1e3
            who = "by a server that has just started" if first else "by a server that knows them"
            yield told(f"{RUNS} runs are listed in a page that is opened, {who}", taken, "s")


def slowed(title: str, found: Sequence[dict[str, Took]]) -> Iterator[list[str]]:
    """Return the lines of runs that are watched, and of runs whose motion is recorded."""
    for way in WAYS[1:]:
        for of, clock in CLOCKS.items():
            ratio, low, high = ratios(found, way, of)
            alone = min(getattr(one["alone"], of) for one in found)
            more = f"{low:.2f} to {high:.2f} in {len(found)} rounds; alone {alone:.3g} s"
            yield most(f"run of {title}, {way}: {clock}", SLOWED, ratio, "× alone", more)


def to_the_end(browser: Browser, folder: Path, recorded: float) -> Iterator[list[str]]:
    """Watch a run of 50 km to its end, its motion recorded as the page does unless told otherwise.

    `recorded` is the wall time in s of the steps of such a run that nobody watches.
    """
    for file in LONG:
        (folder / file.name).write_text(file.read_text("utf-8"), "utf-8")
    with Studio(browser, folder) as server, Bench(browser, server).window() as page:
        page.click(".run-bar button.run")
        page.wait(".transport .live", patience=PATIENCE)
        looks = [(kept(page), resident(server.process))]
        while page.count(".running"):
            time.sleep(LOOK_S)
            looks.append((kept(page), resident(server.process)))
        page.wait(".run-entry", patience=PATIENCE)
        (file,) = folder.glob("runs/*/result.nc")
        steps = arcless.open(file).metadata["wall_time_s"]
    pages, servers = ([size / MEGABYTE for size in sizes] for sizes in zip(*looks, strict=True))
    title = "50 km watched in the page to the end"
    more = f"{pages[0]:.0f} MB at first, {pages[-1]:.0f} MB at the end, {len(looks)} looks"
    yield most(f"{title}: heap of the page", 500, max(pages), "MB", more)
    more = f"{servers[0]:.0f} MB at first; without the process of the run"
    yield told(f"{title}: memory of the server", max(servers), "MB", more)
    what = f"{title}: wall time of the steps, compared with recorded alone"
    yield most(what, SLOWED, steps / recorded, "×", f"{steps:.1f} s")


def kept(page: Window) -> float:
    """Return what the script of a page keeps, in bytes: objects, and the arrays beside them."""
    page("send", "HeapProfiler.collectGarbage")
    found = page("send", "Runtime.getHeapUsage")
    return float(found["usedSize"] + found["backingStorageSize"])
