"""Rows of a study against the limits of the assessment, batch by batch as they come."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from arcless.assess import NOT_JUDGED
from arcless.study import Study
from arcless.study.journal.row import Row
from arcless.study.report.data.judge import judge
from arcless.study.report.data.judged import VERDICTS, Judged
from arcless.study.report.data.record import RowColumns


@dataclass(frozen=True)
class RowCriterion:
    """A criterion that some row is judged by.

    Attributes
    ----------
    title, of
        Of the criterion, and of the pantograph; empty of one alone.
    output
        Name of the output that has its value; None for a value that the scenario alone has.
    relation
        Of value to limit, ``"<="``, ``">="`` or ``">"``; empty where the output is the verdict.
    tolerance
        Distance that a value may lie beyond its limit, in the unit of the output.
    source
        Marks of the limit, and where it is from.
    """

    title: str
    of: str
    output: str | None
    relation: str
    tolerance: float
    source: str

    @classmethod
    def of_judged(cls, judged: Judged) -> "RowCriterion":
        """Return the criterion without its rows."""
        column = judged.output
        marks = ", ".join(judged.marks)
        return cls(judged.title, column.of if column else "", column.name if column else None,
                   judged.relation, judged.tolerance, f"{marks}: {judged.how}")  # fmt: skip


@dataclass(frozen=True)
class RowVerdict:
    """Verdict on a row, and for each criterion: its number, the verdict, the limit or None."""

    word: str
    criteria: list[tuple[int, str, float | None]]


class RowVerdicts:
    """Verdicts on the rows of a study.

    Attributes
    ----------
    unknown
        Criteria that decide and that no output tells, in words.
    """

    def __init__(self, study: Study) -> None:
        self._study = study
        self._criteria: dict[tuple[str, str | None, tuple[int, ...]], RowCriterion] = {}
        self.unknown: list[str] = []

    @property
    def criteria(self) -> list[dict[str, Any]]:
        """The criteria that were met with so far, by their numbers."""
        return [asdict(one) for one in self._criteria.values()]

    def of(self, rows: Sequence[Row]) -> dict[int, RowVerdict]:
        """Return the verdicts on rows by variant; rows that are not done have none."""
        done = [row for row in rows if row.status == "done"]
        if not done:
            return {}
        found = judge(RowColumns(self._study, done))
        self.unknown = list(dict.fromkeys([*self.unknown, *found.unknown]))
        numbers = [self._number(one) for one in found.items]
        verdicts = {}
        for place, row in enumerate(done):
            each = [
                (number, VERDICTS[int(one.codes[place])], _limit(float(one.limits[place])))
                for number, one in zip(numbers, found.items, strict=True)
            ]
            told = [one for one in each if one[1] != NOT_JUDGED]
            verdicts[row.variant] = RowVerdict(VERDICTS[int(found.codes[place])], told)
        return verdicts

    def _number(self, judged: Judged) -> int:
        name = None if judged.output is None else judged.output.name
        key = (judged.name, name, judged.owners)
        self._criteria.setdefault(key, RowCriterion.of_judged(judged))
        return list(self._criteria).index(key)


def _limit(value: float) -> float | None:
    return value if np.isfinite(value) else None
