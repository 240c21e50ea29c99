"""Figures and tables → one HTML file that needs no network."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.assess import Assessment
from arcless.assess.words import explained
from arcless.model import MARKS
from arcless.report import along, contacts, distribution, line, tables
from arcless.report.model_data import groups, marks_used
from arcless.report.scene import Scene
from arcless.report.template import render
from arcless.results.files import write_bytes

if TYPE_CHECKING:
    from arcless.results import Result

Rows = Sequence[Mapping[str, Any]]

MAX_WARNINGS = 50

# Place on the page → figure; a figure that the record has no data for is None.
FIGURES = {
    "force": along.force,
    "shares": contacts.shares,
    "gap": along.gap,
    "height": along.height,
    "uplift": along.uplift,
    "droppers": along.droppers,
    "dropper_passages": along.dropper_passages,
    "histogram": distribution.histogram,
    "spectrum": distribution.force_spectrum,
    "side_view": line.side_view,
    "plan_view": line.plan_view,
    "elasticity": line.elasticity,
    "energy": line.energy,
}


def write(
    result: "Result",
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
        Reference values to show beside the run's: ``quantity``, ``value``, ``low``, ``high``,
        ``verdict`` ("inside", "outside"), ``mark``, ``source``.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    page = html(result, assessment=assessment, reference_rows=reference_rows)
    write_bytes(path, page.encode())


def html(
    result: "Result", *, assessment: Assessment | None = None, reference_rows: Rows = ()
) -> str:
    """Return the report as one HTML text; see `write`."""
    scene = Scene(result.latest, assessment or result.assessment)
    drawn = {name: draw(scene) for name, draw in FIGURES.items()}
    return render("page.html", drawn, **_texts(result, scene, reference_rows))


def _texts(result: "Result", scene: Scene, reference_rows: Rows) -> dict[str, Any]:
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
