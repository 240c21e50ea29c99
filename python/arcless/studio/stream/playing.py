"""A source as it is played by one page: its numbers, its edge, what of it is wanted."""

import asyncio
import itertools
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

from anyio.to_thread import run_sync

from arcless.errors import ArclessError
from arcless.studio.motion.channels import Moment, MotionSource
from arcless.studio.stream.outbox import Outbox
from arcless.studio.stream.sources import Name, announced

# Time in s between two words of the edge of a growing motion.
_EDGE_S = 0.1
# Time in s for which a page that has no room is waited for, once; then moments are dropped until
# there is room. Shorter, a page that draws a frame loses moments; longer, an answer is late.
_PATIENCE_S = 0.25
# Moments that are read at once, in a thread.
_AT_ONCE = 8


class Playing:
    """A source that a page plays."""

    def __init__(self, name: Name, source: MotionSource, first: int, outbox: Outbox) -> None:
        self.name, self.source = name, source
        self.numbers = range(first, first + len(source.channels))
        self._outbox = outbox
        self._plain = dict([name])
        self._streaming: asyncio.Task[None] | None = None
        self._of: object = object()
        outbox.tell({"topic": "channels", "source": self._plain, **announced(source, self.numbers)})
        self._following = asyncio.create_task(self._follow())

    def want(self, from_s: float, to_s: float, every_s: float, ask: Any) -> None:
        """Send moments between two times in s; what was wanted before is not any more."""
        self._stop()
        self._of = object()
        self._streaming = asyncio.create_task(self._stream(self._of, (from_s, to_s, every_s), ask))

    def close(self) -> None:
        """Send nothing more."""
        self._stop()
        self._following.cancel()

    def _stop(self) -> None:
        if self._streaming is not None:
            self._streaming.cancel()
            self._outbox.forget(self._of)

    async def _follow(self) -> None:
        """Tell how far a growing motion is."""
        told: tuple[float, bool] | None = None
        while True:
            now = self.source.end_s, self.source.final
            if now != told:
                told = now
                edge = {"topic": "edge", "source": self._plain, "end_s": now[0], "final": now[1]}
                self._outbox.tell(edge, ("edge", self.name))
            if now[1]:
                return
            await asyncio.sleep(_EDGE_S)

    async def _stream(self, of: object, wanted: tuple[float, float, float], ask: Any) -> None:
        from_s, to_s, every_s = wanted
        end_s = min(to_s, self.source.end_s)
        sent = dropped = 0
        patient = True
        try:
            moments = self.source.moments(from_s, end_s, every_s)
            while batch := await run_sync(_next, moments):
                for moment in batch:
                    frames = [piece.frame(self.numbers[piece.channel]) for piece in moment]
                    fits = self._outbox.offer(frames, of)
                    if not fits and patient:
                        await self._outbox.room(_PATIENCE_S)
                        fits = self._outbox.offer(frames, of)
                    patient = fits
                    sent, dropped = sent + fits, dropped + (not fits)
        except (ArclessError, OSError, ValueError) as error:
            self._outbox.tell({
                "topic": "error", "source": self._plain, "text": str(error), "about": "want",
            })  # fmt: skip
            return
        self._outbox.tell_behind({
            "topic": "sent", "source": self._plain, "ask": ask, "from_s": from_s, "to_s": end_s,
            "frames": sent, "dropped": dropped,
        }, of)  # fmt: skip


def _next(moments: Iterator[Moment]) -> list[Moment]:
    with suppress(StopIteration):
        return list(itertools.islice(moments, _AT_ONCE))
    return []
