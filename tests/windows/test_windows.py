"""Ways of Arcless that are its own on Windows: run there, or under wine by `make windows`.

On other systems these tests are skipped; `tests/unit/platforms` has what can be tried anywhere.
"""

import json
import os
import signal
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import OutputError
from arcless.platforms.memory import most_memory
from arcless.platforms.moving import move
from arcless.platforms.positioned import read_at
from arcless.platforms.shared_files import new_file
from arcless.storage.lock import Lock, is_held
from arcless.storage.whole_files import write_bytes
from arcless.studio.processes.ends import Cancelled, Gone
from arcless.studio.processes.worker import Worker
from arcless.studio.project import opening
from arcless.studio.project.project import Project
from tests.support import studio_tasks as tasks

pytestmark = pytest.mark.skipif(sys.platform != "win32", reason="this is not Windows")
PATIENCE_S = 120.0
SCENARIO = "en50318-ac-simple-320-planar"


@pytest.fixture
def worker() -> Iterator[Worker]:
    found = Worker()
    yield found
    found.leave(0.0)
    found.process.wait(PATIENCE_S)


def test_a_worker_does_tasks_and_hears_orders(worker: Worker) -> None:
    said: list[Any] = []
    end = worker.do(tasks.echo, heard=said.append)
    for number in range(200):
        worker.tell(number)
    worker.tell("end")
    assert end.result(PATIENCE_S) == 200
    assert said == list(range(200))
    assert worker.do(tasks.process).result(PATIENCE_S) == worker.process.pid != os.getpid()
    assert worker.used > 1_000_000


def test_a_worker_is_cancelled_and_leaves(worker: Worker) -> None:
    said: list[Any] = []
    end = worker.do(tasks.wait, heard=said.append)
    while not said:
        time.sleep(0.01)
    worker.cancel(PATIENCE_S)
    assert isinstance(end.exception(PATIENCE_S), Cancelled)
    deaf = worker.do(tasks.deaf, heard=said.append)
    worker.leave(0.3)
    assert isinstance(deaf.exception(PATIENCE_S), Cancelled)
    assert worker.process.wait(PATIENCE_S) != 0


def test_a_worker_that_ends_says_its_code(worker: Worker) -> None:
    error = worker.do(tasks.leave, 7).exception(PATIENCE_S)
    assert isinstance(error, Gone)
    assert "it ended with code 7" in str(error)


def test_rows_of_a_worker_are_read_while_it_writes(worker: Worker) -> None:
    with new_file() as file:
        worker.do(tasks.move, 100, False, spool=file).result(PATIENCE_S)
        size = tasks.LAYOUT.type.itemsize
        rows = [read_at(file.fileno(), size, number * size) for number in (0, 50, 99)]
        name = file.name
    times = [struct.unpack("<d", row[:8])[0] for row in rows]
    assert times == pytest.approx([0.0, 50 * tasks.EVERY_S, 99 * tasks.EVERY_S])
    assert not Path(name).exists()


def test_a_lock_is_gone_with_its_holder(tmp_path: Path) -> None:
    file = tmp_path / "a b%#.lock"
    code = (
        "import sys, pathlib; from arcless.storage.lock import Lock\n"
        "print(Lock(pathlib.Path(sys.argv[1])).take(), flush=True); sys.stdin.read()\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code, str(file)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline().strip() == b"True"
        assert is_held(file)
        assert not Lock(file).take()
        holder.kill()
    assert not is_held(file)
    assert Lock(file).take()


def test_a_file_that_is_open_is_not_replaced(tmp_path: Path) -> None:
    target = tmp_path / "table.csv"
    write_bytes(target, b"one")
    with target.open("rb"):  # as Excel has it
        with pytest.raises(OutputError, match="the file cannot be written"):
            write_bytes(target, b"two")
        (tmp_path / "other").write_bytes(b"two")
        with pytest.raises(PermissionError):
            move(tmp_path / "other", target, 0.1)
    assert target.read_bytes() == b"one"
    write_bytes(target, b"two")
    assert target.read_bytes() == b"two"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["other", "table.csv"]


def test_a_project_opens_its_files_and_no_device(tmp_path: Path) -> None:
    (tmp_path / "Lines").mkdir()
    (tmp_path / "Lines" / "a.yaml").write_bytes(b"a line")
    project = Project.of(tmp_path)
    for path in ("Lines/a.yaml", "lines/A.YAML"):  # the same file
        assert opening.read_bytes(project, project.inside(path), path) == b"a line"
    for path in ("nul.yaml", "con", "Lines/a.yaml:s", "C:/Windows/win.ini", "a.yaml.", "..\\x"):
        with pytest.raises(OutputError, match="no file of this folder"):
            project.inside(path)


def test_memory_is_told() -> None:
    used = most_memory()
    assert used is not None
    assert 1_000_000 < used < 8_000_000_000


def test_ending_signals_are_those_of_windows() -> None:
    from arcless.platforms.signals import ENDING, WORDS, started_without_ctrl_c

    assert [signal.Signals(number).name for number in ENDING] == ["SIGTERM", "SIGBREAK"]
    assert set(WORDS) == set(ENDING)
    with started_without_ctrl_c():
        pass


def arcless_in(folder: Path, *words: str) -> "subprocess.CompletedProcess[bytes]":
    return subprocess.run(
        [sys.executable, "-m", "arcless", *words], cwd=folder, capture_output=True, check=False,
        stdin=subprocess.DEVNULL,
    )  # fmt: skip


def test_commands(tmp_path: Path) -> None:
    done = arcless_in(tmp_path, "run", SCENARIO, "--out", "run", "--until", "300 m")
    assert done.returncode in (0, 3), done.stderr
    told = json.loads(arcless_in(tmp_path, "statics", SCENARIO, "--json").stdout.decode("utf-8"))
    assert told["droppers"]
    assert arcless_in(tmp_path, "new", "mine", "--from", "norway-s25-250").returncode == 0
    assert b"\r" not in (tmp_path / "mine.yaml").read_bytes()
    assert arcless_in(tmp_path, "check", "mine.yaml").returncode == 0
    done = arcless_in(tmp_path, "new", "nul", "--from", "norway-s25-250")
    assert (done.returncode, b"device on Windows" in done.stderr) == (2, True)
    done = arcless_in(tmp_path, "export", "run", "--to", "values.csv")
    assert done.returncode == 0, done.stderr
    shown = arcless_in(tmp_path, "show", "china-stitched-350").stdout  # a pipe has UTF-8
    assert any(letter > "\x7f" for letter in shown.decode("utf-8"))


def test_numbers_are_those_of_linux(tmp_path: Path) -> None:
    """The contact force of a run, put down on Linux by `cross.windows`."""
    place = os.environ.get("ARCLESS_FORCES_OF_LINUX")
    if place is None:
        pytest.skip("no forces of Linux to compare with: `make windows` puts them down")
    numpy = pytest.importorskip("numpy")
    expected = numpy.load(place)
    found = arcless.run(arcless.load(SCENARIO)).dataset["contact_force"].values
    # Libraries of the systems differ in the last bit of exp, pow and hypot.
    assert numpy.abs(found - expected).max() <= 1e-6
    print("equal bits:", bool((found == expected).all()))  # noqa: T201
