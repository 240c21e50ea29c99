"""Studies by what they left on the disk: a folder, or a file in it, in place of a study file."""

import os
from pathlib import Path

from arcless.errors import ArclessError, StudyError
from arcless.model.shipped.library import shipped
from arcless.results import RESULT_NAME
from arcless.study.definition.load import load, of_contents
from arcless.study.definition.study import Study
from arcless.study.folder.folder import NAMES, STATE, StudyFolder, read_state, unreadable


def located(source: Path, out: Path | None = None) -> tuple[Study, Path | None]:
    """Return a study and its folder, None for the usual one.

    Parameters
    ----------
    source
        A shipped name, a study file, the folder of a study, or its journal or table.
    out
        The folder, where it is another one.

    Raises
    ------
    ModelError
        The study file is wrong.
    StudyError
        No study was begun in the folder, or its state cannot be read.
    """
    folder = _folder(source)
    return (load(source), out) if folder is None else (begun(folder), out or folder)


def open_study(source: str | os.PathLike[str]) -> StudyFolder:
    """Return a study that was begun, with its table.

    Parameters
    ----------
    source
        The folder of the study or a file in it; or its study file, where the study is in its usual
        folder, ``runs/studies/NAME``.

    Raises
    ------
    ModelError
        The study file is wrong.
    StudyError
        No study was begun there, or it cannot be read.
    """
    study, folder = located(Path(source))
    place = StudyFolder(study, folder)
    place.check_same()
    return place


def begun(folder: Path) -> Study:
    """Return the study that was begun in a folder, as it was asked then.

    Raises
    ------
    StudyError
        None was, or its state cannot be read.
    """
    state = read_state(folder)
    if state is None and (folder / RESULT_NAME).exists():
        raise _run_at(folder)
    if state is None:
        raise StudyError(
            "no study was begun here",
            where=str(folder),
            expected="the folder of a study, or a study file",
            hint="begin one with `arcless study run FILE`",
        )
    try:
        made = of_contents(state["study"], str(folder))
    except (ArclessError, ValueError, KeyError, TypeError, AttributeError):
        raise unreadable(folder / STATE) from None
    if not StudyFolder(made, folder).is_of_this_study:
        raise unreadable(folder / STATE)
    return made


def _folder(source: Path) -> Path | None:
    """Return the folder of a study that a path names; None for a study file."""
    if os.fspath(source) in shipped("study"):
        return None
    if source.is_dir():
        return source
    if source.name == RESULT_NAME and source.is_file():
        raise _run_at(source)
    return source.parent if source.name in NAMES and (source.parent / STATE).is_file() else None


def _run_at(place: Path) -> StudyError:
    return StudyError(
        "run in place of a study",
        where=str(place),
        expected="the folder of a study, or a study file",
        hint=f"`arcless report {place}` is for runs, and so are assess, compare and export",
    )
