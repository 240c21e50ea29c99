"""The studio is killed while it saves, stopped for a while, and finds its disk full."""

import json
import random
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from arcless.model.own_copy import copies, write_copies
from tests.support.studio_server import StudioServer

# Length of a text that takes some milliseconds to write, so that a kill can hit the writing.
LONG = 2_000_000
OFTEN = 2


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_copies(tmp_path, copies("my", "en50318-ac-simple-320"), "{}\n")
    return tmp_path


def saved(server: StudioServer, text: str) -> None:
    version = server.json("file", path="my.yaml")["version"]
    body = {"path": "my.yaml", "text": text, "version": version}
    assert server.ask("/api/file", "PUT", body)[0] == 200


def kill_while_saving(folder: Path, chance: random.Random) -> None:
    """Save one text after the other, and kill the server at some moment of that."""
    names = [f"name: {letter * LONG}\n" for letter in "ab"]
    with StudioServer(folder) as server:
        saved(server, names[0])
        server_killed = threading.Event()

        def kill() -> None:
            time.sleep(chance.uniform(0.0, 0.3))
            server.signal(signal.SIGKILL)
            server_killed.set()

        killer = threading.Thread(target=kill)
        killer.start()
        with suppress(OSError, AssertionError, ValueError):
            while not server_killed.is_set():
                for text in reversed(names):
                    saved(server, text)
        killer.join()
        server.wait()
    assert (folder / "my.yaml").read_text() in names


def test_killed_while_it_saves(folder: Path) -> None:
    chance = random.Random(26)
    for _ in range(OFTEN):
        kill_while_saving(folder, chance)
    # The next saving sweeps what a killed one left.
    with StudioServer(folder) as server:
        saved(server, "name: x\n")
    assert {one.name for one in folder.iterdir()} == {
        "my.yaml", "my-line.yaml", "arcless.schema.json"
    }  # fmt: skip


def test_disk_that_is_really_full(small_disk: Callable[[int], Path]) -> None:
    disk = small_disk(64)
    write_copies(disk, copies("my", "pantograph/ac-simple"), "{}\n")
    before = (disk / "my.yaml").read_bytes()
    with StudioServer(disk) as server:
        version = server.json("file", path="my.yaml")["version"]
        long = {"path": "my.yaml", "text": f"name: {'x' * 200_000}\n", "version": version}
        status, _, content = server.ask("/api/file", "PUT", long)
        assert status == 400
        told = json.loads(content)["error"]["text"]
        assert "No space left on device" in told
        status, _, content = server.ask("/api/measured?name=a.csv", "POST", b"x" * 200_000)
        assert "No space left on device" in json.loads(content)["error"]["text"]
        assert (disk / "my.yaml").read_bytes() == before
        assert not (disk / "measured" / "a.csv").exists()
        saved(server, before.decode() + "# more\n")
    assert (disk / "my.yaml").read_bytes() == before + b"# more\n"


def test_stopped_for_a_while(folder: Path) -> None:
    """As on a laptop that was closed: questions wait, and are answered afterwards."""
    with StudioServer(folder) as server:
        server.signal(signal.SIGSTOP)
        answers: list[int] = []
        asking = [
            threading.Thread(target=lambda: answers.append(server.ask("/api/file?path=my.yaml")[0]))
            for _ in range(5)
        ]
        for one in asking:
            one.start()
        time.sleep(2.0)
        assert answers == []
        (folder / "my.yaml").write_text("name: changed meanwhile\n")
        server.signal(signal.SIGCONT)
        for one in asking:
            one.join()
        assert answers == [200] * 5
        assert server.json("file", path="my.yaml")["text"] == "name: changed meanwhile\n"
        saved(server, "name: x\n")
