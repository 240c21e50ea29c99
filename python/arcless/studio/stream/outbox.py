"""Frames and messages that wait to be sent to one page, in a bounded number of bytes."""

import asyncio
import json
from collections import OrderedDict, deque
from collections.abc import Sequence
from typing import Any

# Bytes of frames that wait. With less a page that is busy for a moment loses frames; with more one
# that is far behind gets what it no longer wants.
LARGEST = 4 << 20
# Messages that wait, of those that follow one another under other keys. A page that has lost more
# asks for everything again when it reconnects.
MOST_MESSAGES = 1000


class Outbox:
    """Frames and messages for one page: those that do not fit are not kept.

    Of messages with one key the newest alone is kept: the state of a job, the end of a motion.
    """

    def __init__(self, largest: int = LARGEST) -> None:
        self._largest, self.bytes = largest, 0
        self._moments: deque[tuple[object, Sequence[bytes | str]]] = deque()
        self._messages: OrderedDict[object, str] = OrderedDict()
        self._anything, self._room = asyncio.Event(), asyncio.Event()
        self._room.set()

    def tell(self, message: dict[str, Any], key: object = None) -> None:
        """Put a message behind those that wait; with a key in place of an older one of it."""
        known = object() if key is None else key
        self._messages[known] = json.dumps(message, allow_nan=False)
        if len(self._messages) > MOST_MESSAGES:
            self._messages.popitem(last=False)
        self._anything.set()

    def offer(self, frames: Sequence[bytes], of: object) -> bool:
        """Put the frames of a moment behind those that wait; return False where they do not fit.

        `of` is what they belong to, for `forget`.
        """
        size = sum(map(len, frames))
        if self._moments and self.bytes + size > self._largest:
            self._room.clear()
            return False
        self._moments.append((of, frames))
        self.bytes += size
        self._anything.set()
        return True

    def tell_behind(self, message: dict[str, Any], of: object) -> None:
        """Put a message behind the frames that wait: it tells of them."""
        self._moments.append((of, [json.dumps(message, allow_nan=False)]))
        self._anything.set()

    async def room(self, wait_s: float) -> None:
        """Wait until half of the frames are sent, no longer than a time in s."""
        try:
            await asyncio.wait_for(self._room.wait(), wait_s)
        except TimeoutError:
            return

    def forget(self, of: object) -> None:
        """Drop the frames of something: nobody wants them any more."""
        kept = [one for one in self._moments if one[0] is not of]
        self._moments = deque(kept)
        self.bytes = sum(len(frame) for _, frames in kept for frame in frames)
        self._check_room()

    async def next(self) -> Sequence[bytes | str]:
        """Return what is sent next, when there is something: messages go before frames."""
        while True:
            if self._messages:
                return [self._messages.popitem(last=False)[1]]
            if self._moments:
                _, frames = self._moments.popleft()
                self.bytes -= sum(map(len, frames))
                self._check_room()
                return frames
            self._anything.clear()
            await self._anything.wait()

    def _check_room(self) -> None:
        if self.bytes <= self._largest // 2:
            self._room.set()
