"""The stream, asked as the page asks it: motion, bad messages, slow pages, two of them."""

import json
import socket
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.studio.motion.channels import MotionSource
from arcless.studio.motion.synthetic import SyntheticMotion
from arcless.studio.stream import outbox
from arcless.studio.stream.hub import Hub
from arcless.studio.stream.routes import MOST_SOURCES, routes
from tests.support.served import PATIENCE_S, page, served

WAVE = {"run": "wave"}


class Sources(dict[tuple[str, str], Any]):
    async def open(self, name: tuple[str, str]) -> MotionSource:
        if name not in self:
            raise ModelError("run", got=name[1], expected="one that is there")
        found: MotionSource = self[name]
        return found

    def compute(self, name: tuple[str, str]) -> str:
        return f"job of {name[1]}"


@pytest.fixture(scope="module")
def hub() -> Hub:
    return Hub()


@pytest.fixture(scope="module")
def sources() -> Sources:
    return Sources({("run", "wave"): SyntheticMotion(), ("run", "long"): LONG})


# 8 kB a moment, 40 MB in all: more than any buffer between server and page.
LONG = SyntheticMotion(nodes=2000, end_s=25.0)


@pytest.fixture(scope="module")
def port(hub: Hub, sources: Sources) -> Iterator[int]:
    with served(routes(hub, sources.open, sources.compute), [hub.at_work()]) as found:
        yield found


def test_a_motion_is_announced_and_sent(port: int) -> None:
    with page(port) as one:
        about = one.play(WAVE)
        assert about["source"] == WAVE
        assert (about["end_s"], about["final"], about["wires"]) == (5.0, True, True)
        assert [each["name"] for each in about["channels"]] == ["wire.0.up", "pantograph.0"]
        sent = one.want(WAVE, 1.0, 2.0, 0.1)
        assert (sent["ask"], sent["frames"], sent["dropped"]) == (1, 11, 0)
        wires = [frame for name, frame in one.frames if name == "wire.0.up"]
        times = [float(np.frombuffer(frame[8:16], "<f8")[0]) for frame in wires]
        assert times == pytest.approx(np.arange(1.0, 2.05, 0.1))
        for time_s, frame in zip(times, wires, strict=True):
            expected = SyntheticMotion().uplift(time_s)
            np.testing.assert_array_equal(np.frombuffer(frame[16:], "<f4"), expected)


def test_numbers_are_new_each_time(port: int) -> None:
    with page(port) as one:
        first = {each["number"] for each in one.play(WAVE)["channels"]}
        second = {each["number"] for each in one.play(WAVE)["channels"]}
        assert not first & second


def test_a_newer_want_replaces_an_older_one(port: int) -> None:
    source = {"run": "long"}
    with page(port) as one:
        one.play(source)
        one.tell("want", source=source, from_s=0, to_s=25, every_s=0, ask=1)
        one.tell("want", source=source, from_s=3, to_s=3.1, every_s=0, ask=2)
        sent = one.hear("sent")
        assert (sent["ask"], sent["frames"]) == (2, 21)


def test_a_fast_page_loses_nothing(port: int) -> None:
    source = {"run": "long"}
    with page(port) as one:
        one.play(source)
        sent = one.want(source, 0.0, 25.0, 0.0)
        assert (sent["frames"], sent["dropped"]) == (5001, 0)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "JSON object"),
        ("[]", "JSON object"),
        ("null", "JSON object"),
        ('{"topic": 1}', "JSON object"),
        ("[" * 20_000, "JSON object"),
        ('{"topic": "play"}', "a source is"),
        ('{"topic": "play", "source": {"run": 1}}', "a source is"),
        ('{"topic": "play", "source": {"run": "a", "job": "b"}}', "a source is"),
        ('{"topic": "sing", "source": {"run": "a"}}', "does not know"),
        ('{"topic": "want", "source": {"run": "other"}}', "not played"),
        ('{"topic": "play", "source": {"run": "other"}}', "expected one that is there"),
    ],
)
def test_bad_messages_are_answered(port: int, text: str, words: str) -> None:
    with page(port) as one:
        one.line.send(text)
        assert words in one.hear("error")["text"]
        assert one.play(WAVE)["source"] == WAVE  # and it goes on


@pytest.mark.parametrize("bad", ['"1"', "null", "true", "NaN", "Infinity", "1e400", "1e10", "[1]"])
def test_times_are_numbers(port: int, bad: str) -> None:
    with page(port) as one:
        one.play(WAVE)
        given = json.dumps({"topic": "want", "source": WAVE, "from_s": 0, "every_s": 0, "ask": 1})
        one.line.send(f'{given[:-1]}, "to_s": {bad}}}')
        assert "times in s" in one.hear("error")["text"]


def test_bytes_are_no_message(port: int) -> None:
    with page(port) as one:
        one.line.send(b"\0\1")
        assert "JSON object" in one.hear("error")["text"]


def test_so_many_sources_and_no_more(port: int, sources: Sources) -> None:
    sources |= {("run", str(number)): SyntheticMotion() for number in range(MOST_SOURCES + 1)}
    with page(port) as one:
        for number in range(MOST_SOURCES):
            one.play({"run": str(number)})
        one.tell("play", source={"run": str(MOST_SOURCES)})
        assert "are played already" in one.hear("error")["text"]
        one.tell("leave", source={"run": "0"})
        assert one.play({"run": str(MOST_SOURCES)})


