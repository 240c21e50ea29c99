"""The hub: messages for all pages, from any thread."""

import asyncio
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager, suppress
from typing import Any

from arcless.studio.stream.outbox import Outbox

# Messages of which the newest counts, by topic: the part of it that tells one from another.
_NEWEST = {"beat": None, "project": None, "file": "path", "job": "id", "study": "path"}
# Time in s between two signs of life. A page that has heard nothing for three of them says that the
# server does not answer. Longer, and it says so late; shorter, and an idle machine has more to do.
BEAT_S = 2.0


class Hub:
    """Pages that listen, and messages to all of them."""

    def __init__(self) -> None:
        self._pages: set[Outbox] = set()
        self._loop: asyncio.AbstractEventLoop | None = None

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Be there while the server is."""
        self._loop = asyncio.get_running_loop()
        beating = asyncio.create_task(self._beat())
        try:
            yield
        finally:
            self._loop = None
            beating.cancel()

    def tell(self, message: dict[str, Any]) -> None:
        """Tell all pages a message ``{topic, …}``; callable from any thread.

        Before the server has started and after its end nobody hears it.
        """
        loop = self._loop
        if loop is not None:
            with suppress(RuntimeError):  # it has just been closed
                loop.call_soon_threadsafe(self._tell, message)

    @contextmanager
    def listening(self, page: Outbox) -> Iterator[None]:
        """Have a page hear what is told."""
        self._pages.add(page)
        try:
            yield
        finally:
            self._pages.discard(page)

    async def _beat(self) -> None:
        """Tell pages that the server is there: a stopped one tells nothing, and closes nothing."""
        while True:
            await asyncio.sleep(BEAT_S)
            self._tell({"topic": "beat"})

    def _tell(self, message: dict[str, Any]) -> None:
        topic = message.get("topic")
        key = (topic, _told_apart(message)) if topic in _NEWEST else None
        for page in self._pages:
            page.tell(message, key)


def _told_apart(message: dict[str, Any]) -> object:
    part = _NEWEST[message["topic"]]
    held = message.get("job", message) if part == "id" else message
    return None if part is None else held.get(part)
