"""Outputs of a study against the limits of the assessment: one criterion, and all of them."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from arcless.assess import MET, NOT_JUDGED, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE, decides
from arcless.assess.criteria import RELATIONS
from arcless.assess.rules import Rule
from arcless.study.report.data.record import Column, Floats

VERDICTS = (NOT_JUDGED, MET, NOT_MET, NOT_MET_UNVERIFIED, TOO_CLOSE)
CODES = {verdict: code for code, verdict in enumerate(VERDICTS)}
Codes = NDArray[np.int8]


@dataclass(frozen=True, eq=False)
class Judged:
    """One criterion over the rows that are done.

    Attributes
    ----------
    name, title
        Of the criterion.
    output
        Output whose values are judged; None for a number that the scenario alone has.
    relation
        ``"<="``, ``">="`` or ``">"``; empty where the output is the verdict itself.
    values, limits
        In the unit of the output; NaN for one that is not known.
    codes
        Places in `VERDICTS`.
    unit
        Of value and limit.
    sure
        Whether the limit of a variant decides.
    marks, source
        Of the limits.
    how
        Where the limit is from, in words.
    owners
        Pantographs that it tells about, from 0.
    tolerance
        Distance in `unit` that a value may lie beyond its limit.
    """

    name: str
    title: str
    output: Column | None
    relation: str
    values: Floats
    limits: Floats
    codes: Codes
    unit: str
    sure: NDArray[np.bool_]
    marks: tuple[str, ...]
    source: str
    how: str
    owners: tuple[int, ...]
    tolerance: float = 0.0

    @property
    def decides(self) -> bool:
        """True where the limit of any variant decides."""
        return bool(self.sure.any())

    @property
    def heading(self) -> str:
        """Title of the criterion, and the pantograph."""
        of = self.output.of if self.output is not None and self.relation else ""
        return f"{self.title}, {of}" if of else self.title

    def count(self, *verdicts: str) -> int:
        """Return how many variants have one of these verdicts."""
        return int(np.isin(self.codes, [CODES[one] for one in verdicts]).sum())


@dataclass(frozen=True, eq=False)
class Verdicts:
    """All that could be judged.

    Attributes
    ----------
    items
        By output and criterion.
    codes
        Verdict on each variant, over what decides.
    whole
        True where an output says whether all criteria are met.
    unknown
        Criteria that decide and that no output tells, in words.
    """

    items: tuple[Judged, ...]
    codes: Codes
    whole: bool
    unknown: tuple[str, ...] = field(default=())

    def of(self, output: Column) -> list[Judged]:
        """Return the criteria of an output that have limits, those that decide first."""
        found = [one for one in self.items if one.output is output and one.relation]
        return sorted(found, key=lambda one: not one.decides)


def code_of(value: float, ends: Sequence[float], rule: Rule, mark: str) -> int:
    """Return the verdict on a value by a limit that lies between two ends."""
    if not np.isfinite(value):
        return CODES[NOT_JUDGED]
    passed = {RELATIONS[rule.relation](value, end, rule.tolerance) for end in ends}
    if len(passed) > 1:
        return CODES[TOO_CLOSE]
    return CODES[MET if passed.pop() else NOT_MET if decides(mark) else NOT_MET_UNVERIFIED]
