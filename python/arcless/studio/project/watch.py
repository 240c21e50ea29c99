"""Changes of the folder, by any program, told to the page."""

import threading
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from typing import Any

from anyio.to_thread import run_sync

from arcless.errors import ArclessError
from arcless.studio.project.models import ENDINGS
from arcless.studio.project.opening import read_bytes
from arcless.studio.project.texts import version_of
from arcless.studio.project.view import View

# Time in s between looks. Longer, and a change outside is seen late; shorter, and looking costs: a
# folder with 500 models and 300 runs takes some milliseconds.
EVERY_S = 0.5
Tell = Callable[[dict[str, Any]], None]


class Watch:
    """A thread that looks at the folder twice a second.

    Parameters
    ----------
    view
        The view of the project.
    tell
        Told ``{topic: "project"}``, and ``{topic: "file", path, version}`` of each changed model
        file, version None where it is gone; called from the thread.
    """

    def __init__(self, view: View, tell: Tell) -> None:
        self._view, self._tell = view, tell
        self._ended = threading.Event()

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Watch while the server is there."""
        await run_sync(self._view.tree.look)
        thread = threading.Thread(target=self._watch, name="watch", daemon=True)
        thread.start()
        try:
            yield
        finally:
            self._ended.set()

    def look(self) -> None:
        """Look once, and tell what changed; afterwards read the models."""
        changed = self._view.tree.look()
        for path in sorted(changed):
            if path.suffix.lower() in ENDINGS:
                self._tell({"topic": "file", "path": self._view.project.name_of(path),
                            "version": self._version(path)})  # fmt: skip
        if changed:
            self._tell({"topic": "project"})
            self._read_models()

    def _read_models(self) -> None:
        if self._view.models.check(self._view.tree.files):
            self._tell({"topic": "project"})

    def _watch(self) -> None:
        with suppress(OSError, ArclessError):
            self._view.read()  # the page asks in a moment
            self._read_models()
        while not self._ended.is_set():
            with suppress(OSError, ArclessError):  # what cannot be read now is looked at again
                self.look()
            self._ended.wait(EVERY_S)

    def _version(self, path: Any) -> str | None:
        try:
            return version_of(read_bytes(self._view.project, path, str(path)))
        except (ArclessError, OSError):
            return None
