"""Scatter of an assessed number over starts of a run."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

import arcless
from tests.support.assessed import Assessed

# Within one span; the run that was asked for is the first.
STARTS = 8


def spread(scenario: arcless.Scenario) -> NDArray[np.float64]:
    """Return the standard deviation of each assessed number over starts within a span, in percent.

    As `differences` counts: minima in percent of the mean force. The section stays.
    """
    found = [Assessed.of(arcless.run(moved)) for moved in _starts(scenario)]
    scatter = np.std([one.numbers() for one in found], axis=0, ddof=1)
    percent: NDArray[np.float64] = 100.0 * scatter / found[0].scales()
    return percent


def _starts(scenario: arcless.Scenario) -> list[arcless.Scenario]:
    start, _ = scenario.travel_range()
    low, high = scenario.analysis_range()
    changes: dict[str, Any] = {"analysis.from": low, "analysis.to": high}
    if scenario.analysis.spans is not None:
        changes["analysis.spans"] = None
    span = scenario.line.span_list()[1].length
    # Backwards, never with the last pantograph before the line.
    room = min(span, start - scenario.pantographs[-1].distance)
    return [
        scenario.with_(**changes, **{"travel.start": start - room * i / STARTS})
        for i in range(STARTS)
    ]
