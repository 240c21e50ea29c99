"""A hostile client of the studio: malformed requests and frames, slow ones, many in turn."""

import base64
import json
import os
import random
import socket
import struct
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from arcless.studio.server.crowd import PROVE_S
from tests.support.studio_server import Server

CANARY = "a-secret-outside-of-the-folder"
FEW, MANY = 1_000, 100_000
FEW_CONNECTIONS, MANY_CONNECTIONS = 300, 10_000
# Promised: an answer within a second. A machine that does much else may take longer, and a server
# that hangs never answers.
ANSWERS_S = 20.0
# Memory in MiB by which the server may grow. Answers, caches of routes and the allocator's own
# need some of it; one request that is kept, of 4 MiB at most, is seen among a thousand.
GROWTH_MIB = 150.0
# Connections that are being closed when they are counted.
CLOSING = 80
UPGRADE = ("Connection: Upgrade", "Upgrade: websocket", "Sec-WebSocket-Version: 13",
           f"Sec-WebSocket-Key: {base64.b64encode(bytes(16)).decode()}")  # fmt: skip
PATHS = ("project", "file", "patch", "new", "variant", "check", "schema", "form", "measured", "run",
         "runs", "statics", "jobs", "series", "figures", "compare", "explain", "space_time",
         "stream", "run/report", "run/line", "studies", "hands_on", "jobs/1/cancel")  # fmt: skip
VALUES = (None, True, -1, 1e308, "", "a\0b", "../canary.yaml", "/etc/passwd", "shipped:line/../x",
          "x" * 5000, [], {}, [[[]]], {"a": {"b": []}}, "!!python/name:os.system", "é\ud800",
          "runs/../../canary.yaml", "&a [*a]", 2**70)  # fmt: skip
KEYS = ("path", "text", "version", "changes", "name", "from", "scenario", "want", "question",
        "subjects", "run", "key", "points", "record_motion", "certainty", "topic",
        "source")  # fmt: skip
Request = Callable[[Server, random.Random], bytes]


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    folder = tmp_path / "project"
    folder.mkdir()
    (tmp_path / "canary.yaml").write_text(f"format: arcless-line/1\nname: {CANARY}\n", "utf-8")
    (folder / "link.yaml").symlink_to(tmp_path / "canary.yaml")
    (folder / "a.yaml").write_text("format: arcless-line/1\nname: a\n", "utf-8")
    with Server(folder, tmp_path) as found:
        yield found


def noise(rng: random.Random, most: int) -> bytes:
    return rng.randbytes(rng.randrange(most))


def no_http(server: Server, rng: random.Random) -> bytes:
    return noise(rng, 2000)


def spoilt_http(server: Server, rng: random.Random) -> bytes:
    """Return a right request of which some bytes are others."""
    whole = bytearray(right(server, rng))
    for _ in range(rng.randrange(1, 8)):
        whole[rng.randrange(len(whole))] = rng.randrange(256)
    return bytes(whole[: rng.randrange(1, len(whole) + 1)])


def odd_head(server: Server, rng: random.Random) -> bytes:
    line = rng.choice((
        "GET /../../canary.yaml HTTP/1.1", "GET http://evil/ HTTP/1.1", "PRI * HTTP/2.0",
        "GET / HTTP/9.9", "A" * 70_000, "GET /%00%ff%2e%2e/canary.yaml HTTP/1.1", "get / http/1.1",
        "CONNECT evil:80 HTTP/1.1", "OPTIONS * HTTP/1.1", "GET //canary.yaml HTTP/1.1",
        f"GET /?{'a&' * 3000} HTTP/1.1", "TRACE / HTTP/1.1", "PUT /api/file HTTP/1.0",
    ))  # fmt: skip
    more = rng.choice((
        ("Content-Length: -1",), ("Content-Length: 99999999999999999999",), ("Content-Length: x",),
        ("Content-Length: 5", "Content-Length: 6"), ("Transfer-Encoding: chunked",),
        ("X: " * 9000,),
        ("Transfer-Encoding: chunked", "Content-Length: 3"), ("Cookie: " + "a=b; " * 3000,), ("é",),
        ("Content-Encoding: gzip",), ("Expect: 100-continue", "Content-Length: 9"), ("",), UPGRADE,
        ("Range: bytes=0-1,1-2,-5",), tuple(f"H{number}: x" for number in range(500)),
    ))  # fmt: skip
    return server.head(line, *more) + noise(rng, 200)


