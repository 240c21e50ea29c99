"""The WebSocket of the stream: what a page asks, and what it is sent."""

import asyncio
import json
from collections.abc import Awaitable, Callable
from typing import Any

from starlette.routing import BaseRoute, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from arcless.errors import ArclessError
from arcless.studio.answers.answers import Refused
from arcless.studio.motion.channels import MotionSource
from arcless.studio.stream.hub import Hub
from arcless.studio.stream.outbox import Outbox
from arcless.studio.stream.playing import Playing
from arcless.studio.stream.sources import Name, name_of

# Sources that one page plays at once; it shows one, and a second while it changes over.
MOST_SOURCES = 8
# Time in s beyond any run; larger numbers, and those that are none, are no times.
_LONGEST = 1e9
Open = Callable[[Name], Awaitable[MotionSource]]
Compute = Callable[[Name], str]


def routes(hub: Hub, open_source: Open, compute: Compute) -> list[BaseRoute]:
    """Return the route of the stream.

    Parameters
    ----------
    hub
        What tells all pages.
    open_source
        Opens the motion of a source.
    compute
        Begins to compute the motion of a run; returns the name of the job.
    """

    async def stream(socket: WebSocket) -> None:
        await socket.accept()
        await Session(socket, hub, open_source, compute).hold()

    return [WebSocketRoute("/api/stream", stream)]


class Session:
    """One page, from the opening of its socket to the end of it."""

    def __init__(self, socket: WebSocket, hub: Hub, open_source: Open, compute: Compute) -> None:
        self._socket, self._hub = socket, hub
        self._open, self._compute = open_source, compute
        self._outbox = Outbox()
        self._playing: dict[Name, Playing] = {}
        self._opening: dict[Name, asyncio.Task[None]] = {}
        self._next = 1

    async def hold(self) -> None:
        """Answer until the socket is closed."""
        sending = asyncio.create_task(self._send())
        try:
            with self._hub.listening(self._outbox):
                await self._listen()
        finally:
            sending.cancel()
            for task in self._opening.values():
                task.cancel()
            for one in self._playing.values():
                one.close()

    async def _send(self) -> None:
        try:
            while True:
                for part in await self._outbox.next():
                    if isinstance(part, str):
                        await self._socket.send_text(part)
                    else:
                        await self._socket.send_bytes(part)
        except (WebSocketDisconnect, RuntimeError, OSError):
            return  # the socket is closed, which `_listen` is told

    async def _listen(self) -> None:
        while True:
            given = await self._socket.receive()
            if given["type"] == "websocket.disconnect":
                return
            topic = ""
            try:
                message = _message(given)
                topic = message["topic"]
                self._answer(topic, message)
            except (ArclessError, Refused) as error:
                self._complain(topic, str(error))

    def _answer(self, topic: str, message: dict[str, Any]) -> None:
        name = name_of(message.get("source"))
        match topic:
            case "play":
                self._play(name)
            case "want":
                self._want(name, message)
            case "leave":
                self._leave(name)
            case "compute motion":
                job = self._compute(name)
                self._outbox.tell({"topic": "computing", "source": dict([name]), "job": job})
            case _:
                raise Refused(400, "a topic that the server does not know")

    def _play(self, name: Name) -> None:
        self._leave(name)
        if len(self._playing) + len(self._opening) >= MOST_SOURCES:
            raise Refused(400, f"{MOST_SOURCES} sources are played already")
        self._opening[name] = asyncio.create_task(self._opened(name))

    async def _opened(self, name: Name) -> None:
        try:
            source = await self._open(name)
        except (ArclessError, Refused) as error:
            self._complain("play", str(error), name)
        else:
            self._playing[name] = Playing(name, source, self._numbers, self._outbox)
        finally:
            if self._opening.get(name) is asyncio.current_task():
                del self._opening[name]

    def _numbers(self, count: int) -> range:
        self._next += count
        return range(self._next - count, self._next)

    def _want(self, name: Name, message: dict[str, Any]) -> None:
        playing = self._playing.get(name)
        if playing is None:
            raise Refused(400, "this source is not played")
        times = [message.get(key) for key in ("from_s", "to_s", "every_s")]
        if not all(_is_number(one) for one in times) or not _is_short(message.get("ask")):
            raise Refused(400, "from_s, to_s and every_s of a want are times in s")
        from_s, to_s, every_s = (float(one) for one in times if one is not None)
        playing.want(from_s, to_s, max(every_s, 0.0), message.get("ask"))

    def _leave(self, name: Name) -> None:
        opening = self._opening.pop(name, None)
        if opening is not None:
            opening.cancel()
        playing = self._playing.pop(name, None)
        if playing is not None:
            playing.close()

    def _complain(self, topic: str, text: str, name: Name | None = None) -> None:
        about = topic if _is_short(topic) else None
        message = {"topic": "error", "text": text, "about": about}
        # A page that sends nonsense and reads nothing must not fill the memory.
        key = ("error", about, None if name is None else name[0])
        self._outbox.tell(message if name is None else message | {"source": dict([name])}, key)


def _message(given: Any) -> dict[str, Any]:
    """Return a message of the page.

    Raises
    ------
    Refused
        It is none.
    """
    try:
        message = json.loads(given.get("text") or "")
    except (ValueError, RecursionError):
        message = None
    if not isinstance(message, dict) or not isinstance(message.get("topic"), str):
        raise Refused(400, "a message is a JSON object with a topic")
    return message


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < _LONGEST


def _is_short(value: object) -> bool:
    """Return whether a value is repeated to the page: a word or a number of its own."""
    return value is None or (isinstance(value, str | int | float) and len(str(value)) <= 64)  # noqa: PLR2004 - as long as a name
