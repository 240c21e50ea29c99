"""Secrets that decide who may ask: tokens in addresses, and the cookie that stands for one of them.

The printed address has a token that holds as long as the server: who reads the terminal is the
user, who may have two browsers or empty one of its cookies. What the browser is started with is
another one, which every user of the machine can read in the list of processes: it is good for one
use within a minute. Both are exchanged for the same cookie.
"""

import secrets
import time

# Bytes of a secret: 256 bits, beyond guessing.
_BYTES = 32
# Time in s within which a started browser asks. Shorter, a slow one finds the door shut; longer,
# others of this machine have more time to be faster.
TICKET_S = 60.0


class Keys:
    """Secrets of one server.

    Attributes
    ----------
    port
        Port of the server: cookies do not tell ports apart, so that the cookie's name does.
    token
        Token of the printed address.
    """

    def __init__(self, port: int) -> None:
        self.port = port
        self.token = secrets.token_urlsafe(_BYTES)
        self._session = secrets.token_urlsafe(_BYTES)
        self._tickets: dict[str, float] = {}

    @property
    def cookie(self) -> str:
        """Name of the cookie."""
        return f"arcless-studio-{self.port}"

    def ticket(self) -> str:
        """Return a new token for one use."""
        made = secrets.token_urlsafe(_BYTES)
        self._tickets[made] = time.monotonic() + TICKET_S
        return made

    def session_for(self, token: str) -> str | None:
        """Return the value of the cookie for a token; None for one that opens nothing."""
        if _same(token, self.token):
            return self._session
        for ticket in list(self._tickets):
            if _same(token, ticket):
                return self._session if time.monotonic() < self._tickets.pop(ticket) else None
        return None

    def admits(self, session: str | None) -> bool:
        """Return whether this is the value of the cookie."""
        return session is not None and _same(session, self._session)


def _same(given: str, secret: str) -> bool:
    return secrets.compare_digest(given.encode("utf-8", "replace"), secret.encode())
