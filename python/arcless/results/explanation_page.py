"""Explanation of σ → one HTML file that needs no network."""

from pathlib import Path
from typing import Any

from arcless.explanation import Explanation, Sensitivities
from arcless.explanation.tables import READS, sensitivity_rows
from arcless.figures.run import contributions, spans
from arcless.figures.run.run_data import RunData
from arcless.report import summary
from arcless.report.page import track_of
from arcless.report.run_content import ReportedRun
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

# Address, title, key of the figures, and whether those of several pantographs are stacked.
_SECTIONS = (
    ("contributions", "Contributions to σ", "contributions", False),
    ("spans", "σ by span", "by_span", False),
    ("irregular", "What does not repeat", "irregular", True),
)


def write(result: ReportedRun, explanation: Explanation, path: str | Path) -> None:
    """Write the page of an explanation: one HTML file that opens without a network.

    Parameters
    ----------
    result
        The run.
    explanation
        Its explanation.
    path
        The file to write; its folder must exist.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    write_bytes(path, html(result, explanation).encode())


def html(result: ReportedRun, explanation: Explanation) -> str:
    """Return the page of an explanation as one HTML text; see `write`."""
    run, facts = RunData(result.latest, result.assessment), result.metadata
    drawn = {
        "contributions": contributions.contributions(run),
        "by_span": spans.by_span(run),
        "irregular": contributions.irregular(run),
    }
    sections = [one for one in _SECTIONS if drawn[one[2]]]
    contents = [("summary", "Summary")]
    contents += [] if explanation.sensitivities is None else [("sensitivities", "Sensitivity of σ")]
    contents += [(key, text) for key, text, _, _ in sections]
    return render(
        "explanation.html",
        drawn,
        track=track_of(run),
        title=f"Why σ is as it is: {result.scenario.name}",
        identity=summary.identity(result.scenario, result.assessment, facts),
        explained=explanation.tables(),
        explained_reads=READS,
        notes=explanation.notes,
        contents=contents,
        sections=sections,
        version=str(facts["arcless_version"]),
        date=str(facts["created"])[:16].replace("T", " "),
        **_sensitivities(explanation.sensitivities),
    )


def _sensitivities(known: Sensitivities | None) -> dict[str, Any]:
    if known is None:
        return {"sensitivities": [], "step": 0.0, "left_out": ()}
    return {
        "sensitivities": sensitivity_rows(known),
        "step": known.step_percent,
        "left_out": known.left_out,
    }
