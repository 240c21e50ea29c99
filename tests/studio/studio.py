"""The studio as tests use it: a server on a folder, and windows of a browser on it."""

import base64
import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self

from tests.browser.browser import Browser, Tab, window
from tests.support import processes

# Time in ms for what a test waits for. Shorter, a busy machine fails tests that are right; longer,
# those that are wrong take the longer to say so.
PATIENCE = 20_000
DESK = {"width": 1400, "height": 900}
SMALL = {"width": 1280, "height": 720}
PHONE = {"width": 390, "height": 844}
# What a browser says by itself where the server is gone, or another one refuses its cookie.
GONE = (
    "ERR_CONNECTION", "ERR_SOCKET_NOT_CONNECTED", "ERR_EMPTY_RESPONSE", "ERR_INCOMPLETE",
    "WebSocket connection to", "403",
)  # fmt: skip


class Studio:
    """`arcless studio FOLDER`, ended with the block.

    Attributes
    ----------
    folder
        The folder of the project.
    address
        The address that it printed, with its token.
    """

    def __init__(
        self, browser: Browser, folder: Path, port: int = 0, page: Path | None = None
    ) -> None:
        self._browser, self.folder = browser, folder
        own = ["arcless"] if page is None else ["tests.support.studio_server", str(page)]
        self._program = [sys.executable, "-m", *own]
        self._tabs: list[Window] = []
        self.start(port)

    def start(self, port: int = 0) -> None:
        """Start the server."""
        words = ["studio", str(self.folder), "--no-browser", "--port", str(port)]
        self._process = subprocess.Popen(
            [*self._program, *words],
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
        )
        assert self._process.stdout is not None
        self.address = self._process.stdout.readline().strip()
        assert self.address.startswith("http://"), "the studio printed no address"

    @property
    def process(self) -> int:
        """Number of the server's process."""
        return self._process.pid

    @property
    def port(self) -> int:
        """Port that the server listens on."""
        return int(self.address.split(":")[2].split("/")[0])

    def signal(self, number: signal.Signals) -> None:
        """Send the server a signal."""
        self._process.send_signal(number)
        if number is signal.SIGKILL:
            self._process.wait()

    @property
    def workers(self) -> list[int]:
        """Numbers of the processes that the server has started."""
        return processes.below(self._process.pid)

    @contextmanager
    def stopped(self, *, with_all: bool) -> Iterator[None]:
        """Have the server stopped for a time; `with_all`: with its workers and the browser."""
        all_ = [self._process.pid]
        if with_all:
            all_ += [*self.workers, *self._browser.processes]
        for process in all_:
            os.kill(process, signal.SIGSTOP)
        try:
            yield
        finally:
            for process in all_:
                os.kill(process, signal.SIGCONT)

    def open(
        self,
        size: Mapping[str, int] = DESK,
        *,
        dark: bool = False,
        beside: "Window | None" = None,
        **more: Any,
    ) -> "Window":
        """Open the studio in a new window, or in a tab that shares the cookies of another one."""
        options = {**window(size, dark=dark), "ready": "main", **more}
        if beside is not None:
            options["beside"] = beside.number
        found = Window(self._browser, self._browser.new(self.address, **options))
        self._tabs.append(found)
        return found

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        try:
            events = [event for tab in self._tabs for event in tab.close()]
        finally:
            self._process.terminate()
            try:
                self._process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                self._process.kill()
                raise
        if kind is None:
            assert not events, f"the page complained: {events}"


class Window(Tab):
    """A window of the studio. Selectors are Playwright's: CSS, `text=Run`, `role=button`.

    Besides these methods, `window("METHOD", …)` calls any method of Playwright's page.
    """

    def __init__(self, browser: Browser, number: int) -> None:
        super().__init__(browser, number)
        self.number = number
        self._complaints: list[str] | None = None

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self, allowed: str | None = None) -> list[str]:
        """Close it; return what it complained of since it was last asked for its events.

        Complaints that hold the text `allowed` do not count.
        """
        if self._complaints is None:
            said = self.events
            self._complaints = [one for one in said if allowed is None or allowed not in one]
            self("close")
        return self._complaints

    def click(self, selector: str) -> None:
        """Click once it can be clicked."""
        self("click", selector, {"timeout": PATIENCE})

    def part(self, title: str) -> None:
        """Show a part of the window, where it is one of a phone, which shows one at a time."""
        if self.js("getComputedStyle(document.querySelector('nav.parts')).display !== 'none'"):
            self.click(f'nav.parts >> text="{title}"')

    def type(self, text: str, into: str | None = None) -> None:
        """Type where the focus is, or instead of what is in a field."""
        if into is None:
            self("keyboard.type", text)
        else:
            self("fill", into, text, {"timeout": PATIENCE})

    def press(self, *keys: str) -> None:
        """Press keys one after the other, `Control+Enter` at once."""
        for key in keys:
            self("keyboard.press", key)

    def wait(self, selector: str, state: str = "visible", patience: int = PATIENCE) -> None:
        """Wait until an element is there, or until it is `hidden`; patience in ms."""
        self("waitForSelector", selector, {"state": state, "timeout": patience})

    def until(self, expression: str, patience: int = PATIENCE) -> None:
        """Wait until an expression in the page is true; patience in ms."""
        # Playwright's own function would be evaluated by the page, whose policy forbids it.
        found = self.js(
            f"""(async () => {{
              for (const end = performance.now() + {patience}; performance.now() < end;) {{
                if ({expression}) return true;
                await new Promise((on) => setTimeout(on, 30));
              }}
              return false;
            }})()"""
        )
        assert found, f"not true after {patience} ms: {expression}"

    def text(self, selector: str) -> str:
        """Return the text of an element as it is seen."""
        return str(self("innerText", selector, {"timeout": PATIENCE}))

    def count(self, selector: str) -> int:
        """Return how many elements there are, by a CSS selector."""
        return int(self.js(f"document.querySelectorAll({json.dumps(selector)}).length"))

    def js(self, expression: str) -> Any:
        """Return the value of an expression in the page."""
        return self("evaluate", expression)

    def upload(self, name: str, content: bytes, selector: str = "input[type=file]") -> None:
        """Give a file to a field for files."""
        held = base64.b64encode(content).decode()
        self("setInputFiles", selector, {"name": name, "mimeType": "text/csv", "buffer": held})

    def picture(self, file: Path) -> None:
        """Write what is seen as a picture."""
        file.write_bytes(base64.b64decode(self("screenshot")))

    def server_is_gone(self) -> None:
        """Take back what the browser said because the server was gone; nothing else was said."""
        others = [event for event in self.events if not any(one in event for one in GONE)]
        assert not others, f"the page complained: {others}"
