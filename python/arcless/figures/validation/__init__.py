"""Figures of reference cases: values in their published ranges, the founding paper's example."""

from arcless.figures.validation.compared import Compared, state_of
from arcless.figures.validation.founding_paper import (
    force_intervals,
    force_over_time,
    gap_over_time,
)
from arcless.figures.validation.ranges import in_range, overview

__all__ = [
    "Compared",
    "force_intervals",
    "force_over_time",
    "gap_over_time",
    "in_range",
    "overview",
    "state_of",
]