def right(server: Server, rng: random.Random) -> bytes:
    """Return a request that is right as HTTP, with a body of wrong things."""
    body = json.dumps({rng.choice(KEYS): rng.choice(VALUES) for _ in range(rng.randrange(6))})
    content = rng.choice((body.encode(), noise(rng, 300), b"[" * 5000))
    query = "&".join(f"{rng.choice(KEYS)}={rng.choice(('..', '%00', 'a', '-1', 'NaN', '%2e%2e/x'))}"
                     for _ in range(rng.randrange(4)))  # fmt: skip
    method = rng.choice(("GET", "POST", "PUT", "DELETE"))
    line = f"{method} /api/{rng.choice(PATHS)}?{query} HTTP/1.1"
    return server.head(line, f"Content-Length: {len(content)}", "Connection: close") + content


def frames(server: Server, rng: random.Random) -> bytes:
    """Return the opening of a WebSocket, and what are no frames, or frames of nonsense."""
    where = rng.choice(("stream", "stream", "hands_on"))
    opening = server.head(f"GET /api/{where} HTTP/1.1", *UPGRADE)
    sent = b""
    for _ in range(rng.randrange(1, 8)):
        value = {
            rng.choice(KEYS): rng.choice(VALUES),
            "topic": rng.choice(("play", "want", "x", 5)),
        }
        content = rng.choice((noise(rng, 300), json.dumps(value).encode(), b"[" * 3000, b""))
        sent += rng.choice((noise(rng, 50), frame(content, rng), frame(content, rng)))
    return opening + sent


def frame(content: bytes, rng: random.Random) -> bytes:
    """Return a frame with a mask; its kind, length and flags may be wrong."""
    kind = rng.choice((0x81, 0x82, 0x80, 0x88, 0x89, 0x01, 0xF1, 0x83))
    length = rng.choice((len(content), len(content), len(content), 2**62, 0))
    size = bytes([0x80 | length]) if length < 126 else (
        struct.pack(">BH", 0x80 | 126, length) if length < 2**16
        else struct.pack(">BQ", 0x80 | 127, length)
    )  # fmt: skip
    mask = rng.randbytes(4)
    return bytes([kind]) + size + mask + bytes(b ^ mask[k % 4] for k, b in enumerate(content))


KINDS: tuple[Request, ...] = (no_http, spoilt_http, odd_head, right, right, frames)


def send(server: Server, content: bytes, wait_s: float = 0.05) -> bytes:
    """Send bytes, and return what comes back until the end or until nothing more does."""
    found = b""
    with suppress(OSError), server.connect(5.0) as connection:
        with suppress(OSError):
            connection.sendall(content)
            connection.shutdown(socket.SHUT_WR)
        connection.settimeout(wait_s)
        with suppress(OSError):
            while piece := connection.recv(65536):
                found += piece
    return found


def check_well(server: Server, memory: float, files: int) -> None:
    assert server.process.poll() is None
    assert server.answers_within() < ANSWERS_S
    deadline = time.monotonic() + 15.0
    while server.open_files() > files + CLOSING and time.monotonic() < deadline:
        time.sleep(0.1)
    assert server.open_files() <= files + CLOSING
    assert server.memory() < memory + GROWTH_MIB


def campaign(server: Server, count: int) -> float:
    """Send malformed requests and frames; return the memory in MiB that the server took more."""
    server.answers_within()
    memory, files, rng = server.memory(), server.open_files(), random.Random(26)
    for number in range(count):
        made = KINDS[number % len(KINDS)](server, rng)
        assert CANARY.encode() not in send(server, made), made
        assert server.process.poll() is None, (number, made)
    check_well(server, memory, files)
    return server.memory() - memory


def test_malformed_requests_and_frames(server: Server, tmp_path: Path) -> None:
    campaign(server, FEW)
    told = (tmp_path / "canary.yaml").read_text("utf-8")
    assert CANARY in told, "the canary is as it was"


@pytest.mark.evidence
def test_many_malformed_requests_and_frames(server: Server) -> None:
    campaign(server, MANY)


