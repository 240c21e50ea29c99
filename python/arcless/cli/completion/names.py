"""Names that complete an argument: shipped models, model files, runs and studies.

A shell asks at each press of the tab key, so nothing is imported and no file is read: names are
those of files. Where none fits, the shell completes names of files by itself.
"""

from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path

from arcless.storage.shipped_files import FOLDERS, shipped

# Entries of a folder that are looked at: a folder with more is slow to list, and no help.
MOST_ENTRIES = 2000
RUNS, STUDIES = Path("runs"), Path("runs") / "studies"
MODELS = (".yaml", ".yml")
RESULT, MEASUREMENT = ".nc", ".csv"

Names = Callable[[str], list[str]]


def scenarios(incomplete: str) -> list[str]:
    """Return shipped scenarios and model files here."""
    return _fitting(incomplete, [*shipped("scenario"), *_files(MODELS)])


def lines(incomplete: str) -> list[str]:
    """Return shipped scenarios and lines, and model files here; behind ``line/`` those of lines."""
    if incomplete.startswith("line/"):
        return _fitting(incomplete, [f"line/{name}" for name in shipped("line")])
    known = dict.fromkeys([*shipped("scenario"), *shipped("line")])
    return _fitting(incomplete, [*known, *_files(MODELS)])


def shipped_models(incomplete: str) -> list[str]:
    """Return shipped models of any kind; behind ``line/`` and the like those of one."""
    kind, slash, _ = incomplete.partition("/")
    if slash and kind in FOLDERS:
        return _fitting(incomplete, [f"{kind}/{name}" for name in shipped(kind)])
    return _fitting(
        incomplete, list(dict.fromkeys(name for one in FOLDERS for name in shipped(one)))
    )


def models(incomplete: str) -> list[str]:
    """Return shipped models of any kind, and model files here."""
    return [*shipped_models(incomplete), *_fitting(incomplete, _files(MODELS))]


def runs(incomplete: str) -> list[str]:
    """Return folders of runs, and results here."""
    return _fitting(incomplete, [*_begun(RUNS, "result.nc"), *_files((RESULT,))])


def runs_and_studies(incomplete: str) -> list[str]:
    """Return folders of runs and of studies, and results here."""
    return [*runs(incomplete), *_fitting(incomplete, _begun(STUDIES, "study.json"))]


def runs_and_measurements(incomplete: str) -> list[str]:
    """Return folders of runs, and results and measurements here."""
    return [*runs(incomplete), *_fitting(incomplete, _files((MEASUREMENT,)))]


def tables(incomplete: str) -> list[str]:
    """Return CSV files here."""
    return _fitting(incomplete, _files((MEASUREMENT,)))


def studies(incomplete: str) -> list[str]:
    """Return shipped studies and model files here."""
    return _fitting(incomplete, [*shipped("study"), *_files(MODELS)])


def begun_studies(incomplete: str) -> list[str]:
    """Return folders of studies, shipped studies, and model files here."""
    return _fitting(
        incomplete, [*_begun(STUDIES, "study.json"), *shipped("study"), *_files(MODELS)]
    )


def _fitting(incomplete: str, names: list[str]) -> list[str]:
    return [name for name in names if name.startswith(incomplete)]


def _files(endings: tuple[str, ...]) -> list[str]:
    """Return files of the current folder by their endings."""
    return [entry.name for entry in _entries(Path()) if entry.suffix in endings]


def _begun(folder: Path, mark: str) -> list[str]:
    """Return the folders in a folder that have a file of this name."""
    return [entry.as_posix() for entry in _entries(folder) if (entry / mark).is_file()]


def _entries(folder: Path) -> Iterator[Path]:
    """Yield what is in a folder, by name; nothing where it cannot be listed."""
    try:
        yield from sorted(islice(folder.iterdir(), MOST_ENTRIES))
    except OSError:
        return
