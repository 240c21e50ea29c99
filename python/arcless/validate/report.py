"""Reference cases → the page of `arcless validate --report`."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from arcless.validate import founding_paper
from arcless.validate.evidence import GROUPS, UNVERIFIED, recorded
from arcless.validate.reference import CASES, DROPPERS
from arcless.validate.rows import Row

if TYPE_CHECKING:
    from arcless.report.validation_subject import Case, Conclusion, Evidence
    from arcless.results import Result

# Conclusion → figures that show it.
SHOWN_BY = {
    founding_paper.JOINTS: "force",
    founding_paper.INTERVAL: "interval",
    founding_paper.GAPS: "gap",
}


def write(
    path: Path, which: str, rows: Sequence[Row], runs: "Sequence[Result]", certainty: int | None
) -> None:
    """Write the page of a suite.

    Parameters
    ----------
    path
        The file; its folder must exist.
    which : {"en50318", "seed", "all"}
        The suite. The page of `all` has the recorded evidence, too.
    rows
        Its comparisons.
    runs
        Runs of the founding paper's example, by increasing speed; none of `en50318`.
    certainty
        From how many starts the cases were run; None for once.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    from arcless.report import validation_page
    from arcless.report.validation_subject import Subject

    subject = Subject(
        suite=which,
        certainty=certainty,
        cases=cases(rows),
        conclusions=conclusions(rows),
        runs=runs,
        source=founding_paper.SOURCE,
        evidence=evidence() if which == "all" else [],
    )
    validation_page.write(subject, path)


def cases(rows: Sequence[Row]) -> "list[Case]":
    """Return the cases with published ranges that have rows, with their sources."""
    from arcless.report.validation_subject import Case

    found = [(DROPPERS.title, DROPPERS.source), *((one.title, one.source) for one in CASES)]
    made = [Case(title, source, _of(rows, title)) for title, source in found]
    return [one for one in made if one.rows]


def conclusions(rows: Sequence[Row]) -> "list[Conclusion]":
    """Return the conclusions of the founding paper that have rows."""
    from arcless.report.validation_subject import Conclusion

    made = [
        Conclusion(title, SHOWN_BY[title], checked, assumption, _of(rows, title))
        for title, (checked, assumption) in founding_paper.CONCLUSIONS.items()
    ]
    return [one for one in made if one.rows]


def evidence() -> "list[Evidence]":
    """Return the recorded evidence, a line for each topic."""
    from arcless.report.validation_subject import Evidence

    return [
        Evidence(
            GROUPS[topic.group], topic.title, topic.version, len(topic.rows), topic.inside,
            sum(row.verdict == UNVERIFIED for row in topic.rows), topic.most_used,
            len(topic.faults),
        )
        for topic in recorded()
    ]  # fmt: skip


def _of(rows: Sequence[Row], title: str) -> list[Row]:
    return [row for row in rows if row.case == title]
