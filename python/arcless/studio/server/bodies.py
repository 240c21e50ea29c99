"""Bodies of questions: how long they may be, and how long one waits for the rest of them."""

import asyncio

from starlette.types import Message, Receive, Scope

from arcless.studio.answers.answers import Refused

# Bytes of a question: a text of the reader's longest, 5 MB, hardly more than a tenth of it.
LONGEST = 4 * 2**20
# Time in s for the next piece of a body. Shorter, a browser that was stopped is refused; longer, a
# slow sender is waited for.
NEXT_PIECE_S = 20.0
_TOO_LONG = 413
_TOO_SLOW = 408


def limited(scope: Scope, receive: Receive, longest: int) -> Receive:
    """Return what gives the body of a question, and refuses one that is too long or too slow.

    Parameters
    ----------
    scope
        The question.
    receive
        What gives its body.
    longest
        Most bytes of it.
    """
    if scope["type"] != "http":
        return receive
    taken, whole = 0, False

    async def next_piece() -> Message:
        nonlocal taken, whole
        if whole:  # from here on it waits for the end of the connection
            return await receive()
        if _announced(scope) > longest:
            raise Refused(_TOO_LONG, _too_long(longest))
        try:
            message = await asyncio.wait_for(receive(), NEXT_PIECE_S)
        except TimeoutError:
            raise Refused(_TOO_SLOW, "The rest of the question did not come") from None
        taken += len(message.get("body", b""))
        whole = not message.get("more_body", False)
        if taken > longest:
            raise Refused(_TOO_LONG, _too_long(longest))
        return message

    return next_piece


def _announced(scope: Scope) -> int:
    """Return the length that the head of a question announces; 0 where it does not."""
    given = dict(scope["headers"]).get(b"content-length", b"0")
    return int(given) if given.isdigit() else 0


def _too_long(longest: int) -> str:
    return f"The question is too long: {longest / 2**20:g} MiB at most"
