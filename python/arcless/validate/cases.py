"""Run the reference cases and compare."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.assess import uncertainty_of
from arcless.errors import ModelError
from arcless.model import Scenario, load
from arcless.storage.whole_files import check_writable
from arcless.validate.reference import CASES, DROPPERS, Case, Range
from arcless.validate.rows import Progress, Row, part

if TYPE_CHECKING:
    from arcless.results import Result

SUITES = ("en50318", "seed", "all")
LONG_PART = 0.9  # of the time that all of them need is that of the published ranges


def run(
    which: str = "all",
    progress: Progress | None = None,
    *,
    report: Path | None = None,
    certainty: int | None = None,
) -> list[Row]:
    """Run the reference cases of a suite.

    Parameters
    ----------
    which : {"en50318", "seed", "all"}
        The suite: published ranges, the conclusions of the founding paper, or both.
    progress : callable, optional
        Called with the done fraction and what is being done.
    report : Path, optional
        A file for values in their ranges, conclusions with figures, and verdicts, HTML.
    certainty : int, optional
        From how many starts the cases with published ranges are run; a value that is nearer to a
        bound than it is sure is then too close to tell. Conclusions have no such number.

    Returns
    -------
    list of Row
        One row for each published range, and for each part of a conclusion.
    """
    from arcless.validate import founding_paper
    from arcless.validate.observation import observe

    if which not in SUITES:
        raise ModelError("reference cases", got=f"`{which}`", expected=" or ".join(SUITES))
    if report is not None:
        check_writable(report)
    rows: list[Row] = []
    runs: list[Result] = []
    if which != "seed":
        share = part(progress, 0.0, LONG_PART if which == "all" else 1.0)
        rows += _published(share, certainty)
    if which != "en50318":
        runs = founding_paper.runs(part(progress, LONG_PART if which == "all" else 0.0, 1.0))
        rows += founding_paper.rows([observe(run) for run in runs])
    if report is not None:
        from arcless.validate import report as page

        page.write(report, which, rows, runs, certainty)
    return rows


def _published(progress: Progress | None, certainty: int | None) -> list[Row]:
    steps = len(CASES) + 1
    rows = _dropper_rows(part(progress, 0.0, 1 / steps))
    for index, case in enumerate(CASES, start=1):
        share = part(progress, index / steps, (index + 1) / steps)
        rows += _case_rows(case, share, certainty)
    return rows


def compare(case: Case, assessment: dict[str, Any]) -> list[Row]:
    """Hold an assessment against each range of a case.

    The ranges are published for one pantograph: the first one is compared.
    """
    first = assessment["pantographs"][0]
    values = {**assessment, **first}
    sure = {**(assessment.get("certainty") or {}), **(first.get("certainty") or {})}
    return [
        Row.of(case.title, allowed, values[allowed.key], uncertainty_of(sure.get(allowed.key)))
        for allowed in case.ranges
    ]


def case_of(scenario: Scenario) -> Case | None:
    """Find the ranges published for a scenario; none if it differs from the shipped one."""
    for case in CASES:
        if scenario.name == case.scenario and _same(scenario, load(case.scenario)):
            return case
    return None


def _same(one: Scenario, other: Scenario) -> bool:
    # Recorded quantities, additional runs and provenance change no result; all else may.
    ignored = {"output", "provenance", "solver", "certainty"}
    same = one.model_dump(exclude=ignored) == other.model_dump(exclude=ignored)
    return same and one.stepping == other.stepping


def _case_rows(case: Case, progress: Progress | None, certainty: int | None) -> list[Row]:
    from arcless.simulate import run as simulate

    result = simulate(load(case.scenario), progress=progress, certainty=certainty)
    return compare(case, result.assessment.to_dict())


def _dropper_rows(progress: Progress | None) -> list[Row]:
    from arcless.simulate import statics

    droppers = statics(load(DROPPERS.scenario), progress=progress).to_dict()["droppers"]
    middle = (1 + max(dropper["span"] for dropper in droppers)) // 2
    found = [dropper["length_m"] for dropper in droppers if dropper["span"] == middle]
    pairs = zip(found, DROPPERS.lengths, strict=True)
    return [
        Row.of(
            DROPPERS.title,
            Range(
                key="length_m",
                label=f"length of dropper {number}, span {middle}",
                unit="m",
                low=published - DROPPERS.tolerance,
                high=published + DROPPERS.tolerance,
                mark=DROPPERS.mark,
                digits=4,
            ),
            value,
        )
        for number, (value, published) in enumerate(pairs, start=1)
    ]


def reference_rows(scenario: Scenario, assessment: dict[str, Any]) -> list[dict[str, Any]]:
    """Return published ranges for a report: of a reference case as shipped, else none."""
    case = case_of(scenario)
    if case is None:
        return []
    return [
        {
            "quantity": f"{row.quantity}, {row.unit}",
            "value": row.value,
            "low": row.low,
            "high": row.high,
            "verdict": row.verdict,
            "mark": row.mark,
            "source": case.source,
        }
        for row in compare(case, assessment)
    ]
