"""An optimisation killed, interrupted or out of disk: going on gives the same table."""

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.drills.conftest import Stop, leftovers
from tests.support.stopped import End, Job
from tests.support.studies import QUICK, rows, rows_in, written

KILLED = -9
COUNT = 12
FOLDER = "runs/studies/small"
JOURNAL = f"{FOLDER}/journal.db"
SEARCH = {
    # Runs of 1600 steps: the core hands its record on six times, and they may be stopped.
    "set": {**QUICK, "solver.time_step": "1 ms"},
    "variables": {"force": {"field": "pantographs.0.static_force", "range": ["60 N", "140 N"]}},
    "outputs": {"sigma": "std_force_N"},
    "design": {
        "kind": "optimise", "trials": COUNT, "objectives": {"sigma": "minimise"},
        "pruning": {"kind": "out-of-reach", "after": 3},
    },
}  # fmt: skip


def placed(folder: Path) -> Path:
    folder.mkdir(exist_ok=True)
    written(folder, **SEARCH)
    return folder


@pytest.fixture(scope="module")
def expected(stop: Stop, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of the search, computed in one go."""
    folder = placed(tmp_path_factory.mktemp("expected"))
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "never"))
    assert end.code == 0, end
    found = rows(folder / FOLDER / "table.parquet")
    assert {row["status"] for row in found} == {"done", "pruned"}
    assert len(found) == COUNT
    return folder


def go_on(stop: Stop, folder: Path, expected: Path) -> None:
    there = rows_in(folder / JOURNAL)
    end = stop(Job(["study", "resume", "small.yaml"], str(folder), "never"))
    assert end.code == 0, end
    assert f"computed {COUNT - there}" in end.out, end
    table = f"{FOLDER}/table.parquet"
    assert rows(folder / table) == rows(expected / table)
    assert leftovers(folder) == []


@pytest.mark.parametrize(
    "there", [6, *(pytest.param(n, marks=pytest.mark.evidence) for n in (1, 3, 9, 11))]
)
def test_killed_when_a_row_is_in_the_journal(
    stop: Stop, tmp_path: Path, expected: Path, there: int
) -> None:
    folder = placed(tmp_path)
    words = ["study", "run", "small.yaml"]
    end = stop(Job(words, str(folder), "kill", rows=there, file=JOURNAL))
    assert end.code == KILLED
    assert there <= rows_in(folder / JOURNAL) < COUNT
    go_on(stop, folder, expected)


def test_on_a_disk_that_is_really_full(
    stop: Stop, small_disk: Callable[[int], Path], expected: Path
) -> None:
    # Room for an empty journal with its log, and for a part of its rows.
    disk = placed(small_disk(100))
    end: End = stop(Job(["study", "run", "small.yaml"], str(disk), "never"))
    assert end.code == 2, end
    assert "Traceback" not in end.err and len(end.err.splitlines()) == 1
    assert "No space left on device" in end.err
    subprocess.run(["mount", "-o", "remount,size=2m", str(disk)], check=True)
    go_on(stop, disk, expected)


def test_interrupted(stop: Stop, tmp_path: Path, expected: Path) -> None:
    folder = placed(tmp_path)
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "interrupt", rows=5,
                   file=JOURNAL))  # fmt: skip
    assert (end.code, end.out) == (1, ""), end
    assert end.err.splitlines()[-1] == "interrupted"
    go_on(stop, folder, expected)


def facts(folder: Path) -> dict[str, Any]:

    return json.loads((folder / FOLDER / "study.json").read_text())  # type: ignore[no-any-return]


def test_no_row_yet(stop: Stop, tmp_path: Path, expected: Path) -> None:
    folder = placed(tmp_path)
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "kill", operation=6))
    assert end.code == KILLED
    # Begun, or not even that: whoever was killed before its first row may begin again.
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "never"))
    assert end.code == 0, end
    assert rows(folder / FOLDER / "table.parquet") == rows(expected / FOLDER / "table.parquet")
    assert facts(folder)["id"] != facts(expected)["id"]
