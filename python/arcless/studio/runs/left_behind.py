"""Unfinished files that killed processes left in a project, and among the temporary files."""

from contextlib import suppress
from pathlib import Path

from arcless.results.kept_runs.places import RUNS
from arcless.storage import hidden_files
from arcless.studio.project import measured
from arcless.studio.project.project import Project


def sweep(project: Project) -> None:
    """Remove what was left where the studio writes; whatever another process writes now stays.

    A folder of a run in which nothing else was goes with it.
    """
    hidden_files.sweep_temporary()
    hidden_files.sweep(project.folder)
    for name in (measured.FOLDER, RUNS):
        folder = project.folder / name
        if folder.is_symlink():  # it may lead out
            continue
        hidden_files.sweep(folder)
        if name == RUNS:
            _sweep_runs(folder)


def _sweep_runs(runs: Path) -> None:
    with suppress(OSError):
        for folder in runs.iterdir():
            if folder.is_symlink() or next(folder.glob(f"{hidden_files.PREFIX}*"), None) is None:
                continue
            hidden_files.sweep(folder)
            with suppress(OSError):  # a run is in it
                folder.rmdir()
