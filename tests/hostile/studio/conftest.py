"""A studio beside files that are none of its own, and what must hold after everything."""

import socket
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from arcless.model.own_copy import copies, write_copies
from tests.support.studio_server import StudioServer

CANARY = b"canary-81c4"
# Time in s for an answer after everything, by the requirement; alone it takes some milliseconds.
SOON_S = 1.0
# MB that the server may grow by: caches of texts and runs, and what the allocator keeps. One leak
# of 1 kB at each of 10^5 questions would be 100 MB.
GROWTH_MB = 60.0
FEW, MANY = 2_000, 100_000
OUTSIDE = {"canary.yaml", "result.nc", "report.html", "assessment.json", "canary.csv"}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a project with links that lead to a canary outside of it."""
    own, outside = tmp_path / "own", tmp_path / "outside"
    own.mkdir()
    outside.mkdir()
    write_copies(own, copies("my", "en50318-ac-simple-320"), "{}\n")
    for name in OUTSIDE:
        (outside / name).write_bytes(CANARY + b": " + CANARY + b"\n")
    (own / "link.yaml").symlink_to(outside / "canary.yaml")
    (own / "link.csv").symlink_to(outside / "canary.csv")
    (own / "away").symlink_to(outside)
    (own / "run-away").mkdir()
    for name in ("result.nc", "report.html"):
        (own / "run-away" / name).symlink_to(outside / name)
    (own / ".hidden.yaml").write_bytes(CANARY)
    return own


@pytest.fixture
def server(folder: Path) -> Iterator[StudioServer]:
    with StudioServer(folder) as started:
        yield started


def check_well(server: StudioServer, folder: Path) -> None:
    """The server answers within a second, and the files are as they were."""
    start = time.monotonic()
    status, _, content = server.ask("/api/file", path="my.yaml")
    assert status == 200
    assert time.monotonic() - start < SOON_S
    assert (folder / "my.yaml").read_bytes() == (folder / "kept.txt").read_bytes()
    assert CANARY not in content
    outside = {one.name for one in (folder.parent / "outside").iterdir()}
    assert outside == OUTSIDE


@pytest.fixture(autouse=True)
def kept(folder: Path) -> None:
    (folder / "kept.txt").write_bytes((folder / "my.yaml").read_bytes())


def read_all(line: socket.socket) -> bytes:
    found = b""
    with suppress(OSError):
        while piece := line.recv(65536):
            found += piece
    return found


def opened_stream(server: StudioServer, cookie: str) -> socket.socket:
    line = server.connect()
    line.sendall(
        f"GET /api/stream HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
        f"Origin: http://127.0.0.1:{server.port}\r\nCookie: {cookie}\r\nConnection: Upgrade\r\n"
        "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n".encode()
    )
    return line
