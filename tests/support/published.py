"""Rows of a run's assessment with the ranges that were published for it."""

from arcless.results import Result
from arcless.validate import Case, Row, compare
from tests.support.evidence import Evidence


def rows(evidence: Evidence, case: Case, result: Result, source: str) -> list[Row]:
    """Record where each value lies, and return the rows; `source` says where ranges were read."""
    found = compare(case, result.assessment.to_dict())
    assert len(found) == len(case.ranges)
    which = case.title.partition(", ")[2]
    for row in found:
        assert row.value is not None
        evidence.published(
            f"{row.quantity}, {which}", row.value, row.low, row.high, unit=row.unit,
            mark=row.mark, source=source,
        )  # fmt: skip
    return found
