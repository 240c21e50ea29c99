"""`arcless studio`: its address, its end, and what it says where it cannot start."""

import importlib.util
import os
import signal
import socket
import subprocess
import time
import webbrowser
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from arcless.studio.server import page, serve
from tests.support.studio_server import Server

Arcless = Callable[..., Result]
# The promise is one second: it leaves 0.7 s after a signal, whatever it does. A machine that does
# much else may take longer; what waits for an open page or a lock never ends.
ENDS_WITHIN_S = 30.0
# Runs that take half a second to read: the end falls into that.
RUNS = 80


def refused(done: Result, *words: str) -> None:
    assert done.exit_code == 2, done.output
    assert not done.stdout
    assert done.stderr.startswith("error: ")
    assert "Traceback" not in done.stderr
    for word in words:
        assert word in done.stderr, done.stderr


@pytest.fixture
def built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Have a page, whether or not it was built."""
    (tmp_path / "index.html").write_text("<!doctype html>", "utf-8")
    monkeypatch.setattr(page, "FOLDER", tmp_path)


@pytest.mark.parametrize("name", ["starlette", "uvicorn", "websockets"])
def test_without_the_extra(arcless: Arcless, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    found = importlib.util.find_spec
    monkeypatch.setattr(
        "arcless.cli.commands.studio.find_spec", lambda one: None if one == name else found(one)
    )
    refused(arcless("studio"), name, "pip install 'arcless[studio]'")


def test_without_a_built_page(
    arcless: Arcless, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page, "FOLDER", tmp_path / "none")
    refused(arcless("studio", "--no-browser"), "page of the studio is not built", "make page")


@pytest.mark.usefixtures("built")
def test_a_port_in_use(arcless: Arcless) -> None:
    with socket.socket() as taken:
        taken.bind((serve.HOST, 0))
        taken.listen()
        port = taken.getsockname()[1]
        refused(arcless("studio", "--no-browser", "--port", port), f"port {port}", "in use")


@pytest.mark.usefixtures("built")
def test_a_folder_that_is_none(arcless: Arcless, tmp_path: Path) -> None:
    refused(arcless("studio", "none", "--no-browser"), "no such folder", "none")
    (tmp_path / "file").touch()
    refused(arcless("studio", "file", "--no-browser"), "no such folder", "file")


@pytest.mark.parametrize("port", ["-1", "65536", "x"])
def test_a_port_that_is_none(arcless: Arcless, port: str) -> None:
    done = arcless("studio", "--port", port)
    assert done.exit_code == 2
    assert "--port" in done.stderr


@pytest.mark.usefixtures("built")
def test_the_browser_is_opened_with_another_token(
    arcless: Arcless, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened = list[str]()

    def serving(_: Path, __: int, ready: Callable[[str, str], None]) -> None:
        ready("http://127.0.0.1:1/?token=printed", "http://127.0.0.1:1/?token=once")

    monkeypatch.setattr(serve, "serve", serving)
    monkeypatch.setattr(webbrowser, "open", opened.append)
    assert arcless("studio").stdout == "http://127.0.0.1:1/?token=printed\n"
    assert arcless("studio", "--no-browser").exit_code == 0
    end = time.monotonic() + 10.0
    while not opened and time.monotonic() < end:
        time.sleep(0.01)
    assert opened == ["http://127.0.0.1:1/?token=once"]


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 0), (signal.SIGTERM, 143)])
def test_one_address_and_a_quick_end(tmp_path: Path, number: signal.Signals, code: int) -> None:
    folder = tmp_path / "project"
    folder.mkdir()
    with Server(folder, tmp_path) as server:
        # A page that is open, and one that has asked half a question.
        with server.connect() as one, server.connect() as other:
            one.sendall(server.head(
                "GET /api/stream HTTP/1.1", "Connection: Upgrade", "Upgrade: websocket",
                "Sec-WebSocket-Version: 13", "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==",
            ))  # fmt: skip
            assert b" 101 " in one.recv(65536)
            other.sendall(server.head("POST /api/check HTTP/1.1", "Content-Length: 100"))
            server.process.send_signal(number)
            out, err = server.process.communicate(timeout=ENDS_WITHIN_S)
        assert (out, err) == ("", "")
        assert server.process.returncode == code


def test_a_quick_end_while_runs_are_read(tmp_path: Path, finished: Path) -> None:
    """The thread that reads results may hold the lock of HDF5, which waited for it for ever."""
    folder = tmp_path / "project"
    for number in range(RUNS):
        place = folder / "runs" / str(number)
        place.mkdir(parents=True)
        os.link(finished / "result.nc", place / "result.nc")
    for _ in range(3):
        with Server(folder, tmp_path) as server:
            server.process.send_signal(signal.SIGTERM)
            _, err = server.process.communicate(timeout=ENDS_WITHIN_S)
        assert (server.process.returncode, err) == (143, "")


def test_the_port_is_free_again_at_once(tmp_path: Path) -> None:
    folder = tmp_path / "project"
    folder.mkdir()
    with Server(folder, tmp_path) as server:
        port = server.port
        server.answers_within()
        server.process.send_signal(signal.SIGINT)
        server.process.communicate(timeout=30)
    with Server(folder, tmp_path, "--port", str(port)) as again:
        assert again.port == port
        assert again.cookie != server.cookie


def test_its_help_says_what_it_serves(
    process: Callable[..., subprocess.CompletedProcess[str]],
) -> None:
    told = process("studio", "--help").stdout
    for word in ("FOLDER", "--no-browser", "--port", "Ctrl-C"):
        assert word in told