def test_motion_is_computed_for_the_page(port: int) -> None:
    with page(port) as one:
        one.tell("compute motion", source=WAVE)
        assert one.hear("computing")["job"] == "job of wave"


def test_a_run_that_begins_again_is_announced_again(port: int, sources: Sources) -> None:
    first = sources["run", "again"] = SyntheticMotion(final=False, search=1)
    with page(port) as one:
        about = one.play({"run": "again"})
        assert (about["again"], about["search"]) == (False, 1)
        first.later = SyntheticMotion(end_s=7.0, search=2)
        about = one.hear("channels")
        assert (about["again"], about["end_s"], about["search"]) == (True, 7.0, 2)
        assert one.want({"run": "again"}, 6.0, 7.0, 0.5)["frames"] == 3


def test_the_edge_of_a_growing_motion_is_told(port: int, sources: Sources) -> None:
    growing = sources["job", "a"] = SyntheticMotion(end_s=1.0, final=False)
    with page(port) as one:
        one.play({"job": "a"})
        assert one.hear("edge")["end_s"] == 1.0
        growing.end_s = 2.0
        edge = one.hear("edge")
        assert (edge["end_s"], edge["final"]) == (2.0, False)
        assert one.want({"job": "a"}, 0.0, 99.0, 0.1)["to_s"] == 2.0
        growing.final = True
        assert one.hear("edge")["final"] is True


def test_all_pages_hear_what_is_told(port: int, hub: Hub) -> None:
    with page(port) as one, page(port) as other:
        one.play(WAVE)
        other.play(WAVE)  # both listen now
        hub.tell({"topic": "project"})
        assert one.hear("project") == other.hear("project") == {"topic": "project"}


def test_a_page_to_which_nobody_has_anything_to_say_hears_that_the_server_is_there(
    port: int,
) -> None:
    with page(port) as one:
        assert one.hear("beat") == one.hear("beat") == {"topic": "beat"}


def test_a_page_that_reads_nothing_fills_no_memory(port: int, monkeypatch: Any, hub: Hub) -> None:
    """Its frames are dropped, its messages replaced; another page is served meanwhile."""
    boxes: list[outbox.Outbox] = []
    listening = Hub.listening
    monkeypatch.setattr(
        Hub, "listening", lambda self, box: boxes.append(box) or listening(self, box)
    )
    with deaf(port) as line:
        say(line, {"topic": "play", "source": {"run": "long"}})
        for _ in range(3):
            say(line, {"topic": "want", "source": {"run": "long"}, "from_s": 0, "to_s": 25,
                       "every_s": 0, "ask": 1})  # fmt: skip
            for _ in range(200):
                say(line, {"topic": "nonsense"})
                hub.tell({"topic": "job", "job": {"id": "a"}})
            time.sleep(0.2)
        with page(port) as one:
            one.play(WAVE)
            assert one.want(WAVE, 0.0, 1.0, 0.0)["dropped"] == 0
        [box] = boxes[:1]
        assert box.bytes <= outbox.LARGEST
        assert len(box._messages) < 10


def test_a_slow_page_gets_whole_moments_and_is_told_what_it_lost(port: int) -> None:
    with deaf(port) as line:
        say(line, {"topic": "play", "source": {"run": "long"}})
        say(line, {"topic": "want", "source": {"run": "long"}, "from_s": 0, "to_s": 25,
                   "every_s": 0, "ask": 1})  # fmt: skip
        time.sleep(1.0)  # nothing is read: the buffers of the system and of the server are full
        frames, sent = read_all(line)
    assert sent["dropped"] > 0
    assert sent["frames"] + sent["dropped"] == 5001
    assert frames == 2 * sent["frames"]


def deaf(port: int) -> socket.socket:
    """Open the stream by hand: what is not read stays in the socket."""
    line = socket.create_connection(("127.0.0.1", port), PATIENCE_S)
    line.sendall(
        b"GET /api/stream HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\n"
        b"Connection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
        b"Sec-WebSocket-Version: 13\r\n\r\n"
    )
    answer = b""
    while not answer.endswith(b"\r\n\r\n"):
        answer += line.recv(1)
    assert b"101" in answer
    return line


def say(line: socket.socket, message: dict[str, Any]) -> None:
    """Send a text frame, masked by zeros."""
    text = json.dumps(message).encode()
    assert 125 < len(text) + 125 < 65536
    size = bytes([0x80 | len(text)]) if len(text) < 126 else b"\xfe" + len(text).to_bytes(2, "big")
    line.sendall(b"\x81" + size + bytes(4) + text)


def read_all(line: socket.socket) -> tuple[int, dict[str, Any]]:
    """Read until `sent`; return the number of binary frames and that message."""
    frames = 0
    file = line.makefile("rb")
    while True:
        kind, size = file.read(2)
        if size == 126:
            size = int.from_bytes(file.read(2), "big")
        elif size == 127:
            size = int.from_bytes(file.read(8), "big")
        content = file.read(size)
        if kind & 15 == 2:
            frames += 1
        elif kind & 15 == 1 and (message := json.loads(content))["topic"] == "sent":
            return frames, message
