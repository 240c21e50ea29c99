"""Results and measurements → Comparison: numbers, bands, changed fields, overlays."""

from arcless.comparison.comparison import Comparison, compare
from arcless.comparison.measured.placing import Aligning

__all__ = ["Aligning", "Comparison", "compare"]
