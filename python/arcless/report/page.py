"""Figures and tables of a run → one HTML file that needs no network."""

from pathlib import Path
from typing import Any

from arcless.assess import Assessment
from arcless.figures.description.thinning import every
from arcless.figures.run import figures
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import MARKS
from arcless.report.drawing.animation import Animation
from arcless.report.run_content import ReportedRun, Rows, run_content
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

# Figures over the whole track: of several pantographs one below the other, at the page's width.
STACKED = ("force", "shares", "gap", "height", "spectrogram", "lateral", "irregular")


def write(
    result: ReportedRun,
    path: str | Path,
    *,
    assessment: Assessment | None = None,
    reference_rows: Rows = (),
    animation: Animation | None = None,
) -> None:
    """Write the report of a run: one HTML file that opens without a network.

    It has less than 2 MB for a kilometre, and less than 4 MB for fifty.

    Parameters
    ----------
    result
        The run.
    path
        The file to write; its folder must exist.
    assessment
        An assessment over another section or filter than the scenario's own.
    reference_rows
        Reference values to show next to the run's: ``quantity``, ``value``, ``low``, ``high``,
        ``verdict`` ("inside", "outside"), ``mark``, ``source``.
    animation
        An animation of the run; `arcless.studio.animation` makes it.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    page = html(result, assessment=assessment, reference_rows=reference_rows, animation=animation)
    write_bytes(path, page.encode())


def html(
    result: ReportedRun,
    *,
    assessment: Assessment | None = None,
    reference_rows: Rows = (),
    animation: Animation | None = None,
) -> str:
    """Return the report as one HTML text; see `write`."""
    run = RunData(result.latest, assessment or result.assessment)
    drawn = figures(run)
    content = run_content(result, run, drawn, reference_rows)
    contents = [("summary", "Summary")]
    contents += [("motion", "Motion")] if animation else []
    contents += [("criteria", "Criteria"), ("numbers", "Numbers")]
    contents += [(key, title) for key, title, _ in content["sections"]]
    contents += [("certainty", "Certainty")] if content["certainty"] else []
    contents += [("model", "Model data"), ("computation", "Computation")]
    return render(
        "run.html",
        drawn,
        track=track_of(run),
        animation=animation,
        contents=contents,
        stacked=STACKED,
        **content,
    )


def track_of(run: RunData) -> dict[str, Any]:
    """Return the section and the supports in m, for buttons and the cross hair."""
    supports = (
        run.supports
        if run.supports.size <= MARKS
        else run.supports[every(run.supports.size, MARKS)]
    )
    return {
        "section": [float(end) for end in run.assessment.section_m],
        "supports": [round(float(x), 2) for x in supports],
    }
