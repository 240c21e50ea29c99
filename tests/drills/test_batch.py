"""A batch that is killed or interrupted: finished members stay, the rest is unchanged."""

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import arcless
from tests.drills.batches import SPEEDS, members
from tests.drills.conftest import ROOT, leftovers
from tests.support.signals import interruptible, stops_soon

TIMES = ("setup_time_s", "wall_time_s", "real_time_factor")
# A process of its own begins with imports; nobody is that slow.
LONGEST_WAIT_S = 60.0


def started(folder: Path, *words: str) -> subprocess.Popen[str]:
    with interruptible():
        return subprocess.Popen(
            [sys.executable, "-m", "tests.drills.batches", str(folder), *words],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )


def done(folder: Path) -> list[Path]:
    return sorted(folder.glob("*/*.json"))


def wait_for(folder: Path, count: int, running: subprocess.Popen[str]) -> None:
    deadline = time.monotonic() + LONGEST_WAIT_S
    while len(done(folder)) < count:
        assert running.poll() is None, running.communicate()
        assert time.monotonic() < deadline
        time.sleep(0.002)


def stored(folder: Path) -> dict[str, Any]:
    """Return what the files hold, without what the clock says."""
    found = {}
    for path in done(folder):
        assessment = json.loads(path.read_text())["assessment"]
        found[path.name] = {key: assessment[key] for key in assessment if key not in TIMES}
    return found


def test_a_killed_batch_goes_on_to_the_same_end(tmp_path: Path) -> None:
    whole, killed = tmp_path / "whole", tmp_path / "killed"
    arcless.batch(members(), folder=whole)
    for count in (2, 6):
        running = started(killed)
        wait_for(killed, count, running)
        running.send_signal(signal.SIGKILL)
        running.communicate()
        assert set(stored(killed)) <= set(stored(whole)), "what has its name is whole"
    before = len(done(killed))
    outcomes = arcless.batch(members(), folder=killed)
    assert sum(outcome.was_there for outcome in outcomes) == before < len(SPEEDS)
    assert stored(killed) == stored(whole)
    assert (killed / "members.csv").read_text() == (whole / "members.csv").read_text()


def test_ctrl_c_ends_a_batch_within_a_second(tmp_path: Path) -> None:
    running = started(tmp_path / "out", "endless")
    assert running.stdout is not None
    assert running.stdout.readline() == "begun\n"
    time.sleep(1.0)  # past the imports of the run, in native code
    with stops_soon(running):
        running.send_signal(signal.SIGINT)
        _, err = running.communicate(timeout=LONGEST_WAIT_S)
    assert running.returncode != 0
    assert err.rstrip().endswith("KeyboardInterrupt")
    assert leftovers(tmp_path) == []
    assert done(tmp_path / "out") == []
