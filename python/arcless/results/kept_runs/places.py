"""Kind of a place: a run, by its folder or its file, or something else that a hint names."""

import os
from pathlib import Path

from arcless.errors import ResultFormatError
from arcless.model.shipped.library import shipped

# Name of a run's own file in its folder, and of its assessment and report in the same folder.
RESULT_NAME = "result.nc"
ASSESSMENT_NAME, REPORT_NAME = "assessment.json", "report.html"
# Folder that takes the runs for which none is named.
RUNS = Path("runs")
# Files by which the folder of a study is known.
STUDY_FILES = ("study.json", "journal.db", "journal.jsonl")
TABLE = "table.parquet"
_A_RUN = f"the folder of a run, or the {RESULT_NAME} in it"
_OF_STUDIES = (*STUDY_FILES, TABLE, "study.yaml", "report.html")
_DESCRIPTIONS = (".yaml", ".yml", ".json")
_PAGE = ".html"


def result_file(path: str | Path) -> Path:
    """Return the file of a run that is named by its folder or by its file."""
    place = Path(path)
    return place / RESULT_NAME if place.is_dir() else place


def is_study_folder(path: Path) -> bool:
    """Return whether a study was begun in a folder."""
    # `Path.is_file` fails where nobody may look.
    return any(os.path.isfile(path / name) for name in STUDY_FILES)  # noqa: PTH113


def study_folder(path: str | Path) -> Path | None:
    """Return the folder of a study that a path names, itself or a file in it; None for another."""
    place = Path(path)
    if place.is_dir():
        return place if is_study_folder(place) and not result_file(place).exists() else None
    known = place.name in _OF_STUDIES and place.is_file() and is_study_folder(place.parent)
    return place.parent if known else None


def run_file(path: str | Path) -> Path:
    """Return the file of a run; refuse a place that is none, and say what it is.

    Parameters
    ----------
    path
        Folder of a run, or the file in it, which is not read here.

    Raises
    ------
    ResultFormatError
        It is a folder without a run, a study, or a file that is no result; the hint says what to
        do with that.
    """
    place, file = Path(path), result_file(path)
    study = study_folder(place)
    if study is not None:
        raise _study(place, study)
    if place.is_dir() and not file.exists():
        raise _no_run_in(place)
    if place.is_file() and place.suffix.lower() in (*_DESCRIPTIONS, _PAGE):
        raise _description(place)
    if not file.exists() and (hint := _meant(place)):
        raise ResultFormatError("no such run", where=str(path), expected=_A_RUN, hint=hint)
    return file


def _meant(place: Path) -> str | None:
    """Return a hint for a place where nothing is."""
    if (RUNS / place).is_dir():
        return f"did you mean {RUNS / place}?"
    for kind, command in (("scenario", "run"), ("study", "study run")):
        if str(place) in shipped(kind):
            return f"this is a shipped {kind}: `arcless {command} {place}`"
    return None


def _study(given: Path, folder: Path) -> ResultFormatError:
    return ResultFormatError(
        "study in place of a run",
        where=str(given),
        expected=_A_RUN,
        hint=f"`arcless study report {folder}` shows all its variants, `arcless export {folder}"
        " --to FILE.xlsx` writes their numbers",
    )


def _no_run_in(folder: Path) -> ResultFormatError:
    inside = sorted(folder.glob("*.nc"))
    if inside:
        hint = f"name the file, such as {inside[0]}"
    elif any(folder.glob(f"*/{RESULT_NAME}")):
        hint = f"`arcless runs {folder}` lists the runs below it"
    else:
        hint = f"`arcless run SCENARIO --out {folder}` makes one"
    return ResultFormatError(
        "no run in this folder",
        where=str(folder),
        got=f"no {RESULT_NAME}",
        expected="the folder of a run",
        hint=hint,
    )


def _description(file: Path) -> ResultFormatError:
    own, hint = file.with_name(RESULT_NAME), None
    if own.exists():
        hint = f"the run is {own}"
    elif file.suffix.lower() in _DESCRIPTIONS:
        hint = f"if it is a scenario, `arcless run {file}` makes a run of it"
    return ResultFormatError(
        "file that describes what to run, or follows from it",
        where=str(file),
        expected=_A_RUN,
        hint=hint,
    )
