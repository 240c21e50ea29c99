"""Runs of the studio: the server killed or stopped, a full disk; files whole or absent."""

import os
import shutil
import signal
import time
from collections.abc import Callable
from http.client import OK
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.model import parse_override
from tests.drills.conftest import QUICK, SHORT, leftovers
from tests.support.studio_server import Server, is_there

CHANGES = dict(parse_override(f"{field}={text}") for field, text in QUICK.items())
# A run of some ten seconds, so that something happens in its midst.
SLOW = {**CHANGES, "solver.time_step": "0.01 ms"}
# Time in s that workers have to notice that the server is gone: the promise is 2 s.
ORPHANS_S = 2.0
LONGEST_S = 60.0


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    found = tmp_path / "project"
    found.mkdir()
    shutil.copy(SHORT, found / "short.yaml")
    return found


def begin(server: Server, changes: dict[str, Any], **more: Any) -> dict[str, Any]:
    asked = {"scenario": "short.yaml", "changes": changes, **more}
    answer = server.ask("POST", "/api/runs", asked)
    assert answer.status == OK, answer.body
    job: dict[str, Any] = answer.json()["job"]
    return job


def job_of(server: Server, name: str) -> dict[str, Any]:
    [job] = [one for one in server.ask("GET", "/api/jobs").json() if one["id"] == name]
    found: dict[str, Any] = job
    return found


def wait_for(server: Server, name: str, when: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    deadline = time.monotonic() + LONGEST_S
    while time.monotonic() < deadline:
        job = job_of(server, name)
        if when(job):
            return job
        time.sleep(0.02)
    raise AssertionError(job)


def has_ended(job: dict[str, Any]) -> bool:
    return job["state"] not in ("waiting", "running")


def workers(server: Server) -> list[int]:
    """Return the processes that the server has started."""
    children = Path(f"/proc/{server.process.pid}/task/{server.process.pid}/children")
    found = [int(number) for number in children.read_text().split()]
    # Threads start processes, too.
    for thread in Path(f"/proc/{server.process.pid}/task").iterdir():
        found += [int(number) for number in (thread / "children").read_text().split()]
    return sorted(set(found))


def test_the_server_is_killed_while_a_run_steps(folder: Path, tmp_path: Path) -> None:
    with Server(folder, tmp_path) as server:
        job = begin(server, SLOW)
        wait_for(
            server, job["id"], lambda one: one["doing"].startswith("stepping") or has_ended(one)
        )
        others = workers(server)
        assert others
        server.process.kill()
        server.process.wait()
        gone = time.monotonic()
        while any(map(is_there, others)) and time.monotonic() < gone + LONGEST_S:
            time.sleep(0.02)
        assert time.monotonic() - gone < ORPHANS_S
    place = folder / job["path"]
    assert not place.exists() or not [one for one in place.iterdir() if one.name[0] != "."]
    with Server(folder, tmp_path) as server:  # and the next one runs it, and sweeps
        again = begin(server, CHANGES)
        assert again["path"] == job["path"].replace("0.01_ms", "4_ms")
        assert wait_for(server, again["id"], has_ended)["state"] == "done"
    assert arcless.open(folder / again["path"]).is_complete


def test_a_killed_worker_is_a_failed_job(folder: Path, tmp_path: Path) -> None:
    with Server(folder, tmp_path) as server:
        job = begin(server, SLOW)
        wait_for(
            server, job["id"], lambda one: one["doing"].startswith("stepping") or has_ended(one)
        )
        for process in workers(server):
            os.kill(process, signal.SIGKILL)
        ended = wait_for(server, job["id"], has_ended)
        assert ended["state"] == "failed"
        assert "it was killed" in ended["error"]["text"]
        assert not (folder / job["path"]).exists()
        assert leftovers(folder) == []
        assert wait_for(server, begin(server, CHANGES)["id"], has_ended)["state"] == "done"


def test_a_full_disk_is_a_failed_job(small_disk: Callable[[int], Path], tmp_path: Path) -> None:
    folder = small_disk(100)  # KiB: room for the scenario, and for no result
    shutil.copy(SHORT, folder / "short.yaml")
    with Server(folder, tmp_path) as server:
        job = begin(server, CHANGES)
        ended = wait_for(server, job["id"], has_ended)
        assert ended["state"] == "failed"
        assert "No space left on device" in ended["error"]["text"]
        assert not (folder / job["path"]).exists()
        assert leftovers(folder) == []


def test_a_run_goes_on_while_the_server_is_stopped(folder: Path, tmp_path: Path) -> None:
    with Server(folder, tmp_path) as server:
        job = begin(server, {**CHANGES, "solver.time_step": "0.1 ms"})
        wait_for(server, job["id"], lambda one: bool(one["doing"]) or has_ended(one))
        server.process.send_signal(signal.SIGSTOP)
        result = folder / job["path"] / "result.nc"
        deadline = time.monotonic() + LONGEST_S
        while not result.exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        assert result.exists()
        server.process.send_signal(signal.SIGCONT)
        assert wait_for(server, job["id"], has_ended)["state"] == "done"
    assert arcless.open(folder / job["path"]).is_complete
