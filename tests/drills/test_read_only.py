"""A folder that is only for reading: refused before any computing; what it holds can be read."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from shutil import copyfile

import pytest

from arcless.study import StudyFolder
from tests.drills.conftest import OLD, RUN, check_whole, leftovers
from tests.support.studies import filled

Place = Callable[[str], Path]
# Who may write everywhere (root) gives that up in a process of his own, and only then starts.
POWERLESS = """
import ctypes, os, sys
libc = ctypes.CDLL(None)
DROP_FROM_BOUNDING_SET, OVERRIDE, READ_SEARCH = 24, 1, 2
for power in (OVERRIDE, READ_SEARCH):
    libc.prctl(DROP_FROM_BOUNDING_SET, power, 0, 0, 0)
os.execv(sys.executable, [sys.executable, *sys.argv[1:]])
"""


@pytest.fixture
def powerless(place: Place) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Run Python where folders for reading only are that."""

    def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-c", POWERLESS, *words],
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )

    return run


@pytest.fixture
def folder(place: Place, powerless: Callable[..., subprocess.CompletedProcess[str]]) -> Path:
    """Return a folder for reading only, with an older run in `out`, which is one as well."""
    made = place("older")
    for path in (made / "out", made):
        path.chmod(0o555)
    probe = powerless(made, "-c", "open('probe', 'w')")
    if probe.returncode == 0:
        made.chmod(0o755)
        pytest.skip("this user may write everywhere and cannot give it up")
    return made


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([*RUN, "--set", "solver.time_step=0.01 ms"], "the output folder cannot be written"),
        ([*RUN[:2], "--out", "new/folder"], "the output folder cannot be written"),
        (["statics", RUN[1], "--out", "new"], "the output folder cannot be written"),
        (["statics", RUN[1], "--plot", "line.html"], "the file cannot be written"),
        (["assess", "out/result.nc", "--out", "again.json"], "the file cannot be written"),
        (["report", "out/result.nc"], "the file cannot be written"),
    ],
    ids=["run", "run-new", "statics", "plot", "assess", "report"],
)
def test_is_refused_at_once(
    powerless: Callable[..., subprocess.CompletedProcess[str]],
    folder: Path,
    words: list[str],
    said: str,
) -> None:
    done = powerless(folder, "-m", "arcless", *words)
    assert done.returncode == 2, done.stderr
    assert done.stdout == ""
    assert said in done.stderr
    assert "read-only" in done.stderr or "Permission denied" in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert leftovers(folder) == []
    assert [path.name for path in folder.iterdir()] == ["out"]


VALIDATE = """
import sys
from unittest import mock
from arcless.cli import main
sys.argv = ["arcless", "validate", "--report", "seed.html"]
with mock.patch("arcless.validate.cases._published", side_effect=AssertionError("computes")):
    main()
"""


def test_validate_is_refused_before_its_minutes_of_computing(
    powerless: Callable[..., subprocess.CompletedProcess[str]], folder: Path
) -> None:
    done = powerless(folder, "-c", VALIDATE)
    assert done.returncode == 2, done.stderr
    assert "seed.html: the file cannot be written: got a read-only folder" in done.stderr


def test_what_it_holds_can_be_read(
    powerless: Callable[..., subprocess.CompletedProcess[str]], folder: Path
) -> None:
    done = powerless(folder, "-m", "arcless", "assess", "out/result.nc", "--json")
    assert done.returncode in (0, 3), done.stderr
    assert json.loads(done.stdout) == json.loads((folder / "out/assessment.json").read_text())
    assert check_whole(folder / "out") == OLD


def test_what_nobody_may_look_into_is_listed_with_the_reason(
    powerless: Callable[..., subprocess.CompletedProcess[str]], folder: Path
) -> None:
    folder.chmod(0o755)
    modes = {"closed": 0o000, "names-only": 0o444}
    for name, mode in modes.items():
        (folder / name).mkdir()
        (folder / name / "result.nc").touch()
        (folder / name).chmod(mode)
    done = powerless(folder, "-m", "arcless", "runs", ".", "--json")
    for name in modes:
        (folder / name).chmod(0o755)
    assert done.returncode == 0, done.stderr
    found = {one["path"]: one for one in json.loads(done.stdout)}
    assert set(found) == {"out", *modes}
    assert found["out"]["verdict"] in ("met", "not met")
    for name in modes:
        assert found[name]["verdict"] == "unreadable"
        assert "Permission denied" in found[name]["reason"]


@pytest.mark.parametrize("state", [pytest.param("at rest", marks=pytest.mark.evidence), "killed"])
def test_a_study_can_be_looked_at(
    powerless: Callable[..., subprocess.CompletedProcess[str]], tmp_path: Path, state: str
) -> None:
    made = tmp_path / "study"
    place = StudyFolder(filled(made, of=3), made)
    if state == "killed":  # rows are in the log, which nobody can put in order there
        with place.open_journal() as journal:
            journal.append(replace(next(place.rows()), variant=4))
            for end in ("", "-wal"):
                copyfile(f"{place.journal}{end}", tmp_path / f"kept{end}")
        for end in ("", "-wal"):
            (tmp_path / f"kept{end}").replace(f"{place.journal}{end}")
    made.chmod(0o555)
    done = powerless(tmp_path, "-m", "arcless", "study", "status", "study", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["done"] == (4 if state == "killed" else 3)
    assert "damaged" not in done.stderr
    words = ["study", "report", "study", "--to", "report.html"]
    assert powerless(tmp_path, "-m", "arcless", *words).returncode == 0
    refused = powerless(tmp_path, "-m", "arcless", "study", "resume", "study")
    made.chmod(0o755)
    assert refused.returncode == 2, refused.stderr
    assert "cannot be written: got " in refused.stderr
    assert not list(made.glob("journal-damaged*"))


def test_the_drill_can_fail(
    powerless: Callable[..., subprocess.CompletedProcess[str]], folder: Path
) -> None:
    for path in (folder, folder / "out"):
        path.chmod(0o755)
    assert powerless(folder, "-m", "arcless", "report", "out/result.nc").returncode == 0
    assert os.access(folder / "out/report.html", os.R_OK)
