"""The socket of a session: what the page orders goes to its process, what that sends to the page.

A session lives as long as its socket: a page that is closed or reloaded leaves nothing behind.
"""

import asyncio
import json
from typing import Any

from anyio import CapacityLimiter
from anyio.to_thread import run_sync
from starlette.routing import BaseRoute, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from arcless.errors import ArclessError, ModelError
from arcless.studio.answers.answers import complaint
from arcless.studio.hands_on.worker import Begin, checked_rate, serve
from arcless.studio.processes.ends import Cancelled, Failed
from arcless.studio.processes.worker import Worker
from arcless.studio.project import texts
from arcless.studio.project.project import Project, is_shipped

# Sessions at once, each of which keeps a core busy. With more, none of them keeps its pace.
MOST_SESSIONS = 2
# Letters of an order; the longest that the page sends has a hundred.
LONGEST_ORDER = 4096
# Time in s that a process may take to end by itself.
LAST_STEP = 0.2


def routes(project: Project) -> list[BaseRoute]:
    """Return the route of sessions of a project's scenarios."""
    held: set[WebSocket] = set()

    async def session(socket: WebSocket) -> None:
        await socket.accept()
        if len(held) >= MOST_SESSIONS:
            await _refuse(socket, ModelError(
                "too many sessions at the same time", expected=f"at most {MOST_SESSIONS}",
                hint="end the one in the other window",
            ))  # fmt: skip
            return
        held.add(socket)
        try:
            begin = await run_sync(_begin, project, await _order(socket))
            await _hold(socket, begin)
        except (ArclessError, Failed) as error:
            await _refuse(socket, error)
        except (WebSocketDisconnect, Cancelled):
            pass
        finally:
            held.discard(socket)

    return [WebSocketRoute("/api/hands_on", session)]


async def _refuse(socket: WebSocket, error: ArclessError | Failed) -> None:
    await socket.send_json({"topic": "error", "error": complaint(error), "final": True})
    await socket.close()


def _begin(project: Project, order: dict[str, Any]) -> Begin:
    path = order.get("scenario")
    if order.get("topic") != "begin" or not isinstance(path, str):
        raise ModelError("first order of a session", expected="begin, with a scenario")
    text = texts.read(project, path)["text"]
    within = None if is_shipped(path) else project.folder
    return Begin(project.model_file(path), within, text, checked_rate(order.get("rate", 1.0)))


async def _order(socket: WebSocket) -> dict[str, Any]:
    """Return the next order, an object.

    Raises
    ------
    ModelError
        It is none.
    """
    text = await socket.receive_text()
    try:
        order = json.loads(text) if len(text) <= LONGEST_ORDER else None
    except (ValueError, RecursionError):
        order = None
    if not isinstance(order, dict):
        raise ModelError("order of a session", expected="a short JSON object")
    return order


async def _hold(socket: WebSocket, begin: Begin) -> None:
    loop, worker = asyncio.get_running_loop(), Worker()

    def heard(said: Any) -> None:
        # Waits until it is sent: a page that does not read slows the process, not the server.
        asyncio.run_coroutine_threadsafe(_send(socket, said), loop).result()

    serving = asyncio.wrap_future(worker.do(serve, begin, heard=heard))
    taking = asyncio.ensure_future(_take(socket, worker))
    try:
        await asyncio.wait({serving, taking}, return_when=asyncio.FIRST_COMPLETED)
        await (taking if taking.done() else serving)
    finally:
        serving.cancel()
        taking.cancel()
        worker.leave(LAST_STEP)


async def _take(socket: WebSocket, worker: Worker) -> None:
    # A thread of its own: a process that does not listen takes no other one's place.
    own = CapacityLimiter(1)
    while True:
        await run_sync(worker.tell, await _order(socket), limiter=own)


async def _send(socket: WebSocket, said: Any) -> None:
    if isinstance(said, dict):
        await socket.send_json(said)
        return
    for frame in said:
        await socket.send_bytes(frame)
