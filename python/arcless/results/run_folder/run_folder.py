"""Folders of runs: their names when none is given, and those that hold a run already."""

import os
import re
import unicodedata
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from arcless.errors import OutputError
from arcless.platforms.file_names import refused_by_windows
from arcless.results.kept_runs.places import (
    ASSESSMENT_NAME,
    REPORT_NAME,
    RESULT_NAME,
    RUNS,
    is_study_folder,
)
from arcless.storage.output_folder import OutputFolder

if TYPE_CHECKING:
    from arcless.model import Scenario
    from arcless.results import KeptRun

# Files of a run; the others follow from the first.
FILES = (RESULT_NAME, ASSESSMENT_NAME, REPORT_NAME)
# Longest name of a folder, in bytes. File systems take 255 of them for a name, and Windows 260
# characters for a whole path; a shorter name leaves out more of what was changed.
LONGEST = 120


def folder_of(scenario: "Scenario") -> Path:
    """Return the folder that takes the results of a scenario when none is named.

    That is ``runs/NAME``, followed by the fields that were set for the run, in the order of their
    paths: ``runs/NAME-speed=280_km-h,line.contact_wire.tension=24_kN``. Blanks of values are
    underscores, and what file names do not take is a hyphen. A name that would be too long is cut,
    and ends in a digest of the values.
    """
    name = unicodedata.normalize("NFC", scenario.name)
    name = re.sub(r"[^\w.-]+", "-", name).strip("-.") or "scenario"
    changes = ",".join(f"{path}={_plain(text)}" for path, text in scenario.changes.items())
    whole = f"{name}-{changes}" if changes else name
    if len(whole.encode()) > LONGEST:
        whole = _cut(whole, scenario)
    whole = whole.strip("-.")
    return RUNS / (f"_{whole}" if refused_by_windows(whole) else whole)


def for_run(path: Path, *, overwrite: bool, own: Path | None = None) -> OutputFolder:
    """Return the output folder of a run, which refuses one that holds a run.

    Parameters
    ----------
    path
        The folder.
    overwrite
        Whether its run is replaced all the same.
    own
        Result file of the run that continues, which replaces itself.

    Raises
    ------
    OutputError
        It is the folder of a study.
    """
    _check_no_study(path)
    continues = own is not None and os.path.realpath(own) == os.path.realpath(path / RESULT_NAME)
    return OutputFolder(path, *FILES, refusal=None if overwrite or continues else _refusal)


def _check_no_study(path: Path) -> None:
    """Refuse the folder of a study, whose report a run would replace."""
    if is_study_folder(path):
        raise OutputError(
            "a study is in this folder",
            where=str(path),
            expected="a folder of its own for a run",
            hint="choose another one with `--out`",
        )


def _refusal(path: Path, there: Sequence[str]) -> OutputError:
    hint = "`--overwrite` replaces it, `--out FOLDER` keeps both"
    if RESULT_NAME not in there:
        return OutputError(
            "files of a run are in this folder",
            where=str(path),
            got=", ".join(there),
            expected="a folder without them",
            hint=hint,
        )
    from arcless.results.kept_runs.kept_run import STOPPED
    from arcless.results.kept_runs.reading import read

    found = read(path / RESULT_NAME)
    if found.verdict == STOPPED:
        hint = f"`arcless resume {path}` continues it, {hint}"
    return OutputError(
        "a run is in this folder",
        where=str(path),
        got=_told(found),
        expected="a folder without a run",
        hint=hint,
    )


def _told(found: "KeptRun") -> str:
    from arcless.results.kept_runs.kept_run import STOPPED, UNREADABLE

    if found.verdict == UNREADABLE:
        return f"{RESULT_NAME}, which cannot be read"
    date = (found.created or "")[:16].replace("T", " ")
    changes = "".join(f", {path}={text}" for path, text in found.changes.items())
    state = ", stopped early" if found.verdict == STOPPED else ""
    return f"{found.name} of {date} UTC{changes}{state}"


def _plain(text: str) -> str:
    """Return a text as part of the name of a folder, on any system."""
    text = unicodedata.normalize("NFC", text).strip(" []{}\"'")
    text = re.sub(r"[\s,;:]+", "_", text)
    return re.sub(r"[^\w.+-]+", "-", text).rstrip("-_.")


def _cut(whole: str, scenario: "Scenario") -> str:
    from arcless.model.scenario.as_typed import digest_of_changes

    digest = digest_of_changes(scenario.to_dict())
    room = LONGEST - len(digest) - 1
    return f"{whole.encode()[:room].decode(errors='ignore').rstrip('-_.,=')}-{digest}"
