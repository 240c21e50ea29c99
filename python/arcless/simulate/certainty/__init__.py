"""Runs beside a run that say how sure its numbers are: from other starts, and refined."""

from arcless.simulate.certainty.beside import found_beside, in_parallel, one_by_one
from arcless.simulate.certainty.starts import places

__all__ = ["found_beside", "in_parallel", "one_by_one", "places"]
