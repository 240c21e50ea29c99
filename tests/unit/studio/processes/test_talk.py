"""Progress of a function in a worker, as the server is told of it."""

from multiprocessing import Pipe
from types import SimpleNamespace
from typing import Any

import pytest

from arcless.studio.processes import talk
from arcless.studio.processes.talk import Talk


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return a clock that stands: the time in s that is put into the list."""
    now = [0.0]
    # The clock of this module alone: pipes wait by that of the process.
    monkeypatch.setattr(talk, "time", SimpleNamespace(monotonic=lambda: now[0]))
    return now


def test_another_phase_is_told_at_once_and_the_same_one_now_and_then(clock: list[float]) -> None:
    here, there = Pipe()
    one = Talk(here)
    one.progress(0.0, "finding the line at rest")
    one.progress(0.0, "stepping, 0.0 of 8.0 s")
    one.progress(0.1, "stepping, 0.8 of 8.0 s")  # too soon
    clock[0] = 1.0
    one.progress(0.2, "stepping, 1.6 of 8.0 s")
    one.progress(1.0, "assessing")
    told: list[Any] = []
    while there.poll():
        told.append(there.recv()[1][1:])
    assert told == [
        (0.0, "finding the line at rest"),
        (0.0, "stepping, 0.0 of 8.0 s"),
        (0.2, "stepping, 1.6 of 8.0 s"),
        (1.0, "assessing"),
    ]