def in_turn(server: Server, count: int) -> None:
    memory, files = server.memory(), server.open_files()
    for number in range(count):
        with server.connect(5.0) as connection:
            if number % 3 == 0:  # closed at once; or reset; or after half a head
                connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            elif number % 3 == 1:
                connection.sendall(b"GET / HTTP/1.1\r\nHost: ")
    check_well(server, memory, files)


def test_connections_in_turn(server: Server) -> None:
    server.answers_within()
    in_turn(server, FEW_CONNECTIONS)


@pytest.mark.evidence
def test_many_connections_in_turn(server: Server) -> None:
    server.answers_within()
    in_turn(server, MANY_CONNECTIONS)


def test_many_strangers_at_once_leave_room_for_the_user(server: Server) -> None:
    """More connections than a process has open files, of which none says anything."""
    held = []
    try:
        with suppress(OSError):
            for _ in range(1500):
                held.append(server.connect(5.0))
        assert len(held) > 500
        assert server.answers_within() < ANSWERS_S
        assert server.open_files() < 300
    finally:
        for one in held:
            one.close()


SLOW = {
    "line": b"G",
    "head": b"GET /api/project HTTP/1.1\r\nHost: x\r\nX-Slow: ",
    "body": b"POST /api/check HTTP/1.1\r\nHost: x\r\nContent-Length: 1000\r\n\r\n{",
}


def test_slow_strangers_are_sent_away(server: Server) -> None:
    """A byte every half second, in the first line, in the head, in the body."""
    held = {name: server.connect(5.0) for name in SLOW}
    for name, start in SLOW.items():
        held[name].sendall(start)
    started = time.monotonic()
    while held and time.monotonic() - started < 2.0 * PROVE_S:
        assert server.answers_within() < ANSWERS_S
        time.sleep(0.5)
        held = {name: one for name, one in held.items() if not is_gone(one)}
    assert held == {}


def is_gone(connection: socket.socket) -> bool:
    """Return whether the other end has closed a connection, after one more byte to it."""
    connection.setblocking(False)
    try:
        connection.send(b"x")
        return connection.recv(65536) == b""
    except BlockingIOError:
        return False
    except OSError:
        return True


def test_one_who_does_not_read_stops_nobody(server: Server) -> None:
    server.answers_within()  # the first answer is computed, the others are kept
    held = []
    for _ in range(8):
        connection = server.connect(5.0)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2048)
        with suppress(OSError):
            connection.settimeout(0.5)
            for _ in range(50):
                connection.sendall(server.head("GET /api/schema HTTP/1.1"))
        held.append(connection)
    memory = server.memory()
    assert server.answers_within() < ANSWERS_S
    for one in held:
        one.close()
    assert server.memory() < memory + GROWTH_MIB


def test_a_message_that_is_too_long_closes_the_socket(server: Server) -> None:
    rng = random.Random(1)
    with server.connect(5.0) as connection:
        connection.sendall(server.head("GET /api/stream HTTP/1.1", *UPGRADE))
        assert b" 101 " in connection.recv(65536)
        content, mask = b" " * (64 * 1024 + 1), rng.randbytes(4)
        masked = bytes(b ^ mask[k % 4] for k, b in enumerate(content))
        connection.sendall(struct.pack(">BBQ", 0x81, 0xFF, len(content)) + mask + masked)
        found = b""
        with suppress(OSError):
            while piece := connection.recv(65536):
                found += piece
    # Close frame with code 1009, "message too big" of RFC 6455, 7.4.1.
    assert struct.pack(">H", 1009) in found
    assert server.answers_within() < ANSWERS_S


def test_it_listens_on_this_machine_alone(server: Server) -> None:
    line = f":{server.port:04X} "
    listening = [
        words[1]
        for table in ("tcp", "tcp6")
        for words in map(str.split, Path(f"/proc/net/{table}").read_text("utf-8").splitlines()[1:])
        if f"{words[1].rpartition(':')[2]}" == line[1:5] and words[3] == "0A"
    ]
    # 127.0.0.1, its bytes from the last to the first.
    assert listening == [f"0100007F:{server.port:04X}"]
    assert os.access(f"/proc/{server.process.pid}", os.R_OK)
