"""Whole spans of a section, and the deviation of the force in each."""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# A support this near to an end of the section, as a share of its position, is at the end: typed
# numbers have so many digits.
AT_THE_END = 1e-6


def whole_spans(
    supports: Floats, section: tuple[float, float], run: tuple[float, float]
) -> list[tuple[int, float, float]]:
    """Return number and ends in m of the spans that lie inside a section and a run wholly.

    Parameters
    ----------
    supports
        Positions of the supports in m.
    section, run
        Ends in m of the section, and of what was run over.
    """
    begin, end = section
    margin = AT_THE_END * max(1.0, abs(end))
    return [
        (number, float(left), float(right))
        for number, (left, right) in enumerate(pairwise(supports), start=1)
        if left >= begin - margin and right <= end + margin and left >= run[0] and right <= run[1]
    ]


def deviations(x: Floats, force: Floats, chosen: list[tuple[int, float, float]]) -> Floats:
    """Return the standard deviation of a force in each span, in N."""
    ends = np.array([(left, right) for _, left, right in chosen]).reshape(-1, 2)
    rows = np.searchsorted(x, ends)
    return np.array([force[first:last].std() for first, last in rows])
