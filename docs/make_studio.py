"""Take the pictures of the guide to the studio: `python docs/make_studio.py`.

A folder with a line and two runs is made in a temporary place, served, and looked at by Chromium.
Beside the pictures `words.json` keeps the names of tabs, buttons, fields and headings that each one
shows. `tests/studio/test_pictures.py` opens the same views and compares: a word that changed is
noticed without pictures that differ in each pixel of a new version.
"""

import base64
import json
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT))

from tests.browser import tools  # noqa: E402
from tests.browser.browser import Browser  # noqa: E402
from tests.browser.kinds import arcless  # noqa: E402
from tests.studio.studio import SMALL, Studio, Window  # noqa: E402

FOLDER = ROOT / "docs" / "images" / "studio"
WORDS = FOLDER / "words.json"
# Sum of all pictures in bytes: a clone of the repository has them all.
MOST = 300_000
# Of WebP: below 35, thin lines of the drawing are smeared.
QUALITY = 42
SHOWN = """[...document.querySelectorAll(
  "[role=tab], button:not(.name, .verdict-of), summary, main label, th, main h2, main h3"
)].filter((one) => one.checkVisibility()).map((one) => one.innerText.trim().split("\\n")[0])
.filter((text) => /^[A-Za-z]/.test(text) && !/\\d/.test(text))"""


def start(page: Window) -> None:
    """Show the first screen of an empty folder."""
    page.wait(".start .example")


def edit(page: Window) -> None:
    """Open the line; its drawing stands beside its fields."""
    page.click('nav >> text="my-line-line"')
    page.until("!!document.querySelector('.line-view.side canvas')?.getAttribute('aria-label')")
    page.wait(".form input")


def watch(page: Window) -> None:
    """Show a run in the player, somewhere in the middle."""
    page.click(".run-entry .name >> nth=0")
    page.wait(".verdict-of .numbers")
    page.wait(".strips")
    page.until("!document.querySelector('.motion-tools')?.innerText.includes('no recorded')")
    page.click("text=Next worst place")


def run(page: Window) -> None:
    """Show results of a run."""
    page.click(".run-entry .name >> nth=0")
    page.wait(".verdict-of .numbers")
    page.click("role=tab[name=Results]")
    page.wait("main >> role=region[name=Verdict]")


def compare(page: Window) -> None:
    """Tick both runs."""
    for place in range(2):
        page("check", f".run-entry input >> nth={place}")
    page.click("role=tab[name=Compare]")
    page.wait("main table")


def why(page: Window) -> None:
    """Ask why σ is high."""
    page.click(".run-entry .name >> nth=0")
    page.click('role=tab[name="Why σ"]')
    page.wait("main table", patience=60_000)


def statics(page: Window) -> None:
    """Show the line at rest with its sliders."""
    edit(page)
    page.click("role=tab[name=Statics]")
    page.wait("main input[type=range]")
    page.wait("main table")


VIEWS: dict[str, Callable[[Window], None]] = {
    "edit": edit, "watch": watch, "run": run, "why": why, "compare": compare, "statics": statics,
}  # fmt: skip


def prepare(folder: Path) -> None:
    """Make a line and two runs of it."""
    folder.mkdir()
    arcless("new", "my-line", "--from", "en50318-ac-simple-320-planar", "--to", folder)
    for more in ([], ["--set", "speed=300 km/h"]):
        name = "my-line" + "-300" * bool(more)
        arcless("run", folder / "my-line.yaml", *more, "--out", folder / "runs" / name,
                "--set", "output.motion=true", "--certainty", "--no-report", "--quiet")  # fmt: skip


@contextmanager
def looked_at(view: Callable[[Window], None], server: Studio) -> Iterator[Window]:
    """Open a view, moved by nothing any more."""
    with server.open(SMALL, reducedMotion="reduce") as page:
        view(page)
        page("waitForLoadState", "networkidle")
        yield page


def every(browser: Browser, folder: Path) -> Iterator[tuple[str, Window]]:
    """Return each view, opened."""
    (folder / "empty").mkdir(parents=True)
    with Studio(browser, folder / "empty") as server, looked_at(start, server) as page:
        yield "start", page
    prepare(folder / "railway")
    with Studio(browser, folder / "railway") as server:
        for name, view in VIEWS.items():
            with looked_at(view, server) as page:
                yield name, page


def words(page: Window) -> list[str]:
    """Return the words of a view that its picture shows, sorted."""
    return sorted(set(page.js(SHOWN)))


def main() -> None:
    """Take all pictures."""
    if sentence := tools.missing():
        sys.exit(f"make: {sentence}")
    FOLDER.mkdir(parents=True, exist_ok=True)
    shown = {}
    browser = Browser()
    with TemporaryDirectory() as folder:
        for name, page in every(browser, Path(folder)):
            shown[name] = words(page)
            taken = page("send", "Page.captureScreenshot", {"format": "webp", "quality": QUALITY})
            (FOLDER / f"{name}.webp").write_bytes(base64.b64decode(taken["data"]))
    browser.close()
    WORDS.write_text(json.dumps(shown, indent=1, ensure_ascii=False) + "\n", "utf-8")
    size = sum(file.stat().st_size for file in FOLDER.glob("*.webp"))
    print(f"{len(shown)} pictures, {size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
