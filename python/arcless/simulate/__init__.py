"""The arrow: scenario → mesh → equilibrium → record → dataset. This package alone knows all of it."""

from arcless.simulate.run import run
from arcless.simulate.statics import StaticsResult, statics

__all__ = ["StaticsResult", "run", "statics"]
