"""Runs below a folder."""

import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from arcless.errors import ResultFormatError
from arcless.results.kept_runs.kept_run import KeptRun
from arcless.results.kept_runs.places import RUNS, is_study_folder

_ENDING = ".nc"


@dataclass
class Found:
    """Entries below a folder: runs from the oldest to the newest, and folders of studies."""

    runs: list[KeptRun] = field(default_factory=list)
    studies: list[Path] = field(default_factory=list)


def runs(folder: str | Path | None = None) -> list[KeptRun]:
    """Return the runs below a folder, from the oldest to the newest.

    Parameters
    ----------
    folder
        Looked through with all folders in it; ``runs``, which need not be there, without. A run is
        any file that ends in ``.nc``. Hidden folders and folders of studies are left out: the
        variants of a study are in its table.

    Returns
    -------
    list of KeptRun
        One that cannot be read is there with its reason.

    Raises
    ------
    ResultFormatError
        There is no such folder.
    """
    return search(folder).runs


def search(
    folder: str | Path | None = None, reading: Callable[[Path], KeptRun] | None = None
) -> Found:
    """Return the runs below a folder, and the studies that were left out; see `runs`.

    `reading` gives the run in a result file; that is read without.
    """
    top, found = RUNS if folder is None else Path(folder), Found()
    if folder is None and not os.path.lexists(top):
        return found
    if not top.is_dir():
        raise ResultFormatError(
            "no such folder",
            where=str(top),
            got="a file" if top.exists() else None,
            expected="a folder below which runs are",
        )
    from arcless.results.kept_runs.reading import read, unreadable

    refused: list[OSError] = []
    found.runs = [(reading or read)(place) for place in _places(top, found.studies, refused)]
    found.runs += [unreadable(Path(one.filename), str(one.strerror)) for one in refused]
    found.runs.sort(key=lambda one: (one.created or "", str(one.path)))
    return found


def _places(top: Path, studies: list[Path], refused: list[OSError]) -> Iterator[Path]:
    """Yield result files; note folders of studies, and those that cannot be looked into."""
    for name, folders, files in os.walk(top, onerror=refused.append):
        here = Path(name)
        if is_study_folder(here):
            studies.append(here)
            folders.clear()
            continue
        folders[:] = sorted(one for one in folders if not one.startswith("."))
        for file in sorted(files):
            if file.endswith(_ENDING) and not file.startswith("."):
                yield here / file
