"""Memory that a process has used at most, also where nothing tells it."""

import sys
from pathlib import Path

import pytest

from arcless.platforms.memory import most_memory

MIB = 2**20


def test_memory_of_the_status(tmp_path: Path) -> None:
    status = tmp_path / "status"
    status.write_text("Name:\tpython\nVmHWM:\t  2048 kB\nVmRSS:\t 1024 kB\n", "ascii")
    assert most_memory(status) == 2 * MIB


def test_memory_where_there_is_no_status(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")
    found = most_memory(tmp_path / "none")
    unit = 1 if sys.platform == "darwin" else 1024
    assert found is not None
    # No interpreter is smaller, and the peak only grows.
    assert MIB < found <= unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def test_memory_that_nothing_tells(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "resource", None)
    assert most_memory(tmp_path / "none") is None
