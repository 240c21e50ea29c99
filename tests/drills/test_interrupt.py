"""Ctrl-C wherever a user may press it: one word, exit code 1, and nothing half-written."""

import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.drills.conftest import NEW, OLD, RUN, SHORT, Stop, check_whole, leftovers
from tests.support.signals import compute, interruptible, stops_soon
from tests.support.stopped import End, Job

Place = Callable[[str], Path]
FEW = [*RUN, "--no-report"]
STOPPED = (1, "", "interrupted\n")
# Computing that no machine finishes while a test waits: native code in both.
ENDLESS = {
    "stepping": ["run", str(SHORT), "--set", "solver.time_step=0.01 ms"],
    "statics": ["statics", str(SHORT), "--set", "line.spans=[{type: span, count: 200}]"],
    "validate": ["validate", "--quiet"],
    "repeats": [
        *("run", str(SHORT), "--certainty", "100", "--quiet"),
        *("--set", "solver.time_step=0.5 ms", "--set", "travel={start: 60 m, end: 340 m}"),
        *("--set", "analysis={from: 160 m, to: 310 m}"),
    ],
}


def check_stopped(end: End, folder: Path, kind: str) -> None:
    """See that a run was stopped and left the older files, or was done and put its own there."""
    assert "Traceback" not in end.err, end
    assert leftovers(folder) == []
    told = check_whole(folder / "out")
    if (end.code, end.out, end.err) == STOPPED:
        assert told in (OLD if kind == "older" else None, NEW)
        assert (folder / "out").exists() == (told is not None)
    else:  # it came too late
        assert end.code in (0, 3)
        assert told == NEW


def interrupt_everywhere(stop: Stop, place: Place, kind: str, words: list[str]) -> int:
    """Interrupt at each file operation in turn, the cleaning up included; return their number."""
    for stopped in range(100):
        folder = place(kind)
        end = stop(Job(words, str(folder), "interrupt", operation=stopped + 1))
        check_stopped(end, folder, kind)
        if end.operations <= stopped:
            return stopped
    raise AssertionError("it never comes to an end")


@pytest.mark.evidence
def test_at_every_operation_beside_an_older_run(stop: Stop, place: Place) -> None:
    assert interrupt_everywhere(stop, place, "older", FEW) > 8


@pytest.mark.evidence
@pytest.mark.parametrize("kind", ["fresh", "older"])
def test_at_every_operation_with_report(stop: Stop, place: Place, kind: str) -> None:
    assert interrupt_everywhere(stop, place, kind, RUN) > 10


def interrupt_at_random(stop: Stop, place: Place, count: int) -> int:
    """Interrupt at random moments of a run with report; return how often it was in time.

    Moments are those of a run on this machine: a quick one would be done before most of others.
    """
    moments = random.Random(count)
    began = time.monotonic()
    stop(Job(RUN, str(place("fresh")), "never"))
    longest_s = time.monotonic() - began
    stopped = 0
    for number in range(count):
        kind = ("fresh", "older")[number % 2]
        folder = place(kind)
        moment = moments.uniform(0.01, longest_s)
        end = stop(Job(RUN, str(folder), "interrupt", moment_s=moment))
        check_stopped(end, folder, kind)
        stopped += end.err == "interrupted\n"
    return stopped


def test_at_random_moments_of_run_report_and_writing(stop: Stop, place: Place) -> None:
    assert interrupt_at_random(stop, place, 6) > 0


@pytest.mark.evidence
def test_at_many_random_moments(stop: Stop, place: Place) -> None:
    assert interrupt_at_random(stop, place, 60) > 20


@pytest.mark.parametrize("operation", [1, 2, 3], ids=["reading", "writing", "renaming"])
def test_while_a_report_is_made_again(stop: Stop, place: Place, operation: int) -> None:
    folder, words = place("older"), ["report", "out/result.nc"]
    before = {path.name: path.read_bytes() for path in (folder / "out").iterdir()}
    end = stop(Job(words, str(folder), "interrupt", operation, reads=True))
    assert (end.code, end.out, end.err) == STOPPED
    assert leftovers(folder) == []
    assert {path.name: path.read_bytes() for path in (folder / "out").iterdir()} == before


def start(words: list[str], folder: Path) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "arcless", *words],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.mark.parametrize(
    ("kind", "strokes"),
    [
        *((kind, 1) for kind in ENDLESS),
        ("stepping", 3),
        *(pytest.param(k, 3, marks=pytest.mark.evidence) for k in ENDLESS if k != "stepping"),
    ],
)
def test_in_native_code(tmp_path: Path, kind: str, strokes: int) -> None:
    words = ENDLESS[kind] + ([] if kind == "validate" else ["--out", "out"])
    with interruptible():
        running = start(words, tmp_path)
    compute(running)  # earlier moments have their own drills
    with stops_soon(running):
        for _ in range(strokes):
            running.send_signal(signal.SIGINT)
            time.sleep(0.02)
        out, err = running.communicate(timeout=60)
    assert (running.returncode, out, err) == STOPPED
    assert list(tmp_path.iterdir()) == []


def test_drills_hold_where_the_tests_themselves_ignore_it(tmp_path: Path) -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        test_in_native_code(tmp_path, "stepping", 1)
        ignoring = start(["schema"], tmp_path)  # as under `nohup`: goes on to its end
        os.kill(ignoring.pid, signal.SIGINT)
        out, err = ignoring.communicate(timeout=60)
    finally:
        signal.signal(signal.SIGINT, before)
    assert (ignoring.returncode, err) == (0, "")
    assert out.startswith("{")
