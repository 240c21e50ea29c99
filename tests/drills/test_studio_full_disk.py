"""A really full disk below the studio: refusals are sentences, and old files stay."""

import hashlib
import shutil
from collections.abc import Callable
from http.client import OK
from pathlib import Path
from typing import Any

import pytest

import arcless
from tests.drills.conftest import SHORT, leftovers
from tests.drills.test_studio_runs import CHANGES, begin, has_ended, wait_for
from tests.support.studio_server import Answer, Server

Disk = Callable[[int], Path]
FULL = "No space left on device"


def project(disk: Path) -> Path:
    """Make a project on a disk."""
    folder = disk / "project"
    folder.mkdir()
    shutil.copy(SHORT, folder / "short.yaml")
    return folder


def fill(disk: Path) -> Path:
    """Fill a disk to its last byte; return the file that does."""
    file = disk / "filling"
    with file.open("wb", buffering=0) as to, pytest.raises(OSError, match=FULL):
        while True:
            to.write(b"x" * 4096)
    return file


def save(server: Server, file: Path, text: str) -> Answer:
    version = hashlib.sha256(file.read_bytes()).hexdigest()
    return server.ask("PUT", "/api/file", {"path": file.name, "text": text, "version": version})


def check_refused(answer: Answer) -> None:
    assert answer.status != OK
    told: dict[str, Any] = answer.json()["error"]
    assert FULL in told["text"]
    assert ".arcless" not in told["text"]  # the user knows no hidden names
    assert "--" not in told["text"]  # and in the page there are no options


def test_files_are_refused_and_the_old_ones_stay(small_disk: Disk, tmp_path: Path) -> None:
    disk = small_disk(300)  # KiB
    folder = project(disk)
    file, long = folder / "short.yaml", SHORT.read_text("utf-8") + "# longer\n" * 1000
    measured = b"position,contact_force\n" + b"100.0,120.0\n" * 3000
    with Server(folder, tmp_path) as server:
        filling = fill(disk)
        before = file.read_bytes()
        check_refused(save(server, file, long))
        check_refused(server.ask("POST", "/api/measured?name=a.csv", measured))
        new = {"name": "b", "from": "shipped:scenario/praks-340", "with_pantographs": True}
        check_refused(server.ask("POST", "/api/new", new))
        asked = {"scenario": "short.yaml", "name": "c", "changes": {"speed": "150 km/h"}}
        check_refused(server.ask("POST", "/api/variant", asked))
        assert file.read_bytes() == before
        assert [one.name for one in folder.rglob("*") if one.is_file()] == ["short.yaml"]
        job = begin(server, CHANGES)
        ended = wait_for(server, job["id"], has_ended)
        assert ended["state"] == "failed"
        assert FULL in ended["error"]["text"]
        assert "--" not in ended["error"]["text"]
        assert leftovers(folder) == []
        filling.unlink()  # and with room it goes on
        assert save(server, file, long).status == OK
        assert server.ask("POST", "/api/measured?name=a.csv", measured).status == OK
    assert file.read_text("utf-8") == long
    assert (folder / "measured" / "a.csv").read_bytes() == measured


def test_a_run_is_whole_where_its_motion_has_no_room(
    small_disk: Disk, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TMPDIR", str(small_disk(64)))  # KiB: some rows of the motion
    folder = project(tmp_path)
    with Server(folder, tmp_path) as server:
        job = begin(server, CHANGES)
        ended = wait_for(server, job["id"], has_ended)
        assert ended["state"] == "done"
        assert any("disk of temporary files has no room" in note for note in ended["notes"])
    assert arcless.open(folder / job["path"]).is_complete
