"""Tables and figures of a study → one HTML file that needs no network."""

import warnings
from contextlib import suppress
from pathlib import Path
from typing import Any

from arcless.errors import OutputError
from arcless.report.drawing.bokeh_figure import Drawing
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes
from arcless.study.analysis import findings
from arcless.study.definition.study import Study
from arcless.study.folder.status import DamagedJournalWarning
from arcless.study.report import variants
from arcless.study.report.content import study_content
from arcless.study.report.data.record import Record

NAME = "report.html"


def write(study: Study, folder: Path | None = None, path: Path | None = None) -> Path:
    """Write the report of a study, of as many rows as there are.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.
    path
        The file to write; ``report.html`` in the folder without.

    Returns
    -------
    pathlib.Path
        The file that was written.

    Raises
    ------
    StudyError
        No study was begun there, or another one; a package is missing.
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    record = Record(study, folder)
    if record.status.damage is not None:
        warnings.warn(record.status.damage, DamagedJournalWarning, stacklevel=2)
    target = path or record.place.path / NAME
    write_bytes(target, _page(record).encode())
    if not record.status.running:
        with suppress(OutputError):  # the page may stand elsewhere, and has them too
            findings.write(record.place, record.findings)
    return target


def html(study: Study, folder: Path | None = None) -> str:
    """Return the report as one HTML text; see `write`."""
    return _page(Record(study, folder))


SELECTS = (
    "Drag a box or click to select variants in all figures and in the table. Click empty space to"
    " clear the selection."
)


def _page(record: Record) -> str:
    content, drawing = study_content(record), Drawing()
    canvas = content.canvas
    return render(
        "study.html",
        content.figures,
        drawing=drawing,
        variants=None if canvas is None else variants.table(canvas, drawing),
        printed=variants.PRINTED,
        selects=SELECTS,
        contents=_contents(content.texts),
        **content.texts,
    )


def _contents(texts: dict[str, Any]) -> list[tuple[str, str]]:
    """Return the addresses and titles of the sections that the page has."""
    found = [("summary", "Summary")]
    figures = [(one.key, one.title) for one in texts["rows"]]
    done = texts["status"].done > 0
    given = [
        (done, "criteria", "Criteria"),
        (done, "outputs", "Outputs"),
        *((True, *one) for one in figures),
        (texts["spacing"], "spacing", "Spacing of pantographs"),
        (texts["speeds"] or texts["speed_notes"], "speeds", "Resonance speeds"),
        (texts["sensitivity"], "sensitivity", "Sensitivity"),
        (texts["best"] is not None, "best", "Best variants"),
        (done, "variants", "All variants"),
        (texts["stops"], "stops", "Stopped early"),
        (texts["reasons"], "reasons", "Without a value"),
        (True, "varied", "What was varied"),
        (True, "again", "Run it again"),
    ]
    return [*found, *((key, title) for is_there, key, title in given if is_there)]
