"""A run as the panel of results shows it: verdict, criteria, numbers, in the words of reports."""

from dataclasses import asdict
from importlib.metadata import version
from typing import Any

import numpy as np

from arcless.report import run_content, summary, tables
from arcless.studio.charts.charted_run import ChartedRun
from arcless.studio.charts.plain.drawable import heads


def assessed(run: ChartedRun) -> dict[str, Any]:
    """Return verdict, criteria with limits and sources, and numbers of a run."""
    assessment, facts = run.result.assessment, run.result.metadata
    first = run_content.first_screen(run.data, run.figures)
    lead = summary.leading(assessment)
    return {
        "title": facts["scenario_name"],
        "description": run.result.scenario.description,
        "identity": summary.identity(run.result.scenario, assessment, facts),
        "verdict": asdict(first["verdict"]),
        "leading": None if lead is None else tables.criterion_row(lead),
        "judged_on": first["judged_on"],
        "worst": first["worst"],
        "criteria": first["criteria"],
        "marks": run_content.marks_of(assessment),
        "marks_mean": run_content.MARKS_MEAN,
        "pantographs": [one.name for one in assessment.pantographs],
        "numbers": tables.number_rows(run.data),
        "numbers_of": first["numbers_of"],
        "certainty": assessment.certainty_method is not None,
        "notes": assessment.notes,
        "warnings": (facts["warnings"] or [])[: run_content.MAX_WARNINGS],
        "stopped_m": assessment.stopped_m,
        "version": facts["arcless_version"],
        "other_version": facts["arcless_version"] != version("arcless"),
        "report": run.file.with_name("report.html").is_file(),
    }


def sections(run: ChartedRun) -> dict[str, Any]:
    """Return the figures of a run without their layers, by the sections of its report.

    Figures stand in rows; those of one row are looked at side by side.
    """
    told = heads(run.figures)
    order = [
        ("lead", "Worst place", ["lead"]),
        *run_content.sections_of(run.figures),
        ("computation", "Computation", ["energy"]),
    ]

    def rows(names: list[Any]) -> list[list[dict[str, Any]]]:
        beside = [name if isinstance(name, list) else [name] for name in names]
        return [[one for name in row for one in told[name]] for row in beside]

    found = [{"key": key, "title": title, "rows": rows(names)} for key, title, names in order]
    return {
        "sections": [one for one in found if any(one["rows"])],
        "section_m": list(run.result.assessment.section_m),
        "supports_m": [float(x) for x in run.data.supports],
    }


def explained(run: ChartedRun) -> dict[str, Any]:
    """Return the explanation of σ; each place has the time at which its pantograph was there.

    Raises
    ------
    ExplanationError
        The section is too short for one, or a force is constant.
    """
    found = run.explanation.to_dict()
    for i, pantograph in enumerate(found["pantographs"]):
        for place in (*pantograph["worst"], *pantograph["irregular"]):
            at = np.interp(place["position_m"], run.data.position[:, i], run.data.time)
            place["time_s"] = float(at)
    return found
