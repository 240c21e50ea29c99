"""Bodies of questions that come slowly, or not at all."""

import asyncio

import pytest
from starlette.types import Message

from arcless.studio.answers.answers import Refused
from arcless.studio.server import bodies


def test_the_rest_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bodies, "NEXT_PIECE_S", 0.01)
    pieces: list[Message] = [{"type": "http.request", "body": b"x", "more_body": True}]

    async def receive() -> Message:
        if pieces:
            return pieces.pop()
        await asyncio.Event().wait()
        raise AssertionError

    async def ask() -> None:
        slow = bodies.limited({"type": "http", "headers": []}, receive, 10)
        assert (await slow())["body"] == b"x"
        with pytest.raises(Refused) as refused:
            await slow()
        assert refused.value.status == 408

    asyncio.run(ask())


def test_after_the_whole_body_one_waits_as_long_as_it_takes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The end of the connection is waited for by answers that take long."""
    monkeypatch.setattr(bodies, "NEXT_PIECE_S", 0.01)
    pieces: list[Message] = [{"type": "http.disconnect"}, {"type": "http.request", "body": b"x"}]

    async def receive() -> Message:
        if len(pieces) == 1:
            await asyncio.sleep(0.05)
        return pieces.pop()

    async def ask() -> None:
        given = bodies.limited({"type": "http", "headers": []}, receive, 10)
        await given()
        assert (await given())["type"] == "http.disconnect"

    asyncio.run(ask())
