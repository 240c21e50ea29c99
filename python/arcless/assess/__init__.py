"""Dataset → Assessment: indicators, criteria and verdicts, as pure functions on arrays."""

from arcless.assess.assessment import WEAR_KEYS, Assessment, assess
from arcless.assess.criteria import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    NOT_MET_UNVERIFIED,
    RELATION_SIGNS,
    TOO_CLOSE,
    Criterion,
    allowance,
    decimals_of,
    is_at_limit,
    is_withheld,
    shown_verdict,
    telling_decimals,
    uncertainty_of,
    verdict_of,
)
from arcless.assess.rules import RULES, Rule, decides
from arcless.assess.statistics import PantographAssessment

__all__ = [
    "MET",
    "NOT_JUDGED",
    "NOT_MET",
    "NOT_MET_UNVERIFIED",
    "RELATION_SIGNS",
    "RULES",
    "TOO_CLOSE",
    "WEAR_KEYS",
    "Assessment",
    "Criterion",
    "PantographAssessment",
    "Rule",
    "allowance",
    "assess",
    "decides",
    "decimals_of",
    "is_at_limit",
    "is_withheld",
    "shown_verdict",
    "telling_decimals",
    "uncertainty_of",
    "verdict_of",
]
