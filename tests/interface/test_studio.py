"""The command `arcless studio`: its address, its end, and what it says when it cannot begin."""

import http.client
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

from arcless.cli.commands import studio as command
from arcless.studio.server import page
from tests.support.studio_server import StudioServer

Command = Callable[..., Result]
# Time in s within which it ends, by the requirement; the interpreter of a busy machine beside it.
ENDS_S = 1.0 + 0.5


@pytest.fixture
def is_built() -> None:
    if not (page.FOLDER / "index.html").is_file():
        pytest.skip("the page is not built")


@pytest.mark.usefixtures("is_built")
def test_it_prints_one_address_and_serves_the_page(tmp_path: Path) -> None:
    with StudioServer(tmp_path) as server:
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/\?token=[\w-]{43}", server.address)
        status, head, content = server.ask("/")
        assert status == 200
        assert head["content-type"].startswith("text/html")
        script = re.search(rb'src="\./(assets/[^"]+)"', content)
        assert script is not None
        assert server.ask(f"/{script[1].decode()}")[0] == 200
        assert server.json("project")["folder"] == str(tmp_path.resolve())
        server.signal(signal.SIGINT)
        assert server.wait()[0] == 0
        assert server._process.stdout is not None
        assert server._process.stdout.read() == ""


@pytest.mark.usefixtures("is_built")
@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, 0), (signal.SIGTERM, 143), (signal.SIGHUP, 129)]
)
def test_it_ends_within_a_second_and_leaves_no_process(
    tmp_path: Path, number: signal.Signals, code: int
) -> None:
    with StudioServer(tmp_path) as server:
        waiting = http.client.HTTPConnection("127.0.0.1", server.port)
        waiting.connect()  # an open connection holds nothing up
        tasks = Path(f"/proc/{server.pid}/task/{server.pid}/children")
        children = tasks.read_text().split() if tasks.exists() else []
        server.signal(number)
        server.signal(number)  # in anger
        ended, took = server.wait()
        assert ended == code
        assert took < ENDS_S
        waiting.close()
    deadline = time.monotonic() + ENDS_S
    while any(Path(f"/proc/{one}").exists() for one in children) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not any(Path(f"/proc/{one}").exists() for one in children)


@pytest.mark.usefixtures("is_built")
def test_it_listens_on_this_machine_alone(tmp_path: Path) -> None:
    with StudioServer(tmp_path) as server:
        for line in Path("/proc/net/tcp").read_text().splitlines()[1:]:
            local, state = line.split()[1], line.split()[3]
            if local.endswith(f":{server.port:04X}") and state == "0A":  # LISTEN
                assert local.startswith("0100007F")  # 127.0.0.1
        others = [one for one in Path("/proc/net/tcp6").read_text().splitlines()[1:]
                  if one.split()[1].endswith(f":{server.port:04X}")]  # fmt: skip
        assert others == []


@pytest.mark.usefixtures("is_built")
def test_two_side_by_side(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    with StudioServer(tmp_path / "a") as one, StudioServer(tmp_path / "b") as other:
        both = f"{one.cookie}; {other.cookie}"  # as a browser sends them: it knows no ports
        for server in (one, other):
            assert server.ask("/api/project", cookie=both)[0] == 200
        assert one.ask("/api/project", cookie=other.cookie)[0] == 403


@pytest.mark.usefixtures("is_built")
def test_a_port_in_use(arcless: Command) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        done = arcless("studio", "--no-browser", "--port", port)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert f"cannot listen on port {port}: got Address already in use" in done.stderr
    assert "without `--port` the studio takes one" in done.stderr


@pytest.mark.usefixtures("is_built")
def test_no_such_folder(arcless: Command) -> None:
    done = arcless("studio", "nowhere", "--no-browser")
    assert done.exit_code == 2
    assert "nowhere: no such folder" in done.stderr


def test_a_missing_package(arcless: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(command, "find_spec", lambda name: None if name == "uvicorn" else object())
    done = arcless("studio", "--no-browser")
    assert done.exit_code == 2
    assert done.stderr == (
        "error: the studio needs the package uvicorn, which is not installed;"
        " hint: pip install 'arcless[studio]'\n"
    )


def test_a_page_that_is_not_built(
    arcless: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(page, "FOLDER", tmp_path)
    done = arcless("studio", "--no-browser")
    assert done.exit_code == 2
    assert (
        done.stderr == "error: the page of the studio is not built; hint: `make page` builds it\n"
    )


def test_the_browser_is_started_with_an_address_of_its_own(
    arcless: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []

    def serve(folder: Path, port: int, ready: Callable[[str, str], None]) -> None:
        assert (folder, port) == (Path(), 0)
        ready("http://printed", "http://started")

    monkeypatch.setattr("arcless.studio.server.serve.serve", serve)
    monkeypatch.setattr(command, "_open", opened.append)
    assert arcless("studio").stdout == "http://printed\n"
    assert opened == ["http://started"]
    assert arcless("studio", "--no-browser").stdout == "http://printed\n"
    assert len(opened) == 1


def test_help_imports_no_server() -> None:
    code = (
        "import sys\nfrom arcless.cli.app import app\n"
        "try:\n    app(['--help'])\nexcept SystemExit:\n    pass\n"
        "print([name for name in ('starlette', 'uvicorn', 'websockets', 'asyncio', 'webbrowser')"
        " if name in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True,
        env={**os.environ, "COLUMNS": "100"},
    )  # fmt: skip
    assert done.stderr == "[]\n"
    assert "studio" in done.stdout
