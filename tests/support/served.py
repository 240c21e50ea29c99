"""Routes on a port of this machine, and a client of their WebSocket."""

import json
import socket
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import asynccontextmanager, contextmanager
from typing import Any

import uvicorn
from starlette.applications import Starlette
from starlette.routing import BaseRoute
from websockets.sync.client import ClientConnection, connect

# Time in s in which anything is there, on a busy machine too.
PATIENCE_S = 30.0


@contextmanager
def served(routes: Sequence[BaseRoute], at_work: Sequence[Any] = ()) -> Iterator[int]:
    """Serve routes in a thread; gives the port."""

    @asynccontextmanager
    async def over(_: Any) -> Any:
        for one in at_work:
            await one.__aenter__()
        yield
        for one in reversed(at_work):
            await one.__aexit__(None, None, None)

    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.bind(("127.0.0.1", 0))
    app = Starlette(routes=list(routes), lifespan=over)
    settings = uvicorn.Config(
        app, log_config=None, ws="websockets-sansio", ws_per_message_deflate=False,
        timeout_graceful_shutdown=0,
    )  # fmt: skip
    server = uvicorn.Server(settings)
    thread = threading.Thread(target=server.run, args=([listener],))
    thread.start()
    try:
        deadline = time.monotonic() + PATIENCE_S
        while not server.started and time.monotonic() < deadline:
            time.sleep(0.01)
        assert server.started
        yield listener.getsockname()[1]
    finally:
        server.should_exit = True
        thread.join(PATIENCE_S)
        assert not thread.is_alive()


@contextmanager
def page(port: int) -> Iterator["Page"]:
    """Open the stream as a page does."""
    with connect(f"ws://127.0.0.1:{port}/api/stream", max_size=None, compression=None) as line:
        yield Page(line)


class Page:
    """A page: frames by the name of their channel, and messages."""

    def __init__(self, line: ClientConnection) -> None:
        self.line = line
        self.names: dict[int, str] = {}
        self.frames: list[tuple[str, bytes]] = []

    def tell(self, topic: str, **message: Any) -> None:
        self.line.send(json.dumps({"topic": topic, **message}))

    def hear(self, *topics: str) -> dict[str, Any]:
        """Return the next message of one of some topics; frames before it are kept."""
        while True:
            given = self.line.recv(timeout=PATIENCE_S)
            if isinstance(given, bytes):
                self.frames.append((self.names[int.from_bytes(given[:4], "little")], given))
                continue
            message: dict[str, Any] = json.loads(given)
            if message["topic"] == "channels":
                self.names |= {one["number"]: one["name"] for one in message["channels"]}
            if message["topic"] in topics:
                return message

    def play(self, source: dict[str, str]) -> dict[str, Any]:
        self.tell("play", source=source)
        message = self.hear("channels", "error")
        assert message["topic"] == "channels", message
        return message

    def want(self, source: dict[str, str], from_s: float, to_s: float, every_s: float) -> Any:
        """Ask for moments, and wait until they are sent."""
        self.frames.clear()
        self.tell("want", source=source, from_s=from_s, to_s=to_s, every_s=every_s, ask=1)
        return self.hear("sent")
