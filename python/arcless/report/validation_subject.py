"""Subject of the page of reference cases: cases, the paper's conclusions, recorded evidence."""

from collections.abc import Sequence
from dataclasses import dataclass

from arcless.figures.validation import Compared, state_of
from arcless.report.run_content import ReportedRun


@dataclass(frozen=True)
class Case:
    """A case with published ranges: title, where they are from, values."""

    title: str
    source: str
    rows: Sequence[Compared]


@dataclass(frozen=True)
class Conclusion:
    """A statement of the founding paper.

    Attributes
    ----------
    title
        Its number and its text.
    shows
        Figures that show it: ``"force"``, ``"interval"`` or ``"gap"``.
    checked, assumption
        How it was checked, and what had to be assumed.
    rows
        The values that were checked; all must be inside.
    """

    title: str
    shows: str
    checked: str
    assumption: str
    rows: Sequence[Compared]

    @property
    def heading(self) -> str:
        """Number and text of the statement."""
        place, text = self.title.split(" ", 1)
        return f"Statement {place}: {text}"

    @property
    def holds(self) -> bool:
        """True where all values are inside."""
        return all(state_of(row.verdict) == "met" for row in self.rows)


@dataclass(frozen=True)
class Evidence:
    """A topic of the recorded evidence; `used` is the largest used part of a tolerance.

    `unverified` values are outside of a range that is only remembered.
    """

    group: str
    title: str
    version: str
    values: int
    inside: int
    unverified: int
    used: float | None
    faults: int


@dataclass(frozen=True)
class Subject:
    """All that a page of reference cases shows.

    Attributes
    ----------
    suite
        Name of the suite.
    certainty
        From how many starts each case was run; None for once.
    cases, conclusions, evidence
        Parts of the page; an empty one is left out.
    runs
        Runs of the paper's example, by increasing speed.
    source
        Where the conclusions are from.
    """

    suite: str
    certainty: int | None
    cases: Sequence[Case]
    conclusions: Sequence[Conclusion]
    runs: Sequence[ReportedRun]
    source: str
    evidence: Sequence[Evidence]

    @property
    def rows(self) -> list[Compared]:
        """All comparisons."""
        parts: list[Case | Conclusion] = [*self.cases, *self.conclusions]
        return [row for part in parts for row in part.rows]
