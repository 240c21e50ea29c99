"""A study killed, interrupted, out of disk: going on gives the table of an uninterrupted one."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.drills.conftest import Stop, leftovers
from tests.drills.test_full_disk import LIMITED
from tests.support.stopped import End, Job
from tests.support.studies import VARIABLES, journal_of, rows, rows_in, written

KILLED = -9
# 2 × 10 variants, two of them invalid: half a second of two threads after the imports.
FORCES = {**VARIABLES["force"], "values": [-5, *range(60, 105, 5)]}
LONG = {"variables": {**VARIABLES, "force": FORCES}}
COUNT = 20
TABLE = "runs/studies/small/table.parquet"
JOURNAL = "runs/studies/small/journal.db"


def command(word: str) -> list[str]:
    return ["study", word, "small.yaml"]


def placed(folder: Path, **changes: Any) -> Path:
    folder.mkdir(exist_ok=True)
    written(folder, **changes)
    return folder


@pytest.fixture(scope="module")
def expected(stop: Stop, tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    """Return the rows of the longer study, computed in one go."""
    folder = placed(tmp_path_factory.mktemp("expected"), **LONG)
    end = stop(Job(command("run"), str(folder), "never"))
    assert end.code == 0, end
    found = rows(folder / TABLE)
    assert len(found) == COUNT
    return found


def check_kept(folder: Path, expected: list[dict[str, Any]]) -> int:
    """See that all that is there is right; return the number of rows in the journal."""
    if (folder / TABLE).exists():
        assert all(row in expected for row in rows(folder / TABLE))
    kept = list(journal_of(folder).rows())
    for row in kept:
        assert row.status == expected[row.variant - 1]["status"]
    hidden = leftovers(folder)
    assert all(".arcless-unfinished-" in path for path in hidden), hidden
    return len(kept)


def go_on(stop: Stop, folder: Path, expected: list[dict[str, Any]]) -> None:
    """Continue, or begin where nothing was begun, and see that all is there as it should be."""
    there = len(list(journal_of(folder).rows()))
    end = stop(Job(command("resume"), str(folder), "never"))
    if end.code == 2 and "no study was begun here" in end.err:
        assert there == 0
        end = stop(Job(command("run"), str(folder), "never"))
    assert end.code == 0, end
    assert f"computed {len(expected) - there}" in end.out, end
    assert rows(folder / TABLE) == expected
    assert leftovers(folder) == []


SLOW = pytest.mark.evidence
ALSO = [pytest.param(how, marks=SLOW) for how in ("full", "interrupt")]


@pytest.mark.parametrize("there", [pytest.param(1, marks=SLOW), 5, pytest.param(12, marks=SLOW)])
def test_killed_between_rows(
    stop: Stop, tmp_path: Path, expected: list[dict[str, Any]], there: int
) -> None:
    folder = placed(tmp_path, **LONG)
    end = stop(Job(command("run"), str(folder), "kill", rows=there, file=JOURNAL))
    assert end.code == KILLED
    # At once, or some rows later: no row that was in the journal is lost, and no more than are
    # being computed are missing from it.
    assert there <= check_kept(folder, expected) < COUNT
    go_on(stop, folder, expected)


@pytest.mark.evidence
def test_killed_again_and_again(stop: Stop, tmp_path: Path, expected: list[dict[str, Any]]) -> None:
    folder, word = placed(tmp_path / "one", **LONG), "run"
    for there in (3, 6, 9, 12):
        end = stop(Job(command(word), str(folder), "kill", rows=there, file=JOURNAL))
        assert end.code == KILLED
        assert check_kept(folder, expected) >= there
        word = "resume"
    go_on(stop, folder, expected)


def everywhere(stop: Stop, tmp_path: Path, how: str, step: int) -> int:
    """Stop the small study at file operations in turn, and resume; return their number."""
    first = placed(tmp_path / "first")
    assert stop(Job(command("run"), str(first), "never")).code == 0
    small = rows(first / TABLE)
    for operation in range(1, 100, step):
        folder = placed(tmp_path / f"{how}-{operation}")
        end = stop(Job(command("run"), str(folder), how, operation=operation))
        check_end(end, how)
        check_kept(folder, small)
        if end.code == 0:
            return operation - 1
        go_on(stop, folder, small)
    raise AssertionError("it never comes to an end")


def check_end(end: End, how: str) -> None:
    assert "Traceback" not in end.err, end
    if end.code and how == "full":
        assert end.code == 2
        assert "No space left on device" in end.err
        assert len(end.err.splitlines()) == 1
    elif end.code and how == "interrupt":
        assert end.code == 1
        assert end.err.endswith("interrupted\n")
    elif end.code:
        assert end.code == KILLED


@pytest.mark.parametrize("how", ["kill", *ALSO])
def test_at_some_operations(stop: Stop, tmp_path: Path, how: str) -> None:
    assert everywhere(stop, tmp_path, how, 13) > 20


@pytest.mark.evidence
@pytest.mark.parametrize("how", ["kill", "full", "interrupt"])
def test_at_every_operation(stop: Stop, tmp_path: Path, how: str) -> None:
    assert everywhere(stop, tmp_path, how, 1) > 20


@pytest.mark.parametrize("there", [1, pytest.param(8, marks=SLOW)])
def test_interrupted(
    stop: Stop, tmp_path: Path, expected: list[dict[str, Any]], there: int
) -> None:
    folder = placed(tmp_path, **LONG)
    end = stop(Job(command("run"), str(folder), "interrupt", rows=there, file=JOURNAL))
    assert (end.code, end.out) == (1, ""), end
    *note, last = end.err.splitlines()
    assert last == "interrupted"
    assert note == [f"rows so far: {TABLE}; continue with `arcless study resume small.yaml`"]
    # Who stops a study finds what it has so far in its table.
    assert len(rows(folder / TABLE)) == check_kept(folder, expected) >= there
    go_on(stop, folder, expected)


# Stands for the full disk where nobody may mount one: the journal stops in the middle of a row.
def test_a_journal_that_cannot_grow(stop: Stop, tmp_path: Path) -> None:
    wrong = {**FORCES, "values": [-5] * 60}  # rows with long reasons, and no time to compute
    folder = placed(tmp_path / "limited", variables={**VARIABLES, "force": wrong})
    done = limited(folder, "40000")  # what is asked is smaller than this
    assert done.returncode == 2, done.stderr
    assert "the journal of the study cannot be written: got " in done.stderr
    assert len(done.stderr.splitlines()) == 1
    kept = rows_in(folder / JOURNAL)
    assert 0 < kept < 120
    end = stop(Job(command("resume"), str(folder), "never"))
    assert f"0 of 120 done, 120 invalid, 0 failed; computed {120 - kept}" in end.out
    assert len(rows(folder / TABLE)) == 120


def limited(folder: Path, bytes_: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", LIMITED, bytes_, *command("run")],
        cwd=folder, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip


def test_on_a_disk_that_is_really_full(
    stop: Stop, small_disk: Callable[[int], Path], expected: list[dict[str, Any]]
) -> None:
    # Room for what is asked and an empty journal with its log, and for a part of its rows.
    disk = placed(small_disk(120), **LONG)
    end = stop(Job(command("run"), str(disk), "never"))
    check_end(end, "full")
    assert end.code == 2
    kept = check_kept(disk, expected)
    assert kept < COUNT
    subprocess.run(["mount", "-o", "remount,size=800k", str(disk)], check=True)
    go_on(stop, disk, expected)
