"""Positions of a measurement → positions on the line of a run."""

from arcless.comparison.alignment.alignment import aligned
from arcless.comparison.alignment.correlation import correlation
from arcless.comparison.alignment.folding import repeated
from arcless.comparison.alignment.given import correlation_at
from arcless.comparison.alignment.place import Alignment, Search
from arcless.comparison.alignment.trace import Trace

__all__ = ["Alignment", "Search", "Trace", "aligned", "correlation", "correlation_at", "repeated"]
