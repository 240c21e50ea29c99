"""Runs beside a run that say how sure its numbers are: from other starts, and refined."""

from arcless.simulate.certainty.other_starts import places
from arcless.simulate.certainty.runs_beside import found_beside, in_parallel, one_by_one

__all__ = ["found_beside", "in_parallel", "one_by_one", "places"]
