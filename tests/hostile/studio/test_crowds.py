"""Too many clients, slow ones, and those that send too much or read nothing."""

import socket
from contextlib import ExitStack, suppress
from pathlib import Path

from arcless.studio.server.crowd import MOST_STRANGERS, PROVE_S
from tests.hostile.studio.conftest import GROWTH_MB, SOON_S, check_well, opened_stream
from tests.support.studio_server import StudioServer


def test_stream_needs_the_cookie(server: StudioServer, folder: Path) -> None:
    for cookie in ("", server.cookie[:-1], "x" * 5000):
        with opened_stream(server, cookie) as line:
            assert b" 403 " in line.recv(4096)
    check_well(server, folder)


def test_connections_in_turn(server: StudioServer, folder: Path) -> None:
    before = server.memory()
    for _ in range(10_000):
        server.connect().close()
    server.ask("/")  # the last ones still wait to be accepted
    assert server.memory() - before < GROWTH_MB
    check_well(server, folder)


def test_slow_strangers_leave_room_for_the_user(server: StudioServer, folder: Path) -> None:
    """More of them than there are places: half a head, half a body, nothing at all."""
    starts = [b"", b"GET / HT", b"GET / HTTP/1.1\r\nHost: x\r\nX: ",
              f"POST /api/check HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nContent-Length: 99\r\n\r\n"
              .encode()]  # fmt: skip
    with ExitStack() as stack:
        lines = [stack.enter_context(server.connect()) for _ in range(3 * MOST_STRANGERS)]
        for number, line in enumerate(lines):
            with suppress(OSError):
                line.sendall(starts[number % len(starts)])
        check_well(server, folder)
        # The oldest ones were sent away at once, the others when their time is over.
        lines[0].settimeout(SOON_S)
        assert is_cut(lines[0])
        lines[-4].settimeout(PROVE_S + 5 * SOON_S)
        assert is_cut(lines[-4])
        check_well(server, folder)


def is_cut(line: socket.socket) -> bool:
    try:
        return line.recv(1) == b""
    except TimeoutError:
        return False
    except OSError:
        return True


def test_who_reads_nothing_is_not_waited_for(server: StudioServer, folder: Path) -> None:
    with ExitStack() as stack:
        for _ in range(20):
            line = stack.enter_context(server.connect())
            line.sendall(f"GET /api/schema HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                         f"Cookie: {server.cookie}\r\n\r\n".encode() * 3)  # fmt: skip
        check_well(server, folder)


def test_a_long_body_is_refused_and_not_kept(server: StudioServer, folder: Path) -> None:
    before = server.memory()
    for route in ("check", "statics", "file"):
        with suppress(ConnectionError):  # the server does not read on, and the client may see that
            status, _, _ = server.ask(f"/api/{route}", "POST", b"x" * 30_000_000)
            assert status in (405, 413)
    assert server.memory() - before < GROWTH_MB
    check_well(server, folder)
