"""The studio beside its limits: its page in Chromium, and what watching costs a run.

    make bench PARTS=studio               the page, and a run of 5 km; some three minutes
    make bench PARTS="studio studio-long" and the line of 50 km; some five minutes more

Pages are those of `make page`, in Debian's Chromium without a GPU, in a window of 1400 × 900.
"""

import os
import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.studio_page import (
    FIRST_DAY,
    PATIENCE,
    Row,
    charts,
    first_paint,
    keystroke,
    most,
    prepare,
    replay,
    statics,
    window,
)
from benchmarks.watched_runs import LONG, Took, ratios, rounds
from tests.browser import tools
from tests.browser.browser import Browser
from tests.studio.studio import Studio, Window

import arcless

HEAD = ("what", "limit", "reached", "met", "and")
MEGABYTE = 1e6
RUNS = 300
# Spans of 5 km of the line of 50 km, and rounds of runs with and without a watcher.
SHORT_SPANS, SHORT_ROUNDS, LONG_ROUNDS = 92, 5, 2
SLOWER = 1.1
# Between two looks at what the page keeps, s: each collects garbage first, which takes its time.
LOOK_S = 2.0
Say = Callable[[str], None]


def rows(say: Say = lambda _text: None) -> Iterator[list[str]]:
    """Measure the page on short lines, and the cost of watching 5 km."""
    with chromium(say) as browser, TemporaryDirectory() as place:
        if browser is None:
            return
        say("a folder with runs")
        folder = prepare(Path(place) / "railway")
        with Studio(browser, folder) as server:
            for measure in (first_paint, keystroke, statics, replay, charts):
                say(measure.__name__.replace("_", " "))
                found = measure(server)
                yield from [found] if isinstance(found, Row) else found
        say(f"a folder of {RUNS} runs")
        yield from many_runs(browser, Path(place) / "many", folder)
    say("runs of 5 km, watched and recorded")
    yield from slowed("5 km", rounds(SHORT_SPANS, SHORT_ROUNDS))


def long_rows(say: Say = lambda _text: None) -> Iterator[list[str]]:
    """Measure the cost of watching 50 km, and what page and server keep of it."""
    say("runs of 50 km, watched and recorded")
    found = rounds(None, LONG_ROUNDS)
    yield from slowed("50 km", found)
    say("a run of 50 km watched in the page to its end")
    with chromium(say) as browser, TemporaryDirectory() as place:
        if browser is not None:
            yield from watched(browser, Path(place), found)


@contextmanager
def chromium(say: Say) -> Iterator[Browser | None]:
    """Return the browser, or None where it, Node or the page is missing."""
    if sentence := tools.missing():
        say(f"left out: {sentence}")
        yield None
        return
    browser = Browser()
    yield browser
    browser.close()


def many_runs(browser: Browser, folder: Path, of: Path) -> Iterator[Row]:
    """Measure until the runs of a large folder are listed, by a server that does not know them."""
    for number in range(RUNS):
        place = folder / "runs" / f"run-{number:03}"
        place.mkdir(parents=True)
        # The same bytes under many names: reading each costs what reading another one would.
        os.link(of / "runs" / FIRST_DAY / "result.nc", place / "result.nc")
    with Studio(browser, folder) as server:
        for what, limit in (("first", 10.0), ("second", 1.0)):
            with window(server) as page:
                page.until(f"document.querySelectorAll('.run-entry').length === {RUNS}", PATIENCE)
                taken = page.js("performance.now()") / 1000.0
            yield most(f"{RUNS} runs in the tree of a page, {what} time", limit, taken, "s")


def slowed(title: str, found: list[dict[str, Took]]) -> Iterator[Row]:
    """Return the rows of runs with and without a watcher."""
    for way, words in (("watched", "watched"), ("recorded", "motion recorded")):
        for of, clock in (("process", "processor time"), ("thread", "of the thread that steps"), ("steps", "wall time of the steps")):
            ratio, low, high = ratios(found, way, of)
            more = f"{low:.2f} to {high:.2f} in {len(found)} pairs; alone {found[0]['alone'].__getattribute__(of):.3g} s"
            yield most(f"run of {title}, {words}: {clock}", SLOWER, ratio, "× alone", more)


def watched(browser: Browser, folder: Path, alone: list[dict[str, Took]]) -> Iterator[Row]:
    """Watch a run of 50 km to its end, its motion recorded as the page does."""
    for file in LONG:
        (folder / file.name).write_text(file.read_text("utf-8"), "utf-8")
    with Studio(browser, folder) as server, window(server) as page:
        page.click(".run-bar button.run")
        page.wait(".transport .live", patience=PATIENCE)
        heaps, memory = [heap(page)], [resident(server.process)]
        while page.count(".running"):
            time.sleep(LOOK_S)
            heaps.append(heap(page))
            memory.append(resident(server.process))
        page.wait(".run-entry", patience=PATIENCE)
        (file,) = folder.glob("runs/*/result.nc")
        steps = arcless.open(file).metadata["wall_time_s"]
    more = f"{heaps[-1] / MEGABYTE:.0f} MB at its end, {len(heaps)} looks"
    yield most("50 km watched to the end: heap of the page, garbage collected", 500, max(heaps) / MEGABYTE, "MB", more)
    yield Row("memory of the server meanwhile", "", max(memory) / MEGABYTE, True, "MB", f"{memory[0] / MEGABYTE:.0f} MB at first; without worker processes")
    ratio = steps / min(one["recorded"].steps for one in alone)
    yield most("the same: wall time of the steps", SLOWER, ratio, "× not watched", f"{steps:.1f} s")


def heap(page: Window) -> float:
    """Return what the page's script keeps, in bytes: objects and the arrays beside them."""
    page("send", "HeapProfiler.collectGarbage")
    found = page("send", "Runtime.getHeapUsage")
    return float(found["usedSize"] + found.get("backingStorageSize", 0.0))


def resident(process: int) -> float:
    """Return the memory of a process in bytes."""
    status = Path(f"/proc/{process}/status").read_text("ascii")
    found = re.search(r"VmRSS:\s+(\d+) kB", status)
    assert found is not None
    return 1024.0 * int(found[1])
