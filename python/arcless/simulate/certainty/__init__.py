"""Additional runs that say how sure the numbers of a run are: from other starts, and refined."""

from arcless.simulate.certainty.additional_runs import Runs, run_additional, sequential_runner
from arcless.simulate.certainty.other_starts import places

__all__ = ["Runs", "places", "run_additional", "sequential_runner"]
