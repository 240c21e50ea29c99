"""A source as it is played by one page: its numbers, its edge, what of it is wanted."""

import asyncio
import itertools
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

from anyio.to_thread import run_sync

from arcless.errors import ArclessError
from arcless.studio.motion.channels import Moment, MotionSource
from arcless.studio.stream.outbox import Outbox
from arcless.studio.stream.sources import Name, announced

# Time in s between two words of the edge of a growing motion.
_EDGE_S = 0.1
# Time in s between two looks whether a motion that is whole was replaced by one that has more.
_REPLACED_S = 0.5
# Time in s for which a page that has no room is waited for, once; then moments are dropped until
# there is room. Shorter, a page that draws a frame loses moments; longer, an answer is late.
_PATIENCE_S = 0.25
# Moments that are read at once, in a thread.
_AT_ONCE = 8


class Playing:
    """A source that a page plays.

    Parameters
    ----------
    name, source
        The source.
    numbers
        Gives so many numbers for channels that no other channel of the page has.
    outbox
        What is sent to the page.
    """

    def __init__(
        self, name: Name, source: MotionSource, numbers: Callable[[int], range], outbox: Outbox
    ) -> None:
        self._name, self._outbox, self._numbers_for = name, outbox, numbers
        self._plain = dict([name])
        self._streaming: asyncio.Task[None] | None = None
        self._of: object = object()
        self._take(source, again=False)
        self._following = asyncio.create_task(self._follow())

    def _take(self, source: MotionSource, *, again: bool) -> None:
        """Play a source from now on, under new numbers."""
        self._source = source
        self._numbers = self._numbers_for(len(source.channels))
        about = announced(source, self._numbers, again=again)
        self._outbox.tell({"topic": "channels", "source": self._plain, **about})

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
            if self._source.later is not None:
                self._stop()
                self._take(self._source.later, again=True)
            now = self._source.end_s, self._source.final
            if now != told:
                told = now
                edge = {"topic": "edge", "source": self._plain, "end_s": now[0], "final": now[1]}
                self._outbox.tell(edge, ("edge", self._name))
            await asyncio.sleep(_REPLACED_S if now[1] else _EDGE_S)

    async def _stream(self, of: object, wanted: tuple[float, float, float], ask: Any) -> None:
        from_s, to_s, every_s = wanted
        end_s = min(to_s, self._source.end_s)
        sent = dropped = 0
        patient = True
        try:
            moments = self._source.moments(from_s, end_s, every_s)
            while batch := await run_sync(_next, moments):
                for moment in batch:
                    frames = [piece.frame(self._numbers[piece.channel]) for piece in moment]
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
