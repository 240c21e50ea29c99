"""Why σ is what it is: parts of it by what repeats, places, sentences."""

from arcless.explanation.explanation import Explanation, explain
from arcless.explanation.pantograph_explanation import PantographExplanation
from arcless.explanation.sensitivity import Effect, Sensitivities, Sensitivity

__all__ = [
    "Effect",
    "Explanation",
    "PantographExplanation",
    "Sensitivities",
    "Sensitivity",
    "explain",
]
