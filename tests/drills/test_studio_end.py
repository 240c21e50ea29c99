"""The end of the studio's server in the midst of its work: silent, and nothing stays behind."""

import json
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from websockets.sync.client import connect
from websockets.typing import Origin

from arcless.storage.hidden_files import PREFIX
from tests.drills.conftest import SHORT
from tests.drills.test_studio_runs import LONGEST_S, SLOW, begin, wait_for
from tests.support import processes
from tests.support.studio_server import Server

# Time in s in which all processes are gone: workers notice the end within 2 s.
GONE_S = 3.0
HOW = [signal.SIGINT, signal.SIGTERM, signal.SIGKILL]


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return an empty folder that servers take for temporary files."""
    place = tmp_path / "temporary"
    place.mkdir()
    monkeypatch.setenv("TMPDIR", str(place))
    yield place


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    found = tmp_path / "project"
    found.mkdir()
    shutil.copy(SHORT, found / "short.yaml")
    return found


def all_at_work(server: Server, stack: ExitStack) -> None:
    """Have a run step and be watched, a line at rest asked for, and a real-time session held."""
    headers = {"Cookie": server.cookie}

    def opened(path: str) -> Any:
        return stack.enter_context(connect(
            f"ws://{server.host}/api/{path}", origin=Origin(f"http://{server.host}"),
            additional_headers=headers, max_size=None, compression=None, close_timeout=0.5,
        ))  # fmt: skip

    statics = {"path": "short.yaml", "want": ["line"], "question": 1}
    assert server.ask("POST", "/api/statics", statics).status == 200
    job = begin(server, SLOW)
    wait_for(server, job["id"], lambda one: one["doing"].startswith("stepping"))
    stream, hands_on = opened("stream"), opened("hands_on")
    source = {"job": job["id"]}
    stream.send(json.dumps({"topic": "play", "source": source}))
    while json.loads(stream.recv(timeout=LONGEST_S))["topic"] != "channels":
        pass
    hands_on.send(json.dumps({"topic": "begin", "scenario": "short.yaml", "rate": 1.0}))
    assert json.loads(hands_on.recv(timeout=LONGEST_S))["topic"] == "begun"
    want = {"from_s": 0.0, "to_s": 99.0, "every_s": 0.0, "ask": 1}
    stream.send(json.dumps({"topic": "want", "source": source, **want}))


def leave_a_temporary_folder() -> None:
    """Have a process killed that has a temporary folder with a file in it."""
    script = (
        "import os\nfrom arcless.storage import hidden_files\n"
        "with hidden_files.temporary_folder() as folder:\n"
        "    (folder / 'result.nc').write_bytes(b'half')\n    os._exit(1)\n"
    )
    subprocess.run([sys.executable, "-c", script], check=False)


@pytest.mark.parametrize("how", HOW, ids=lambda how: how.name)
def test_nothing_is_said_and_nothing_stays(
    folder: Path, tmp_path: Path, temporary: Path, how: signal.Signals
) -> None:
    with Server(folder, tmp_path) as server:
        with ExitStack() as stack:
            all_at_work(server, stack)
            workers = processes.below(server.process.pid)
            assert len(workers) >= 3
            server.process.send_signal(how)
            deadline = time.monotonic() + GONE_S
            server.process.wait(LONGEST_S)
            while any(map(processes.is_there, workers)) and time.monotonic() < deadline:
                time.sleep(0.02)
            assert not any(map(processes.is_there, workers))
        _, said = server.process.communicate()
    assert said == ""
    # Who is killed leaves hidden files, which go with the next start; nobody sees half of a run.
    seen = {path.name for path in folder.rglob("*") if path.is_file()}
    assert {name for name in seen if not name.startswith(PREFIX)} == {"short.yaml"}
    assert all(path.name.startswith(PREFIX) for path in temporary.iterdir())
    leave_a_temporary_folder()
    with Server(folder, tmp_path):
        assert [path.name for path in folder.rglob("*") if path.is_file()] == ["short.yaml"]
        assert list((folder / "runs").glob("*")) == []
        assert list(temporary.iterdir()) == []
