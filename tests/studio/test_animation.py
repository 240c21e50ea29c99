"""The animation of a report in a browser: by keys, light and dark, on a phone, on paper."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from page.build import BUILT, missing

import arcless
from arcless.figures.description.tokens import Scheme, colour
from arcless.studio.animation import animation
from arcless.studio.animation.animation import animation_of
from tests.browser.browser import Browser
from tests.support.small import small
from tests.support.waving import waving

READOUT = "document.querySelector('.animated output.where').textContent"
# Pixels of a canvas that have one colour, wholly covered.
PIXELS = """(([red, green, blue]) => {
  const canvas = document.querySelector('.animated canvas.side');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let n = 0; n < data.length; n += 4) {
    const [r, g, b, a] = data.subarray(n, n + 4);
    count += r === red && g === green && b === blue && a === 255;
  }
  return count;
})"""
# Resolved once the clock has gone on; the policy of the page allows no text that is run.
PLAYED = """new Promise((done) => {
  const readout = document.querySelector('.animated output.where');
  const time = () => parseFloat(readout.textContent.split('·').at(-1));
  const start = time();
  const look = () => (time() > start + 0.1 ? done(true) : requestAnimationFrame(look));
  look();
})"""


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a report with an animation of a known motion."""
    if reason := missing():
        pytest.skip(f"the page of the studio is not built: {reason}")
    assert (BUILT / "animation" / "animation.js").is_file(), "`make page` has not been run"

    def recorded(data: Any, geometry: Any) -> Any:
        times = np.asarray(data["line_time"].values)
        x = np.interp(times, data["time"].values, np.asarray(data["position"].values)[:, 0])
        return waving(geometry, times, x)

    file = tmp_path_factory.mktemp("animated") / "report.html"
    result = arcless.run(small())
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(animation, "recorded", recorded)
        result.write_report(file, animation=animation_of(result))
    return file


def seconds(page: Any) -> float:
    """Return the time in s that the readout tells."""
    return float(page.js(READOUT).split("·")[-1].removesuffix(" s"))


def wires(page: Any, scheme: Scheme) -> int:
    """Return how many pixels have the colour of the contact wire in a scheme."""
    channels = list(bytes.fromhex(colour("contact_wire", scheme).removeprefix("#")))
    return int(page.js(f"{PIXELS}({channels})"))


def test_keys_play_step_and_go_to_places(browser: Browser, report: Path) -> None:
    with browser.open(report) as page:
        page("focus", ".animated")
        start = seconds(page)
        page("keyboard.press", "ArrowRight")
        stepped = seconds(page)
        # A step is a row of the record, 5 ms; the readout has hundredths.
        assert start <= stepped <= start + 0.02
        page("keyboard.press", "Space")
        assert page("evaluate", PLAYED)
        page("keyboard.press", "Space")
        page("waitForSelector", ".animated button[aria-label=Play]")
        now = seconds(page)
        assert now > stepped
        page("keyboard.press", "Shift+ArrowLeft")
        assert seconds(page) < now
        assert page.events == []


@pytest.mark.parametrize("width", [1400, 390])
def test_it_fits_and_can_be_reached(browser: Browser, report: Path, width: int) -> None:
    with browser.open(report, width) as page:
        assert page.js("document.documentElement.scrollWidth") <= width
        # A wire of two pixels along a third of the window.
        assert wires(page, "light") > width / 3
        assert page.axe() == []


def test_dark_on_the_screen_is_light_on_paper(browser: Browser, report: Path) -> None:
    with browser.open(report, dark=True) as page:
        assert wires(page, "dark") > wires(page, "light") == 0
        page.do("dispatchEvent(new Event('beforeprint'))")
        assert wires(page, "light") > wires(page, "dark") == 0
        page.do("dispatchEvent(new Event('afterprint'))")
        assert page.js("document.documentElement.dataset.scheme ?? 'none'") == "none"
        assert wires(page, "dark") > wires(page, "light") == 0
