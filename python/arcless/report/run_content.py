"""Content of a run's report, the same for the page and for paper: texts, tables, sections."""

from collections.abc import Mapping, Sequence, Set
from typing import Any, Protocol

from arcless.assess import Assessment
from arcless.assess.certainty_words import explained
from arcless.dataset.plain_dataset import Dataset
from arcless.explanation.tables import READS
from arcless.figures.description import Figure
from arcless.figures.run.run_data import RunData
from arcless.model import MARKS as MEANINGS
from arcless.model import Scenario
from arcless.model.advice.unverified import unverified_data
from arcless.report import summary, tables
from arcless.report.model_data import groups, marks_used

Rows = Sequence[Mapping[str, Any]]

MAX_WARNINGS = 50

MARKS_MEAN = (
    "The mark states how well a number is known. The count includes all criteria. A limit"
    " that was not checked in a source (marks C, C*, assumed) cannot fail a run: a value beyond it"
    " is not met (unverified)."
)
CERTAINTY_READS = (
    "A run with another start within the span gives other numbers. The pantograph is the same at"
    " every start; its static force follows from that of the run and the base spring. A criterion"
    " is too close to tell if the distance between value and limit is smaller than its"
    " uncertainty; it then cannot fail a run."
)

# Address, title, figures of a section; those of an inner tuple stand next to each other.
_SECTIONS: tuple[tuple[str, str, tuple[str | tuple[str, ...], ...]], ...] = (
    ("force", "Contact force along the track", ("force", "shares", "gap")),
    ("spans", "Contact force by span", (("folded", "by_span"),)),
    ("contributions", "Contributions to σ", ("contributions", "irregular")),
    ("statistics", "Distribution and spectrum", (("histogram", "spectrum"), "spectrogram")),
    (
        "wire", "Contact wire and uplift", ("height", "uplift", "uplift_passages", "space_time"),
    ),
    ("droppers", "Droppers", ("droppers", "dropper_map")),
    ("head", "Collector head", ("lateral", "wear_pattern")),
    ("rest", "Line at rest", ("side_view", "plan_view", "elasticity")),
)  # fmt: skip


class ReportedRun(Protocol):
    """A run with its assessment; `arcless.Result` is one."""

    @property
    def scenario(self) -> Scenario:
        """The scenario that was run."""

    @property
    def latest(self) -> Dataset:
        """Everything that was recorded."""

    @property
    def assessment(self) -> Assessment:
        """Indicators and criteria over the scenario's own section."""

    @property
    def metadata(self) -> dict[str, Any]:
        """The attributes of the dataset."""


def run_content(
    result: ReportedRun, run: RunData, drawn: Mapping[str, Sequence[Figure]], reference_rows: Rows
) -> dict[str, Any]:
    """Return what a report of a run tells, by names as the templates of pages have them.

    Parameters
    ----------
    result, run
        The run, and what its figures are made of.
    drawn
        Its figures by their keys.
    reference_rows
        Published values to compare with; see `report.write`.
    """
    facts, assessment, scenario = result.metadata, run.assessment, result.scenario
    data = groups(scenario, facts["static_force_found"])
    method = assessment.certainty_method
    used = marks_used(data) | {row["mark"] for row in reference_rows if row.get("mark")}
    return {
        "title": facts["scenario_name"],
        "facts": facts,
        "version": facts["arcless_version"],
        "date": str(facts["created"])[:16].replace("T", " "),
        "description": scenario.description,
        "identity": summary.identity(scenario, assessment, facts),
        **first_screen(run, drawn),
        "explained": [] if run.explanation is None else run.explanation.tables(),
        "explained_reads": READS,
        "computation": tables.computation(run, facts),
        "numbers": tables.number_rows(run),
        "certainty": tables.certainty_rows(assessment),
        "certainty_words": explained(method, with_times=False) if method else [],
        "certainty_reads": CERTAINTY_READS,
        "reference_rows": tables.reference_cells(reference_rows),
        "energies": tables.energy_rows(run),
        "groups": data,
        "marks": marks_of(assessment, used),
        "warnings": [*unverified_data(scenario), *(facts["warnings"] or [])][:MAX_WARNINGS],
    }


def first_screen(run: RunData, drawn: Mapping[str, Sequence[Figure]]) -> dict[str, Any]:
    """Return what reports of simulated and of measured runs show alike: verdict, bars, figures."""
    assessment = run.assessment
    return {
        "assessment": assessment,
        "verdict": summary.verdict(assessment),
        "judged_on": summary.judged_on(run),
        "worst": summary.worst_place(run),
        "bullets": summary.grouped(summary.bullets(assessment)),
        "criteria": tables.criterion_rows(assessment),
        "marks_mean": MARKS_MEAN,
        "numbers_of": _numbers_of(assessment),
        "sections": sections_of(drawn),
    }


def marks_of(assessment: Assessment, used: Set[str] = frozenset()) -> dict[str, str]:
    """Return the meanings of the marks of criteria, and of others that are used."""
    shown = used | {one.mark for one in assessment.criteria}
    return {mark: meaning for mark, meaning in MEANINGS.items() if mark in shown}


def _numbers_of(assessment: Assessment) -> str:
    """Return what the numbers of an assessment are of: section, filter, loss of contact."""
    return (
        f"Over the analysis section, {assessment.section_words}. Forces are after the"
        f" {assessment.low_pass_Hz:g} Hz low-pass, without phase shift, unless they are called"
        " unfiltered. Loss of contact is that of the unfiltered force."
    )


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
