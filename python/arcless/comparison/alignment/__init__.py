"""Positions of a measurement → positions on the line of a run."""

from arcless.comparison.alignment.alignment import Alignment, Search, aligned
from arcless.comparison.alignment.trace import Trace

__all__ = ["Alignment", "Search", "Trace", "aligned"]
