"""Runs beside a run that say how sure its numbers are: from other starts, and refined."""

from arcless.simulate.certainty.other_starts import places
from arcless.simulate.certainty.runs_beside import Runs, found_beside, one_by_one

__all__ = ["Runs", "found_beside", "one_by_one", "places"]
