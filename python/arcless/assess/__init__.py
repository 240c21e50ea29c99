"""Dataset → Assessment: indicators, criteria and verdicts, as pure functions on arrays."""

from arcless.assess.assessment import WEAR_KEYS, Assessment, assess
from arcless.assess.criteria import Criterion
from arcless.assess.rules import RULES, Rule
from arcless.assess.statistics import PantographAssessment

__all__ = [
    "RULES",
    "WEAR_KEYS",
    "Assessment",
    "Criterion",
    "PantographAssessment",
    "Rule",
    "assess",
]
