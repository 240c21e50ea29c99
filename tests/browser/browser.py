"""A browser and its pages, as tests use them."""

import itertools
import json
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Self

from tests.browser import tools
from tests.support.processes import below

HERE = Path(__file__).parent
AXE = tools.FOLDER / "node_modules" / "axe-core" / "axe.min.js"
# A sheet of A4 upright less its margins (page.css), at 96 pixels an inch.
PAPER = {"width": 703, "height": 1016}
SCREENS = {1400: 900, 1000: 800, 390: 844}


def rgb(colour: str) -> str:
    """Return a colour as a browser computes it."""
    return "rgb({}, {}, {})".format(*bytes.fromhex(colour.removeprefix("#")))


def window(size: Mapping[str, int], *, dark: bool = False) -> dict[str, Any]:
    """Return what Playwright is told of a window of a size in px; a narrow one is a phone."""
    phone = size["width"] < min(width for width in SCREENS if width > 390)
    return {
        "viewport": size,
        "colorScheme": "dark" if dark else "light",
        "hasTouch": phone,
        "isMobile": phone,
    }


class Browser:
    """One process of node with one browser; it ends with the session."""

    def __init__(self) -> None:
        place = tools.node()
        assert place is not None
        self._process = subprocess.Popen(
            [place / "bin" / "node", HERE / "driver.mjs", tools.FOLDER, str(tools.chromium())],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._names = itertools.count()

    def ask(self, name: int, call: str, *args: Any) -> Any:
        """Return the answer to a call; an error of the browser is one here."""
        assert self._process.stdin is not None and self._process.stdout is not None
        self._process.stdin.write(json.dumps({"name": name, "call": call, "args": args}) + "\n")
        self._process.stdin.flush()
        reply = json.loads(self._process.stdout.readline())
        if "error" in reply:
            raise AssertionError(f"{call}: {reply['error']}")
        return reply["value"]

    def open(self, file: Path, width: int = 1400, *, dark: bool = False) -> "Page":
        """Open a file in a window of this width in px; the narrowest one is a phone."""
        size = {"width": width, "height": SCREENS[width]}
        before = (HERE / "helpers.js").read_text("utf-8")
        options = {**window(size, dark=dark), "before": before, "ready": "html.drawn"}
        return Page(self, self.new(file.as_uri(), **options), size)

    def new(self, address: str, **options: Any) -> int:
        """Open an address by what `open` of the driver takes; return the number of its page."""
        name = next(self._names)
        self.ask(name, "open", {"address": address, **options})
        return name

    @property
    def processes(self) -> list[int]:
        """Numbers of the browser's processes, without node, which drives it."""
        return below(self._process.pid)

    def close(self) -> None:
        """End the browser, and node with it."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait(timeout=20)


class Tab:
    """An open page; calls have the names that Playwright gives them."""

    def __init__(self, browser: Browser, name: int) -> None:
        self._browser, self._name = browser, name

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self("close")

    def __call__(self, call: str, *args: Any) -> Any:
        return self._browser.ask(self._name, call, *args)

    @property
    def events(self) -> list[str]:
        """Complaints of the page, and requests for anything but itself, since the last question."""
        found: list[str] = self("events")
        return found

    def axe(self) -> list[str]:
        """Return what breaks rules of accessibility, and where."""
        self("evaluate", AXE.read_text("utf-8"))
        found = self(
            "evaluate",
            "axe.run(document, {runOnly: ['wcag2a', 'wcag2aa'], resultTypes: ['violations']})",
        )
        assert found["passes"]
        return [
            f"{one['id']}: {node['html'][:160]}: {node['failureSummary']}"
            for one in found["violations"]
            for node in one["nodes"]
        ]


class Page(Tab):
    """A page with figures."""

    def __init__(self, browser: Browser, name: int, size: Mapping[str, int]) -> None:
        super().__init__(browser, name)
        self._size, self._touched = size, True

    def __call__(self, call: str, *args: Any) -> Any:
        self._touched |= call != "evaluate"
        return super().__call__(call, *args)

    def reset(self) -> None:
        """Bring the page back to what it was when it was opened."""
        self("setViewportSize", self._size)
        self("emulateMedia", {"media": "screen", "colorScheme": "light"})
        self("mouse.move", 1, 1)
        self.do("tried.reset()")

    def js(self, expression: str) -> Any:
        """Return the value of an expression in the page, its figures drawn to the end."""
        wait = "tried.settled()" if self._touched else "Promise.resolve()"
        found = self("evaluate", f"{wait}.then(() => ({expression}))")
        self._touched = False
        return found

    def do(self, expression: str) -> None:
        """Let an expression change the page."""
        self("evaluate", f"tried.settled().then(() => void ({expression}))")
        self._touched = True

    def box(self, key: str) -> Mapping[str, float]:
        """Bring the frame of a figure into view; return where it is in the window, in px."""
        found: Mapping[str, float] = self.js(f"tried.frame({key!r})")
        return found

    def point(self, key: str, across: float, down: float) -> None:
        """Move the pointer to a place in the frame of a figure, given in parts of it."""
        box = self.box(key)
        self("mouse.move", box["x"] + across * box["width"], box["y"] + down * box["height"])

    def drag(self, key: str, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Drag from one place in the frame of a figure to another one."""
        self.point(key, *start)
        box = self.box(key)
        places = (
            (box["x"] + across * box["width"], box["y"] + down * box["height"])
            for across, down in (start, end)
        )
        self("drag", *places)
