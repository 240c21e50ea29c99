"""Reference cases: runs held against published ranges, and against published conclusions."""

from arcless.validate.cases import SUITES, case_of, compare, run
from arcless.validate.evidence import Topic, recorded
from arcless.validate.reference import CASES, VERIFIED, Case, Range
from arcless.validate.rows import Row
from arcless.validate.seed import SOURCE as SEED_SOURCE

__all__ = [
    "CASES",
    "SEED_SOURCE",
    "SUITES",
    "VERIFIED",
    "Case",
    "Range",
    "Row",
    "Topic",
    "case_of",
    "compare",
    "recorded",
    "run",
]
