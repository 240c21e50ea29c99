"""Figures and tables of a run → one HTML file that needs no network."""

from collections.abc import Mapping, Sequence, Set
from pathlib import Path
from typing import Any

from arcless.assess import Assessment
from arcless.assess.certainty_words import explained
from arcless.figures.description import Figure
from arcless.figures.description.thinning import every
from arcless.figures.run import figures
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import MARKS
from arcless.model import MARKS as MEANINGS
from arcless.report import summary, tables
from arcless.report.model_data import groups, marks_used
from arcless.report.reported_run import ReportedRun
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

Rows = Sequence[Mapping[str, Any]]

MAX_WARNINGS = 50

# Address, title, figures of a section; those of an inner tuple stand next to each other.
_SECTIONS: tuple[tuple[str, str, tuple[str | tuple[str, ...], ...]], ...] = (
    ("force", "Contact force along the track", ("force", "shares", "gap")),
    ("spans", "Contact force by span", (("folded", "by_span"),)),
    ("contributions", "Contributions to σ", ("contributions", "irregular")),
    ("statistics", "Distribution and spectrum", (("histogram", "spectrum"), "spectrogram")),
    ("wire", "Contact wire and uplift", ("height", "uplift", "uplift_passages")),
    ("droppers", "Droppers", ("droppers", "dropper_map")),
    ("head", "Collector head", ("lateral", "wear_pattern")),
    ("rest", "Line at rest", ("side_view", "plan_view", "elasticity")),
)  # fmt: skip
# Figures over the whole track: of several pantographs one below the other, at the page's width.
_STACKED = ("force", "shares", "gap", "height", "spectrogram", "lateral", "irregular")


def write(
    result: ReportedRun,
    path: str | Path,
    *,
    assessment: Assessment | None = None,
    reference_rows: Rows = (),
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
    run = RunData(result.latest, assessment or result.assessment)
    drawn = figures(run)
    texts = _texts(result, run, drawn, reference_rows)
    return render("run.html", drawn, track=track_of(run), **texts)


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


def _texts(
    result: ReportedRun, run: RunData, drawn: Mapping[str, Sequence[Figure]], reference_rows: Rows
) -> dict[str, Any]:
    facts, assessment, scenario = result.metadata, run.assessment, result.scenario
    data = groups(scenario)
    certainty = tables.certainty_rows(assessment)
    used = marks_used(data) | {row["mark"] for row in reference_rows if row.get("mark")}
    sections = sections_of(drawn)
    contents = [("summary", "Summary"), ("criteria", "Criteria"), ("numbers", "Numbers")]
    contents += [(key, title) for key, title, _ in sections]
    contents += [("certainty", "Certainty")] if certainty else []
    contents += [("model", "Model data"), ("computation", "Computation")]
    return {
        "title": facts["scenario_name"],
        "facts": facts,
        "version": facts["arcless_version"],
        "date": str(facts["created"])[:16].replace("T", " "),
        "description": scenario.description,
        "identity": summary.identity(scenario, assessment, facts),
        **first_screen(run, drawn),
        "contents": contents,
        "explained": [] if run.explanation is None else run.explanation.tables(),
        "computation": tables.computation(run, facts),
        "numbers": tables.number_rows(run),
        "certainty": certainty,
        "certainty_words": explained(assessment.certainty_method or {})
        if assessment.certainty_method
        else [],
        "reference_rows": tables.reference_cells(reference_rows),
        "energies": tables.energy_rows(run),
        "groups": data,
        "marks": marks_of(assessment, used),
        "warnings": (facts["warnings"] or [])[:MAX_WARNINGS],
    }


def first_screen(run: RunData, drawn: Mapping[str, Sequence[Figure]]) -> dict[str, Any]:
    """Return what pages of simulated and of measured runs show alike: verdict, bars, figures."""
    assessment = run.assessment
    return {
        "assessment": assessment,
        "verdict": summary.verdict(assessment),
        "worst": summary.worst_place(run),
        "bullets": summary.grouped(summary.bullets(assessment)),
        "criteria": tables.criterion_rows(assessment),
        "sections": sections_of(drawn),
        "stacked": _STACKED,
    }


def marks_of(assessment: Assessment, used: Set[str] = frozenset()) -> dict[str, str]:
    """Return the meanings of the marks of criteria, and of others that are used."""
    shown = used | {one.mark for one in assessment.criteria}
    return {mark: meaning for mark, meaning in MEANINGS.items() if mark in shown}


def sections_of(drawn: Mapping[str, Sequence[Figure]]) -> list[tuple[str, str, list[Any]]]:
    """Return the sections that have figures, without the figures that there are none of.

    Figures that stand next to each other do so for one pantograph; of several, each kind has a row.
    """
    found = []
    for key, title, names in _SECTIONS:
        rows: list[Any] = []
        for name in names:
            each = name if isinstance(name, tuple) else (name,)
            inner = [one for one in each if drawn.get(one)]
            paired = len(inner) > 1 and all(len(drawn[one]) == 1 for one in inner)
            rows += [inner] if paired else inner
        if rows:
            found.append((key, title, rows))
    return found
