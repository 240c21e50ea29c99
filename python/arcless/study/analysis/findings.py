"""Results that follow from all rows of a study together: indices and percentiles, also as files."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from arcless.storage.whole_files import write_bytes
from arcless.study.analysis.percentiles import percentiles
from arcless.study.analysis.sensitivity import indices
from arcless.study.definition.study import Study
from arcless.study.folder.folder import StudyFolder
from arcless.study.folder.status import RowCounter, StudyStatus
from arcless.study.journal.row import Row

# Files next to the table; a design has one of them, or none.
FILES = {"sensitivity": "sensitivity.json", "percentiles": "percentiles.json"}
Findings = dict[str, dict[str, Any] | None]


def findings(study: Study, folder: Path | None = None) -> tuple[StudyStatus, Findings]:
    """Return the status of a study, and the indices or percentiles of its rows.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.

    Returns
    -------
    StudyStatus, dict
        ``sensitivity`` and ``percentiles``, None where the design is none for them.

    Raises
    ------
    StudyError
        No study was begun there, or another one; a package is missing.
    """
    place = StudyFolder(study, folder)
    place.check_same()
    tally = RowCounter()
    rows = tally.of(place.rows())
    found = of(study, rows)
    for _ in rows:  # those that nothing follows from
        pass
    return tally.status(study, place), found


def of(study: Study, rows: Iterable[Row]) -> Findings:
    """Return the findings of rows, which are read once at most: no design has both."""
    return {"sensitivity": indices(study, rows), "percentiles": percentiles(study, rows)}


def write(place: StudyFolder, found: Findings) -> None:
    """Write the findings into files next to the table.

    Raises
    ------
    OutputError
        A file cannot be written.
    """
    for name, one in found.items():
        if one is not None:
            text = json.dumps(one, indent=1, ensure_ascii=False, allow_nan=False)
            write_bytes(place.path / FILES[name], text.encode())
