"""Connections: how many there may be, and how long one may stay that has not shown the cookie.

A client that has the cookie is the user, and is never limited. All others on this machine can only
open connections, slowly send a head or a body, and be refused; they take turns in a fixed number of
places, so that none is left for the user only if he is one of them.
"""

import asyncio
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from uvicorn.protocols.http.h11_impl import H11Protocol

Client = tuple[str, int]
# Time in s for a connection to show the cookie. Shorter, a browser that opens some ahead has to
# open them again; longer, slow strangers hold their places.
PROVE_S = 10.0
# Strangers at once; of more, the oldest one goes. Fewer, and the user's own first questions may be
# among those; more, and they take memory, 64 KiB each for a head, and open files, 1024 in all.
MOST_STRANGERS = 64


class Crowd:
    """Connections of strangers."""

    def __init__(self) -> None:
        self._strangers: dict[Client, tuple[asyncio.Transport, asyncio.TimerHandle]] = {}

    def __len__(self) -> int:
        return len(self._strangers)

    def enter(self, client: Client, transport: asyncio.Transport) -> None:
        """Take in a new connection; send the oldest stranger away if there are too many."""
        if len(self._strangers) >= MOST_STRANGERS:
            self._send_away(next(iter(self._strangers)))
        timer = asyncio.get_running_loop().call_later(PROVE_S, self._send_away, client)
        self._strangers[client] = (transport, timer)

    def leave(self, client: Client) -> None:
        """Forget a connection: it is closed, or it has shown the cookie."""
        _, timer = self._strangers.pop(client, (None, None))
        if timer is not None:
            timer.cancel()

    def _send_away(self, client: Client) -> None:
        transport, _ = self._strangers.get(client, (None, None))
        self.leave(client)
        if transport is not None:
            transport.abort()  # an orderly end would wait for who does not read


def protocol(crowd: Crowd) -> "type[H11Protocol]":
    """Return uvicorn's HTTP with its connections in a crowd."""
    from uvicorn.protocols.http.h11_impl import H11Protocol

    class Crowded(H11Protocol):
        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            super().connection_made(transport)
            if self.client is not None:
                crowd.enter(self.client, transport)

        def connection_lost(self, exc: Exception | None) -> None:
            super().connection_lost(exc)
            if self.client is not None:
                crowd.leave(self.client)

    return Crowded


def client_of(scope: Any) -> Client | None:
    """Return the other end of the connection of a request."""
    client = scope.get("client")
    return None if client is None else (str(client[0]), int(client[1]))
