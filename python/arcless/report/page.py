"""Figures and tables → one HTML file that needs no network."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from arcless.assess import Assessment
from arcless.assess.certainty_words import explained
from arcless.model import MARKS
from arcless.report import tables
from arcless.report.figures import along_track, contacts, distribution, line_at_rest
from arcless.report.figures.run_data import RunData
from arcless.report.model_data import groups, marks_used
from arcless.report.reported_run import ReportedRun
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

Rows = Sequence[Mapping[str, Any]]

MAX_WARNINGS = 50

# Place on the page → figure; a figure that the record has no data for is None.
FIGURES = {
    "force": along_track.force,
    "shares": contacts.shares,
    "gap": along_track.gap,
    "height": along_track.height,
    "uplift": along_track.uplift,
    "droppers": along_track.droppers,
    "dropper_passages": along_track.dropper_passages,
    "histogram": distribution.histogram,
    "spectrum": distribution.force_spectrum,
    "side_view": line_at_rest.side_view,
    "plan_view": line_at_rest.plan_view,
    "elasticity": line_at_rest.elasticity,
    "energy": line_at_rest.energy,
}


def write(
    result: ReportedRun,
    path: str | Path,
    *,
    assessment: Assessment | None = None,
    reference_rows: Rows = (),
) -> None:
    """Write the report of a run: one HTML file under 2 MB that opens without a network.

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

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    page = html(result, assessment=assessment, reference_rows=reference_rows)
    write_bytes(path, page.encode())


def html(
    result: ReportedRun, *, assessment: Assessment | None = None, reference_rows: Rows = ()
) -> str:
    """Return the report as one HTML text; see `write`."""
    scene = RunData(result.latest, assessment or result.assessment)
    drawn = {name: draw(scene) for name, draw in FIGURES.items()}
    return render("page.html", drawn, **_texts(result, scene, reference_rows))


def _texts(result: ReportedRun, scene: RunData, reference_rows: Rows) -> dict[str, Any]:
    facts, assessment = result.metadata, scene.assessment
    data = groups(result.scenario)
    criteria = tables.criterion_rows(assessment)
    used = marks_used(data) | {
        row["mark"] for row in (*criteria, *reference_rows) if row.get("mark")
    }
    return {
        "facts": facts,
        "description": result.scenario.description,
        "assessment": assessment,
        "verdict": tables.verdict(assessment),
        "run_facts": tables.fact_pairs(scene),
        "indicators": tables.indicator_rows(assessment),
        "criteria": criteria,
        "certainty": tables.certainty_rows(assessment),
        "certainty_words": explained(assessment.certainty_method or {})
        if assessment.certainty_method
        else [],
        "reference_rows": tables.reference_cells(reference_rows),
        "energies": tables.energy_rows(scene),
        "groups": data,
        "marks": {mark: meaning for mark, meaning in MARKS.items() if mark in used},
        "warnings": (facts["warnings"] or [])[:MAX_WARNINGS],
    }
