"""The queue of a page is bounded: frames that do not fit are dropped, messages replaced."""

import asyncio
import json
from typing import Any

from arcless.studio.stream.outbox import MOST_MESSAGES, Outbox

FRAME = b"x" * 100


def taken(outbox: Outbox) -> list[Any]:
    """Take all that waits."""

    async def take() -> list[Any]:
        found: list[Any] = []
        while True:
            try:
                found += await asyncio.wait_for(outbox.next(), 0.01)
            except TimeoutError:
                return found

    return asyncio.run(take())


def test_frames_that_do_not_fit_are_dropped() -> None:
    outbox = Outbox(250)
    assert [outbox.offer([FRAME], "a") for _ in range(4)] == [True, True, False, False]
    assert outbox.bytes == 200
    assert taken(outbox) == [FRAME, FRAME]
    assert outbox.offer([FRAME], "a")


def test_a_moment_is_whole_or_absent() -> None:
    outbox = Outbox(250)
    assert outbox.offer([FRAME], "a")
    assert not outbox.offer([FRAME, FRAME], "a")
    assert outbox.bytes == 100


def test_a_moment_larger_than_all_is_sent_alone() -> None:
    assert Outbox(50).offer([FRAME], "a")


def test_room_comes_back_when_half_is_sent() -> None:
    async def act() -> list[bool]:
        outbox = Outbox(250)
        while outbox.offer([FRAME], "a"):
            pass
        waiting = asyncio.create_task(outbox.room(5.0))
        await asyncio.sleep(0)
        states = [waiting.done()]
        for _ in range(2):
            await outbox.next()
        await waiting
        return [*states, outbox.offer([FRAME], "a")]

    assert asyncio.run(act()) == [False, True]


def test_a_page_without_room_is_not_waited_for_long() -> None:
    async def act() -> None:
        outbox = Outbox(150)
        while outbox.offer([FRAME], "a"):
            pass
        await asyncio.wait_for(outbox.room(0.01), 5.0)

    asyncio.run(act())


def test_of_messages_with_a_key_the_newest_is_kept() -> None:
    outbox = Outbox()
    for number in range(1000):
        outbox.tell({"topic": "job", "number": number}, ("job", "a"))
    outbox.tell({"topic": "job", "number": -1}, ("job", "b"))
    assert [json.loads(text)["number"] for text in taken(outbox)] == [999, -1]


def test_messages_are_not_without_end() -> None:
    outbox = Outbox()
    for number in range(3 * MOST_MESSAGES):
        outbox.tell({"number": number})
    found = taken(outbox)
    assert len(found) == MOST_MESSAGES
    assert json.loads(found[-1])["number"] == 3 * MOST_MESSAGES - 1


def test_messages_go_first_and_what_tells_of_frames_goes_behind_them() -> None:
    outbox = Outbox()
    outbox.offer([FRAME], "a")
    outbox.tell_behind({"topic": "sent"}, "a")
    outbox.tell({"topic": "edge"})
    found = taken(outbox)
    assert [one if isinstance(one, bytes) else json.loads(one)["topic"] for one in found] == [
        "edge", FRAME, "sent",
    ]  # fmt: skip


def test_what_nobody_wants_any_more_is_dropped() -> None:
    outbox = Outbox(250)
    outbox.offer([FRAME], "a")
    outbox.offer([FRAME], "b")
    outbox.tell_behind({"topic": "sent"}, "a")
    outbox.forget("a")
    assert outbox.bytes == 100
    assert taken(outbox) == [FRAME]
