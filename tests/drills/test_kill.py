"""kill -9 while a run writes: what has its name is whole, and the next run cleans up."""

import random
from collections.abc import Callable
from pathlib import Path

import pytest

import arcless
from arcless.storage import hidden_files
from tests.drills.conftest import NEW, OLD, RUN, Stop, check_whole, leftovers, names
from tests.support.stopped import Job

Place = Callable[[str], Path]
FEW = [*RUN, "--no-report"]
KILLED = -9


def kill_everywhere(stop: Stop, place: Place, kind: str, words: list[str]) -> list[str | None]:
    """Kill before each file operation in turn; return what speed the files told of then."""
    told: list[str | None] = []
    while True:
        folder = place(kind)
        end = stop(Job(words, str(folder), "kill", operation=len(told) + 1))
        told.append(check_whole(folder / "out"))
        if end.code != KILLED:
            assert end.code in (0, 3), end
            return told
        hidden = leftovers(folder)
        # Whatever is not under its final name says by its own that it is unfinished.
        assert all(path.startswith("out/.arcless-unfinished-") for path in hidden), hidden


@pytest.mark.evidence
def test_at_every_operation_of_a_first_run(stop: Stop, place: Place) -> None:
    told = kill_everywhere(stop, place, "fresh", FEW)
    assert len(told) > 8
    assert told[0] is None
    assert told[-1] == NEW


def test_at_every_operation_beside_an_older_run(stop: Stop, place: Place) -> None:
    told = kill_everywhere(stop, place, "older", FEW)
    assert len(told) > 8
    # Never nothing, never both: the older run until the moment when the new one takes its place,
    # its report included, of which the new run makes none.
    assert told == sorted(told)
    assert set(told) == {OLD, NEW}


@pytest.mark.evidence
@pytest.mark.parametrize("kind", ["fresh", "older"])
def test_at_every_operation_with_report(stop: Stop, place: Place, kind: str) -> None:
    assert len(kill_everywhere(stop, place, kind, RUN)) > 10


def kill_at_random(stop: Stop, place: Place, count: int, words: list[str], longest_s: float) -> int:
    """Kill at random moments; return how often the run was still going on."""
    moments = random.Random(count)
    killed = 0
    for _ in range(count):
        folder = place("older")
        end = stop(Job(words, str(folder), "kill", moment_s=moments.uniform(0.02, longest_s)))
        killed += end.code == KILLED
        assert check_whole(folder / "out") in (OLD, NEW)
    return killed


@pytest.mark.evidence
def test_at_random_moments(stop: Stop, place: Place) -> None:
    assert kill_at_random(stop, place, 12, FEW, longest_s=0.5) > 0


@pytest.mark.evidence
def test_at_many_random_moments(stop: Stop, place: Place) -> None:
    assert kill_at_random(stop, place, 60, RUN, longest_s=0.6) > 20


def test_the_next_run_works_and_removes_what_was_left(stop: Stop, place: Place) -> None:
    folder = place("fresh")
    for operation in (4, 7):
        assert stop(Job(FEW, str(folder), "kill", operation)).code == KILLED
    assert leftovers(folder)
    assert stop(Job(FEW, str(folder), "never")).code in (0, 3)
    assert leftovers(folder) == []
    assert names(folder / "out") == ["assessment.json", "result.nc"]
    assert check_whole(folder / "out") == NEW


def test_a_run_that_stopped_early_can_still_go_on(stop: Stop, place: Place) -> None:
    folder = place("fresh")
    assert stop(Job([*FEW, "--until", "120 m"], str(folder), "never")).code == 0
    go_on = ["resume", "out/result.nc", "--no-report", "--quiet"]
    for operation in (2, 5):  # in its own folder: the new result replaces the state it came from
        assert stop(Job(go_on, str(folder), "kill", operation)).code == KILLED
        assert not arcless.open(folder / "out/result.nc").is_complete
    assert stop(Job(go_on, str(folder), "never")).code in (0, 3)
    assert leftovers(folder) == []
    assert arcless.open(folder / "out/result.nc").is_complete
    assert check_whole(folder / "out") == NEW


def test_a_file_of_one_name_is_swept_too(stop: Stop, place: Place) -> None:
    folder = place("older")
    again = ["assess", "out/result.nc", "--out", "out/again.json", "--quiet"]
    assert stop(Job(again, str(folder), "kill", operation=4)).code == KILLED
    assert len(leftovers(folder)) == 2  # a hidden file, and its lock
    assert "again.json" not in names(folder / "out")
    assert stop(Job(again, str(folder), "never")).code in (0, 3)
    assert leftovers(folder) == []


def test_a_writer_at_work_is_not_swept(stop: Stop, place: Place) -> None:
    folder = place("older") / "out"
    hidden = folder / hidden_files.new_name()
    with hidden_files.claimed(hidden):
        hidden.write_bytes(b"not yet")
        assert stop(Job(FEW, str(folder.parent), "never")).code in (0, 3)
        assert hidden.read_bytes() == b"not yet"
        assert sorted(folder.glob(".*")) == [hidden, folder / f"{hidden.name}.lock"]
