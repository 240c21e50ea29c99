"""Left-overs of killed processes in a project, removed at the start of a studio."""

from pathlib import Path

import pytest

from arcless.storage import hidden_files
from arcless.studio.project.project import Project
from arcless.studio.runs.left_behind import sweep


@pytest.fixture(autouse=True)
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Send temporary folders into the test's own folder."""
    place = tmp_path / "temporary"
    place.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(place))
    return place


def leave(folder: Path) -> None:
    """Leave what a killed writer leaves: a hidden folder that nobody holds."""
    left = folder / hidden_files.new_name()
    (left / "inside").mkdir(parents=True)
    (left / "result.nc").write_bytes(b"half")


def names(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*"))


def test_what_was_left_goes_and_the_rest_stays(tmp_path: Path, temporary: Path) -> None:
    folder, outside = tmp_path / "project", tmp_path / "outside"
    for place in ("", "measured", "runs/broken", "runs/whole", "deep/runs/broken"):
        leave(folder / place)
    leave(outside)
    leave(temporary)
    (folder / "runs" / "empty").mkdir()
    (folder / "runs" / "linked").symlink_to(outside)
    (folder / "runs" / "whole" / "result.nc").write_bytes(b"whole")
    at_work = hidden_files.create_folder(folder / "runs" / hidden_files.new_name())
    before = names(outside)
    sweep(Project.of(folder))
    at_work.close()
    assert names(temporary) == []
    kept = [name for name in names(folder) if not name.startswith("deep")]
    hidden = [name for name in kept if name.startswith(f"runs/{hidden_files.PREFIX}")]
    assert len(hidden) == 1  # of the writer at work
    assert [name for name in kept if name not in hidden] == [
        "measured", "runs", "runs/empty", "runs/linked", "runs/whole", "runs/whole/result.nc",
    ]  # fmt: skip
    assert names(outside) == before
    assert len(names(folder / "deep")) == 5  # the studio writes nothing there


def test_a_project_without_runs(tmp_path: Path) -> None:
    folder = tmp_path / "project"
    folder.mkdir()
    sweep(Project.of(folder))
    assert names(folder) == []
