"""A long run, which writes its record while it steps: stopped anywhere, it leaves nothing."""

import random
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.drills.conftest import NEW, OLD, RUN, Stop, check_whole, leftovers
from tests.drills.test_full_disk import check_refused
from tests.support.stopped import Job

Place = Callable[[str], Path]
# 102 000 steps: the least that makes a run a long one. Some seconds.
LONG = ["solver.time_step=0.033 ms" if "time_step" in word else word for word in RUN]
LONG += ["--no-report"]
KILLED = -9


def test_it_is_a_long_one_and_ends_well(stop: Stop, place: Place) -> None:
    folder = place("older")
    end = stop(Job(LONG, str(folder), "never"))
    assert end.code in (0, 3), end
    assert check_whole(folder / "out") == NEW
    assert leftovers(folder) == []


@pytest.mark.parametrize("moment", [0.6, 1.2])
def test_killed_while_it_writes(stop: Stop, place: Place, moment: float) -> None:
    folder = place("older")
    end = stop(Job(LONG, str(folder), "kill", moment_s=moment))
    if end.code == KILLED:
        assert check_whole(folder / "out") == OLD
        assert all(path.startswith("out/.arcless-unfinished-") for path in leftovers(folder))
    else:  # it came too late
        assert check_whole(folder / "out") == NEW


@pytest.mark.parametrize("operation", [2, 3, 4])
@pytest.mark.parametrize("how", ["kill", "interrupt"])
def test_at_the_operations_on_its_record(
    stop: Stop, place: Place, how: str, operation: int
) -> None:
    folder = place("older")
    end = stop(Job(LONG, str(folder), how, operation=operation))
    assert end.code == (KILLED if how == "kill" else 1), end
    assert check_whole(folder / "out") == OLD
    if how == "interrupt":
        assert (end.out, end.err) == ("", "interrupted\n")
        assert leftovers(folder) == []


def test_on_a_disk_that_fills_up(stop: Stop, small_disk: Callable[[int], Path]) -> None:
    disk = small_disk(1000)
    check_refused(stop(Job(LONG, str(disk), "never")), disk)
    assert list(disk.iterdir()) == []


@pytest.mark.evidence
@pytest.mark.parametrize("kind", ["fresh", "older"])
def test_interrupted_at_many_random_moments(stop: Stop, place: Place, kind: str) -> None:
    moments = random.Random(7)
    stopped = 0
    for _ in range(15):
        folder = place(kind)
        end = stop(Job(LONG, str(folder), "interrupt", moment_s=moments.uniform(0.05, 4.0)))
        assert "Traceback" not in end.err, end
        assert leftovers(folder) == []
        told = check_whole(folder / "out")
        assert told in ((OLD if kind == "older" else None), NEW)
        stopped += end.err == "interrupted\n"
    assert stopped > 3
