"""Processes that signals reach in the middle of their work."""

import os
import resource
import signal
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def interruptible() -> Iterator[None]:
    """Let processes started within answer Ctrl-C, SIGTERM and SIGHUP.

    A shell that runs the tests in the background, or `nohup`, tells them to ignore one of them, and
    every process inherits that. What this process handles itself, its children start with anew.
    """
    numbers = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
    before = [signal.signal(number, signal.default_int_handler) for number in numbers]
    try:
        yield
    finally:
        for number, handler in zip(numbers, before, strict=True):
            signal.signal(number, handler)


# Processor time that a process has used when it computes, s: imports take 0.4 to 0.7.
PAST_IMPORTS_S = 1.5


def compute(running: subprocess.Popen[str] | subprocess.Popen[bytes]) -> None:
    """Wait until a process computes: by its processor time, which other work does not change."""
    while _used(running.pid) < PAST_IMPORTS_S:
        assert running.poll() is None, running.communicate()
        time.sleep(0.02)


# Processor time of all cores within which a process that is to end has ended, s: the promise is one
# second, and the clock of the wall is that of whatever else runs here.
STOPS_WITHIN_S = 1.0 * (os.cpu_count() or 1)


@contextmanager
def stops_soon(running: subprocess.Popen[str]) -> Iterator[None]:
    """See that a process, signalled and waited for in the block, computes no longer than that."""
    before = _of_children()
    used = _used(running.pid)
    yield
    assert running.poll() is not None
    assert _of_children() - before - used < STOPS_WITHIN_S


def _of_children() -> float:
    """Return the processor time of all processes that were waited for, s."""
    found = resource.getrusage(resource.RUSAGE_CHILDREN)
    return found.ru_utime + found.ru_stime


def _used(pid: int) -> float:
    """Return the processor time of a process and its threads, s."""
    fields = Path(f"/proc/{pid}/stat").read_text("ascii").rpartition(")")[2].split()
    return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK")
