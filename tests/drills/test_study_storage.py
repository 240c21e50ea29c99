"""An optimisation killed or out of disk: going on gives the same table and the same trials."""

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from arcless.study import journal
from tests.drills.conftest import Stop, leftovers
from tests.support.stopped import End, Job
from tests.support.studies import QUICK, rows, written

KILLED = -9
COUNT = 12
FOLDER = "runs/studies/small"
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


def trials(folder: Path) -> list[tuple[str, list[float] | None, dict[int, float]]]:
    """Return what Optuna finds in the storage."""
    import optuna

    storage = optuna.storages.RDBStorage(f"sqlite:///{folder / FOLDER / 'optuna.db'}")
    try:
        found = optuna.load_study(study_name="small", storage=storage).get_trials()
    except KeyError:
        found = []
    finally:
        storage.remove_session()
        storage.engine.dispose()  # a disk with an open file stays mounted
    return [(one.state.name, one.values, one.intermediate_values) for one in found]


@pytest.fixture(scope="module")
def expected(stop: Stop, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of the search, computed in one go."""
    folder = placed(tmp_path_factory.mktemp("expected"))
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "never"))
    assert end.code == 0, end
    found = rows(folder / FOLDER / "table.parquet")
    assert {row["status"] for row in found} == {"done", "pruned"}
    assert len(trials(folder)) == len(found) == COUNT
    return folder


def go_on(stop: Stop, folder: Path, expected: Path) -> None:
    there = len(list(journal.rows(folder / FOLDER / "journal.jsonl")))
    end = stop(Job(["study", "resume", "small.yaml"], str(folder), "never"))
    assert end.code == 0, end
    assert f"computed {COUNT - there}" in end.out, end
    table = f"{FOLDER}/table.parquet"
    assert rows(folder / table) == rows(expected / table)
    assert trials(folder) == trials(expected)
    assert leftovers(folder) == []


@pytest.mark.parametrize(
    "lines", [6, *(pytest.param(n, marks=pytest.mark.evidence) for n in (1, 3, 9, 11))]
)
def test_killed_when_a_row_is_in_the_journal(
    stop: Stop, tmp_path: Path, expected: Path, lines: int
) -> None:
    folder = placed(tmp_path)
    file = f"{FOLDER}/journal.jsonl"
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "kill", lines=lines, file=file))
    assert end.code == KILLED
    kept = len(list(journal.rows(folder / file)))
    # The storage follows the journal: it never holds what that does not.
    assert len(trials(folder)) <= kept
    assert trials(folder) == trials(expected)[: len(trials(folder))]
    go_on(stop, folder, expected)


@pytest.mark.parametrize(
    "damage",
    [
        "cut in a transaction",
        *(pytest.param(n, marks=pytest.mark.evidence) for n in ("missing", "of an older state")),
    ],
)
def test_the_storage_is_made_again(stop: Stop, tmp_path: Path, expected: Path, damage: str) -> None:
    folder = placed(tmp_path)
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "kill", lines=8,
                   file=f"{FOLDER}/journal.jsonl"))  # fmt: skip
    assert end.code == KILLED
    file = folder / FOLDER / "optuna.db"
    if damage == "missing":
        file.unlink()
        Path(f"{file}-journal").unlink(missing_ok=True)
    else:
        shorten(file, keep=2, commit=damage == "of an older state")
    go_on(stop, folder, expected)


def shorten(file: Path, *, keep: int, commit: bool) -> None:
    """Delete trials but the first ones; without commit die in the midst of it."""
    script = (
        "import os, sqlite3, sys\n"
        "base = sqlite3.connect(sys.argv[1])\n"
        "base.execute('PRAGMA cache_size = 1')\n"  # what is changed goes to the disk before its end
        "for table in ('trial_values', 'trial_params', 'trial_user_attributes',\n"
        "              'trial_system_attributes', 'trial_intermediate_values', 'trials'):\n"
        "    base.execute(f'DELETE FROM {table} WHERE trial_id > ?', (int(sys.argv[2]),))\n"
        "base.commit() if sys.argv[3] == 'True' else os._exit(0)\n"
    )
    words = [sys.executable, "-c", script, str(file), str(keep), str(commit)]
    subprocess.run(words, check=True)


def test_on_a_disk_that_is_really_full(
    stop: Stop, small_disk: Callable[[int], Path], expected: Path
) -> None:
    # Room for the empty tables of the storage, and not for much of its undoing beside it.
    disk = placed(small_disk(140))
    end: End = stop(Job(["study", "run", "small.yaml"], str(disk), "never"))
    assert end.code == 2, end
    assert "Traceback" not in end.err and len(end.err.splitlines()) == 1
    assert "the storage of the study cannot be written" in end.err or "No space left" in end.err
    subprocess.run(["mount", "-o", "remount,size=2m", str(disk)], check=True)
    go_on(stop, disk, expected)


def test_interrupted(stop: Stop, tmp_path: Path, expected: Path) -> None:
    folder = placed(tmp_path)
    end = stop(Job(["study", "run", "small.yaml"], str(folder), "interrupt", lines=5,
                   file=f"{FOLDER}/journal.jsonl"))  # fmt: skip
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
    assert trials(folder) == trials(expected)
    assert facts(folder)["id"] != facts(expected)["id"]
