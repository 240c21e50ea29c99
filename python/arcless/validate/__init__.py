"""Reference cases: runs held against published ranges."""

from arcless.validate.cases import SUITES, Row, case_of, compare, run
from arcless.validate.reference import CASES, VERIFIED, Case, Range

__all__ = ["CASES", "SUITES", "VERIFIED", "Case", "Range", "Row", "case_of", "compare", "run"]
