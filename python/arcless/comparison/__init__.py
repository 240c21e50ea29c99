"""Results → Comparison: numbers side by side, changed fields, overlays."""

from arcless.comparison.comparison import Comparison, compare

__all__ = ["Comparison", "compare"]
