"""A disk that fills up: one sentence, nothing left behind, and the older run as it was."""

import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

from arcless.errors import ArclessError
from arcless.simulate.runs.failures import translated
from tests.drills.conftest import NEW, OLD, ROOT, RUN, Stop, check_whole, leftovers
from tests.support.stopped import End, Job

Place = Callable[[str], Path]
FEW = [*RUN, "--no-report"]
WRONG_PLACE = 2


def check_refused(end: End, folder: Path) -> None:
    assert end.code == WRONG_PLACE, end
    assert end.out == ""
    assert "No space left on device" in end.err
    assert ".arcless" not in end.err  # the user knows no hidden names
    assert "out" in end.err
    assert len(end.err.splitlines()) == 1
    assert leftovers(folder) == []


def full_from_each_operation(stop: Stop, place: Place, kind: str, words: list[str]) -> int:
    """Fill the disk at each file operation in turn; return how many of them were refused."""
    for refused in range(100):
        folder = place(kind)
        end = stop(Job(words, str(folder), "full", operation=refused + 1))
        if end.code in (0, 3):  # what is left to do takes no room
            assert check_whole(folder / "out") == NEW
            return refused
        check_refused(end, folder)
        assert check_whole(folder / "out") == (OLD if kind == "older" else None)
        assert (folder / "out").exists() == (kind == "older")
    raise AssertionError("it never comes to an end")


def test_from_each_operation_beside_an_older_run(stop: Stop, place: Place) -> None:
    assert full_from_each_operation(stop, place, "older", FEW) > 3


@pytest.mark.evidence
def test_from_each_operation_of_a_first_run(stop: Stop, place: Place) -> None:
    assert full_from_each_operation(stop, place, "fresh", FEW) > 3


@pytest.mark.evidence
@pytest.mark.parametrize("kind", ["older", "fresh"])
def test_from_each_operation_with_report(stop: Stop, place: Place, kind: str) -> None:
    assert full_from_each_operation(stop, place, kind, RUN) > 4


# Too small for result.nc (about 400 KiB), and for the report (about 1 MiB) after it.
@pytest.mark.parametrize("kibibytes", [64, 800])
def test_on_a_disk_that_is_really_full(
    stop: Stop, small_disk: Callable[[int], Path], kibibytes: int
) -> None:
    disk = small_disk(kibibytes)
    check_refused(stop(Job(RUN, str(disk), "never")), disk)
    assert list(disk.iterdir()) == []


LIMITED = """
import resource, sys
from arcless.cli import main
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]),) * 2)
sys.argv = ["arcless", *sys.argv[2:]]
main()
"""


# Stands for the full disk where nobody may mount one: the write stops in the middle of the file.
def test_write_that_stops_in_the_middle(place: Place) -> None:
    folder = place("older")
    before = {path.name: path.read_bytes() for path in (folder / "out").iterdir()}
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, "20000", *FEW],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == WRONG_PLACE, done.stderr
    assert "out/result.nc: the file cannot be written: got File too large" in done.stderr
    assert leftovers(folder) == []
    assert {path.name: path.read_bytes() for path in (folder / "out").iterdir()} == before


@pytest.mark.parametrize("words", [["library"], ["schema"], ["--help"]])
def test_output_into_a_full_device_is_one_sentence(words: list[str]) -> None:
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("there is no /dev/full here")
    with full.open("w") as out:
        done = subprocess.run(
            [sys.executable, "-m", "arcless", *words],
            cwd=ROOT,
            stdout=out,
            stderr=subprocess.PIPE,
            text=True,
            timeout=60,
            check=False,
        )
    assert done.returncode == WRONG_PLACE, done.stderr
    assert done.stderr == "error: No space left on device\n"


def test_failure_is_told_even_without_room_for_its_replay_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "none"))
    assert (unsolved().hint or "").startswith("no file to replay it could be written: ")


def test_half_a_replay_file_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        failure = unsolved()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert "could be written: File too large" in (failure.hint or "")
    assert list(tmp_path.iterdir()) == []


def unsolved() -> ArclessError:
    """Return the failure of a step with some kilobytes of problem."""
    size = 40
    details = {
        "step": 7, "time": 0.007, "contacts": [(0, 0, 0)], "links": [], "stops": [],
        "h": [0.1] * size**2, "w": [-0.1] * size, "reason": "drawn",
    }  # fmt: skip
    mesh = SimpleNamespace(droppers=[])
    return translated(mesh, ["P1"], "lcp", "", details)
