"""Connections that have not shown the cookie: a fixed number of them, for some seconds."""

import asyncio
from typing import cast

import pytest

from arcless.studio.server import crowd as crowd_module
from arcless.studio.server.crowd import MOST_STRANGERS, Crowd


class Line:
    """The transport of a connection: it knows whether it was cut."""

    def __init__(self) -> None:
        self.is_cut = False

    def abort(self) -> None:
        self.is_cut = True


def enter(crowd: Crowd, number: int) -> Line:
    line = Line()
    crowd.enter(("127.0.0.1", number), cast(asyncio.Transport, line))
    return line


def test_the_oldest_stranger_makes_room() -> None:
    async def come() -> None:
        crowd = Crowd()
        lines = [enter(crowd, number) for number in range(MOST_STRANGERS)]
        assert not any(line.is_cut for line in lines)
        lines += [enter(crowd, MOST_STRANGERS + number) for number in range(3)]
        assert [line.is_cut for line in lines[:4]] == [True, True, True, False]
        assert not any(line.is_cut for line in lines[3:])
        assert len(crowd) == MOST_STRANGERS

    asyncio.run(come())


def test_who_shows_the_cookie_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crowd_module, "PROVE_S", 0.02)

    async def come() -> None:
        crowd = Crowd()
        user, stranger = enter(crowd, 1), enter(crowd, 2)
        crowd.leave(("127.0.0.1", 1))
        for number in range(3, 3 + MOST_STRANGERS):
            enter(crowd, number)
        await asyncio.sleep(0.1)
        assert not user.is_cut
        assert stranger.is_cut
        assert len(crowd) == 0

    asyncio.run(come())
