"""Priority, locked memory and processors: given, or refused with what to ask for."""

import ctypes
import os
import subprocess
import sys
from types import SimpleNamespace
from typing import Any

import pytest

from arcless.errors import MachineError
from arcless.platforms import real_time

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="calls of Linux")


def refuse(*_: Any) -> None:
    raise PermissionError(1, "Operation not permitted")


def test_priority_that_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "sched_setscheduler", refuse)
    with pytest.raises(
        MachineError, match=r"no real-time priority: got Operation not permitted"
    ) as e:
        real_time.ask_priority(10)
    assert "USER - rtprio 10" in str(e.value)


def test_priority_that_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[int, int, int]] = []
    monkeypatch.setattr(
        os,
        "sched_setscheduler",
        lambda who, how, what: asked.append((who, how, what.sched_priority)),
    )
    assert real_time.ask_priority() == "SCHED_FIFO 49"
    assert asked == [(0, os.SCHED_FIFO, 49)]


def test_memory_that_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []

    def mlockall(flags: int) -> int:
        asked.append(flags)
        ctypes.set_errno(12)
        return -1

    monkeypatch.setattr(ctypes, "CDLL", lambda *_, **__: SimpleNamespace(mlockall=mlockall))
    with pytest.raises(MachineError, match="no locked memory: got Cannot allocate memory") as e:
        real_time.lock_memory()
    assert "memlock unlimited" in str(e.value)
    assert asked == [3]


def test_memory_is_locked_or_refused_in_a_process_of_its_own() -> None:
    """The kernel says how much is locked: all of it, or nothing where it is not permitted."""
    code = (
        "from arcless.errors import MachineError; from arcless.platforms import real_time\n"
        "try: real_time.lock_memory()\n"
        "except MachineError as error: print('refused', error)\n"
        "else: print(open('/proc/self/status').read())\n"
    )
    said = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    if not said.stdout.startswith("refused"):
        (line,) = (one for one in said.stdout.splitlines() if one.startswith("VmLck"))
        assert int(line.split()[1]) > 1000  # kB; an interpreter has more


def test_a_processor_of_its_own() -> None:
    code = (
        "import os; from arcless.platforms import real_time\n"
        "one = max(os.sched_getaffinity(0)); print(real_time.stay_on(one)); "
        "print(os.sched_getaffinity(0) == {one})\n"
    )
    said = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert said.stdout.splitlines()[1] == "True"


@pytest.mark.parametrize("number", [9999, 10**30])
def test_a_processor_that_is_not_there(number: int) -> None:
    with pytest.raises(MachineError, match=rf"got number {number}, expected one of 0"):
        real_time.stay_on(number)


@pytest.mark.parametrize("ask", [real_time.ask_priority, real_time.lock_memory])
def test_a_system_without_it(ask: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(real_time, "sys", SimpleNamespace(platform="darwin"))
    with pytest.raises(MachineError, match="expected Linux"):
        ask()
