"""Malformed questions and frames of the stream."""

import random
import socket
from contextlib import suppress
from pathlib import Path

import pytest

from tests.hostile.studio.asked import LEADING_OUT, PATHS, POSTED
from tests.hostile.studio.conftest import (
    CANARY,
    FEW,
    GROWTH_MB,
    MANY,
    check_well,
    opened_stream,
    read_all,
)
from tests.support.studio_server import StudioServer

VALUES = [None, True, -1, 1e308, "", "x", "\0", [], {}, [[]], {"a": {}}, "9" * 50, "my.yaml"]


def malformed(chance: random.Random, server: StudioServer) -> bytes:
    """Return a question that is wrong in some way; half of them have the cookie."""

    def spoilt(text: bytes) -> bytes:
        for _ in range(chance.choice((0, 0, 1, 3, 20))):
            at = chance.randrange(len(text) + 1)
            text = (
                text[:at] + chance.randbytes(chance.randrange(4)) + text[at + chance.randrange(3) :]
            )
        return text

    if chance.random() < 0.1:
        return chance.randbytes(chance.randrange(1, 3000))
    method = chance.choice(
        ["GET", "POST", "PUT", "DELETE", "HEAD", "OPTIONS", "TRACE", "PATCH", "X"]
    )
    names = ["path", "run", "name", "key", "token", "from", "to", "points", "column", "x", "as"]
    query = "&".join(f"{chance.choice(names)}={chance.choice(LEADING_OUT[:12]).encode().hex()}"
                     for _ in range(chance.randrange(3)))  # fmt: skip
    path = chance.choice([*PATHS, *(f"/api/{one}" for one in POSTED)])
    host = chance.choice([f"127.0.0.1:{server.port}"] * 6 + ["evil.example", "", "a" * 300])
    head = [f"{method} {path}?{query} HTTP/1.{chance.choice('110')}", f"Host: {host}"]
    if chance.random() < 0.5:
        head.append(f"Cookie: {server.cookie}")
    if chance.random() < 0.7:
        head.append(f"Origin: {chance.choice([f'http://{host}', 'null', 'http://evil.example'])}")
    if chance.random() < 0.2:
        head += ["Connection: Upgrade", "Upgrade: websocket", "Sec-WebSocket-Version: 13",
                 "Sec-WebSocket-Key: " + chance.choice(["dGhlIHNhbXBsZSBub25jZQ==", "x", ""])]  # fmt: skip
    body = chance.choice([b"", b"{}", b"[" * 1000, chance.randbytes(200), b'{"path":"my.yaml"}',
                          repr(chance.choice(VALUES)).encode()])  # fmt: skip
    head.append(f"Content-Length: {chance.choice([len(body)] * 4 + [0, -1, 10**12, 'x'])}")
    if chance.random() < 0.1:
        head.append("Transfer-Encoding: chunked")
    if chance.random() < 0.05:
        head.append(f"X: {'y' * chance.choice((1000, 70_000))}")
    return spoilt("\r\n".join([*head, "Connection: close", "", ""]).encode() + body)


def ask_malformed(server: StudioServer, folder: Path, count: int) -> None:
    chance = random.Random(count)
    before = 0.0
    for number in range(count):
        with server.connect() as line:
            line.settimeout(0.3)  # of one that waits for more of a question nothing is expected
            with suppress(OSError):
                line.sendall(malformed(chance, server))
                line.shutdown(socket.SHUT_WR)
                assert CANARY not in read_all(line)
        if number == min(500, count // 2):
            before = server.memory()
    assert server.memory() - before < GROWTH_MB
    check_well(server, folder)


def test_malformed_questions(server: StudioServer, folder: Path) -> None:
    ask_malformed(server, folder, FEW)


@pytest.mark.evidence
def test_many_malformed_questions(server: StudioServer, folder: Path) -> None:
    ask_malformed(server, folder, MANY)


def frame(chance: random.Random) -> bytes:
    """Return a frame of a WebSocket (RFC 6455, 5.2) that is wrong in some way, or its message is."""
    texts = [b"", b"{", b"[]", b'{"topic": 1}', b'{"topic": "play"}', b'{"topic": "want", "source": {}}',
             b'{"topic": "play", "source": {"run": "../outside"}}',
             b'{"topic": "play", "source": {"job": "x"}}', b'{"topic": "leave", "source": {"run": null}}',
             b'{"topic": "want", "source": {"run": "run-away"}, "from_s": NaN, "to_s": 1e999}',
             b"\xff\xfe", b"[" * 2000, chance.randbytes(300), b'{"topic": "' + b"x" * 70_000 + b'"}']  # fmt: skip
    content = chance.choice(texts)
    if chance.random() < 0.3:
        return chance.randbytes(chance.randrange(1, 100))
    first = (
        0x80 | chance.choice((1, 1, 1, 1, 2, 0, 3, 8, 9, 10, 15)) | chance.choice((0, 0, 0, 0x40))
    )
    length = chance.choice([len(content)] * 8 + [2**62, 0])
    if length < 126:
        head = bytes([first, 0x80 | length])
    elif length < 2**16:
        head = bytes([first, 0xFE]) + length.to_bytes(2, "big")
    else:
        head = bytes([first, 0xFF]) + length.to_bytes(8, "big")
    key = chance.randbytes(4)
    return head + key + bytes(one ^ key[at % 4] for at, one in enumerate(content))


def send_malformed(server: StudioServer, folder: Path, count: int) -> None:
    chance, before = random.Random(count), 0.0
    sent = 0
    while sent < count:
        with opened_stream(server, server.cookie) as line:
            line.settimeout(0.3)
            with suppress(OSError):
                assert b" 101 " in line.recv(4096)
                for _ in range(20):
                    sent += 1
                    line.sendall(frame(chance))
                line.shutdown(socket.SHUT_WR)
                assert CANARY not in read_all(line)
        before = before or (server.memory() if sent > count / 10 else 0.0)
    assert server.memory() - before < GROWTH_MB
    check_well(server, folder)


def test_malformed_frames(server: StudioServer, folder: Path) -> None:
    send_malformed(server, folder, FEW)


@pytest.mark.evidence
def test_many_malformed_frames(server: StudioServer, folder: Path) -> None:
    send_malformed(server, folder, MANY)
