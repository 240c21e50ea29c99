"""SIGTERM and SIGHUP, of batch systems and closed terminals: they clean up as Ctrl-C does."""

import os
import pty
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.drills.conftest import NEW, OLD, RUN, Stop, check_whole, leftovers
from tests.drills.test_interrupt import ENDLESS, start
from tests.drills.test_long_run import LONG
from tests.support.signals import compute, interruptible, stops_soon
from tests.support.stopped import End, Job

Place = Callable[[str], Path]
FEW = [*RUN, "--no-report"]
# What a shell says of a program that a signal ended: 128 and its number.
WAYS = {
    "terminate": (signal.SIGTERM, 143, "terminated\n"),
    "hang up": (signal.SIGHUP, 129, "hung up\n"),
}


def check_stopped(end: End, folder: Path, kind: str, how: str) -> bool:
    """See that a run was stopped and left the older files, or was done and put its own there."""
    assert "Traceback" not in end.err, end
    assert leftovers(folder) == []
    told = check_whole(folder / "out")
    _, code, word = WAYS[how]
    if (end.code, end.out, end.err) == (code, "", word):
        assert told in (OLD if kind == "older" else None, NEW)
        return True
    # It came too late, or before there was anybody to answer.
    assert end.code in (0, 3) or (end.code, told) == (-WAYS[how][0], None), end
    return False


@pytest.mark.evidence
@pytest.mark.parametrize("how", ["terminate", "hang up"])
def test_at_every_operation_beside_an_older_run(stop: Stop, place: Place, how: str) -> None:
    for stopped in range(100):
        folder = place("older")
        end = stop(Job(FEW, str(folder), how, operation=stopped + 1))
        check_stopped(end, folder, "older", how)
        if end.operations <= stopped:
            assert stopped > 8
            return
    raise AssertionError("it never comes to an end")


def test_while_results_stream_to_the_disk(stop: Stop, place: Place) -> None:
    # By what was written, not by the clock: a slow machine is stopped at the same places.
    # The record grows to 7 MB; its first 8 kB stand there through a third of the run.
    for number, size in enumerate((1, 8_000, 200_000, 2_000_000)):
        folder, how = place("fresh"), list(WAYS)[number % 2]
        end = stop(Job(LONG, str(folder), how, size=size))
        stopped = check_stopped(end, folder, "fresh", how)
        assert stopped or size > 8_000, end


@pytest.mark.parametrize(
    ("kind", "how"),
    [
        *((kind, "terminate") for kind in ENDLESS),
        ("stepping", "hang up"),
        *(
            pytest.param(kind, "hang up", marks=pytest.mark.evidence)
            for kind in ENDLESS
            if kind != "stepping"
        ),
    ],
)
def test_in_native_code(tmp_path: Path, kind: str, how: str) -> None:
    number, code, word = WAYS[how]
    words = ENDLESS[kind] + ([] if kind == "validate" else ["--out", "out"])
    with interruptible():
        running = start(words, tmp_path)
    compute(running)
    with stops_soon(running):
        running.send_signal(number)
        out, err = running.communicate(timeout=60)
    assert (running.returncode, out, err) == (code, "", word)
    assert list(tmp_path.iterdir()) == []


def test_a_closed_terminal(tmp_path: Path) -> None:
    """The word that ends it has nowhere to go."""
    ours, theirs = pty.openpty()
    with interruptible():
        running = subprocess.Popen(
            [sys.executable, "-m", "arcless", *ENDLESS["stepping"], "--out", "out"],
            cwd=tmp_path,
            stdin=theirs,
            stdout=theirs,
            stderr=theirs,
            start_new_session=True,
        )
    os.close(theirs)
    compute(running)
    # Halted, so that it writes nothing between the two: a busy machine is slow to send the signal.
    running.send_signal(signal.SIGSTOP)
    os.close(ours)
    running.send_signal(signal.SIGHUP)
    running.send_signal(signal.SIGCONT)
    assert running.wait(timeout=60) == 129
    assert list(tmp_path.iterdir()) == []


def test_nohup_goes_on(tmp_path: Path) -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        running = start(["schema"], tmp_path)
        os.kill(running.pid, signal.SIGHUP)
        _, err = running.communicate(timeout=60)
    finally:
        signal.signal(signal.SIGHUP, before)
    assert (running.returncode, err) == (0, "")
