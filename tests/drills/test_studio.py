"""The studio's server killed while it saves, and stopped for a while as on a closed laptop."""

import hashlib
import http.client
import os
import random
import signal
import threading
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from arcless.storage.hidden_files import PREFIX
from tests.support.studio_server import Server

FEW, MANY = 4, 100
# Time in s within which a server is killed while texts of a megabyte are saved, some ms each.
LONGEST_S = 0.5
SIZE = 1_000_000
OK = http.client.OK


def text(number: int) -> str:
    """Return a text whose length and last line are its number's: a part of it is seen to be one."""
    start, end = "format: arcless-line/1\nname: a\n", f"# end of {number}\n"
    return start + f"# {number}\n" * ((SIZE + number) // len(f"# {number}\n")) + end


def is_whole(content: str) -> bool:
    number = content.rpartition("# end of ")[2].strip()
    return number.isdigit() and content == text(int(number))


def save_on(server: Server, file: Path) -> None:
    """Save one text after the other until the server is gone."""
    number = 0
    with suppress(OSError, http.client.HTTPException):
        while True:
            number += 1
            version = hashlib.sha256(file.read_bytes()).hexdigest()
            asked: dict[str, Any] = {"path": "a.yaml", "text": text(number), "version": version}
            assert server.ask("PUT", "/api/file", asked).status == OK


def kill_while_saving(folder: Path, place: Path, seed: int) -> None:
    file = folder / "a.yaml"
    file.write_text(text(0), "utf-8")
    with Server(folder, place) as server:
        saver = threading.Thread(target=save_on, args=(server, file))
        saver.start()
        time.sleep(random.Random(seed).uniform(0.05, LONGEST_S))
        server.process.send_signal(signal.SIGKILL)
        saver.join(30.0)
        assert not saver.is_alive()
    assert is_whole(file.read_text("utf-8"))
    left = [path.name for path in folder.iterdir() if path != file]
    assert all(name.startswith(PREFIX) for name in left), left


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    found = tmp_path / "project"
    found.mkdir()
    return found


def test_killed_while_saving(folder: Path, tmp_path: Path) -> None:
    for seed in range(FEW):
        kill_while_saving(folder, tmp_path, seed)
    (folder / "a.yaml").write_text(text(0), "utf-8")
    with Server(folder, tmp_path) as server:  # the next one that saves removes what was left
        version = hashlib.sha256(text(0).encode()).hexdigest()
        asked = {"path": "a.yaml", "text": text(1), "version": version}
        assert server.ask("PUT", "/api/file", asked).status == OK
    assert [path.name for path in folder.iterdir()] == ["a.yaml"]


@pytest.mark.evidence
def test_killed_many_times_while_saving(folder: Path, tmp_path: Path) -> None:
    for seed in range(MANY):
        kill_while_saving(folder, tmp_path, seed)


def test_killed_while_a_measured_run_arrives(folder: Path, tmp_path: Path) -> None:
    with Server(folder, tmp_path) as server, server.connect() as connection:
        head = server.head("POST /api/measured?name=a.csv HTTP/1.1", "Content-Length: 10000000")
        connection.sendall(head + b"time;force\n" * 10_000)
        assert waited(lambda: any((folder / "measured").glob(f"{PREFIX}*")))
        server.process.send_signal(signal.SIGKILL)
        server.process.wait()
    seen = [path.name for path in (folder / "measured").iterdir()]
    assert seen
    assert all(name.startswith(PREFIX) for name in seen)


@pytest.fixture
def stopped(folder: Path, tmp_path: Path) -> Iterator[Server]:
    (folder / "a.yaml").write_text(text(0), "utf-8")
    with Server(folder, tmp_path) as server:
        yield server


def test_stopped_and_going_again(stopped: Server, folder: Path) -> None:
    """Questions of the time in which it was stopped are answered; a change meanwhile is seen."""
    stopped.answers_within()
    stopped.process.send_signal(signal.SIGSTOP)
    answers = list[int]()
    asking = [
        threading.Thread(target=lambda: answers.append(stopped.ask("GET", "/api/project").status))
        for _ in range(4)
    ]
    for one in asking:
        one.start()
    (folder / "b.yaml").write_text("format: arcless-line/1\nname: b\n", "utf-8")
    time.sleep(2.0)
    assert answers == []
    stopped.process.send_signal(signal.SIGCONT)
    for one in asking:
        one.join(30.0)
    assert answers == 4 * [OK]

    def is_seen() -> bool:
        models = stopped.ask("GET", "/api/project").json()["models"]
        return "b.yaml" in [one["path"] for one in models]

    assert waited(is_seen)
    assert stopped.process.poll() is None
    assert os.path.lexists(folder / "a.yaml")


def waited(condition: Any, longest_s: float = 20.0) -> bool:
    """Return whether something comes to be true within a time in s."""
    end = time.monotonic() + longest_s
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True
