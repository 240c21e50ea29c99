"""The benchmark of the studio: what it counts, and that it finds its way through the page."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from benchmarks import studio_page
from benchmarks.studio_page import COUNTERS, EDITED, FIRST_DAY, LINES, SIDE, Bench, Measure

import arcless
from tests.browser.browser import Browser
from tests.studio.studio import Studio

# A canvas that is drawn three times in each frame.
DRAWN = """measured.pictures('canvas', 300, STATE, () => {
  const context = document.querySelector('canvas').getContext('2d');
  for (let n = 0; n < 3; n++) context.clearRect(0, 0, 10, 10);
}, 0)"""
STILL = f"measured.pictures('{SIDE}', 300, measured.shownTime, () => {{}}, 300)"


@pytest.fixture(scope="module")
def bench(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Bench]:
    """Return a browser and a server on a folder with a run and a line."""
    folder = tmp_path_factory.mktemp("bench")
    place = folder / "runs" / FIRST_DAY
    place.mkdir(parents=True)
    arcless.run(arcless.load(FIRST_DAY).with_(**{"output.motion": True})).save(place / "result.nc")
    shutil.copy(LINES / f"{EDITED[0][0]}.yaml", folder)
    with Studio(browser, folder) as server:
        yield Bench(browser, server)


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have all measured as shortly as a number is found."""
    monkeypatch.setattr(studio_page, "COUNTED", 300)
    monkeypatch.setattr(studio_page, "KEYS", 1)
    monkeypatch.setattr(studio_page, "REPEATS", 1)
    monkeypatch.setattr(studio_page, "EDITED", EDITED[:1])


def reached(line: list[str]) -> float:
    return float(line[2].split()[0])


def test_a_picture_counts_once_and_only_if_it_is_another_one(
    tmp_path: Path, browser: Browser
) -> None:
    file = tmp_path / "page.html"
    file.write_text("<!doctype html><title>x</title><canvas width=10 height=10></canvas>", "utf-8")
    name = browser.new(file.as_uri(), before=COUNTERS, ready="canvas")
    frames, same, other = (
        browser.ask(name, "evaluate", DRAWN.replace("STATE", state))["all"]
        for state in ("(n) => n", "() => 1", "(n) => Math.floor(n / 4)")
    )
    browser.ask(name, "close")
    assert same == 1
    assert 1 < other < frames
    # A screen has 60 frames a second, and one at either end.
    assert frames <= 20


def test_pictures_of_a_run_that_plays_and_of_one_that_stands(bench: Bench) -> None:
    with studio_page.played(bench, FIRST_DAY) as page:
        assert page.js(STILL)["rate"] == 0
        assert reached(bench.pictures(page, "side view", 50, SIDE)) > 0


@pytest.mark.parametrize(
    "measure", [studio_page.first_paint, studio_page.keystroke, studio_page.statics]
)
def test_times_are_found(bench: Bench, measure: Measure) -> None:
    (line,) = measure(bench)
    assert reached(line) > 0
