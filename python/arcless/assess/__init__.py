"""Dataset → Assessment: indicators, criteria and verdicts, as pure functions on arrays."""

from arcless.assess.assessment import WEAR_KEYS, Assessment, assess
from arcless.assess.criteria import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    TOO_CLOSE,
    Criterion,
    uncertainty_of,
    verdict_of,
)
from arcless.assess.rules import RULES, Rule
from arcless.assess.statistics import PantographAssessment

__all__ = [
    "MET",
    "NOT_JUDGED",
    "NOT_MET",
    "RULES",
    "TOO_CLOSE",
    "WEAR_KEYS",
    "Assessment",
    "Criterion",
    "PantographAssessment",
    "Rule",
    "assess",
    "uncertainty_of",
    "verdict_of",
]
