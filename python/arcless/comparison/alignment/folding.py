"""Part of a channel that repeats from support to support, as a channel along the track.

It is the mean over the whole spans of the values at the same part of the span, put back into every
span. A measurement that is aligned by it is aligned by the supports: by what all spans have in
common, not by what a single one has.
"""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from arcless.comparison.alignment.trace import Trace
from arcless.errors import ComparisonError

Floats = NDArray[np.float64]
# Places in a span at which spans are averaged, and the fewest spans that are: one is no mean.
PLACES, FEWEST_SPANS = 241, 2


def repeated(line: Trace, supports_m: Floats) -> Trace:
    """Return the part of a channel that all spans have in common, over the whole line.

    Parameters
    ----------
    line
        Channel of a run over its position.
    supports_m
        Positions of the supports in m, increasing.

    Raises
    ------
    ComparisonError
        Fewer than two spans were run through whole.
    """
    along = np.linspace(0.0, 1.0, PLACES)
    whole = []
    for left, right in pairwise(supports_m):
        values, known = line.at(left + along * (right - left))
        if known.all():
            whole.append(values)
    if len(whole) < FEWEST_SPANS:
        raise ComparisonError(
            "too few whole spans to align by supports",
            got=f"{len(whole)}",
            expected=f"at least {FEWEST_SPANS} that the run passed",
            hint="use --align correlation, or --offset",
        )
    mean = np.mean(whole, axis=0)
    x = line.position_m
    span = np.clip(np.searchsorted(supports_m, x, side="right") - 1, 0, supports_m.size - 2)
    left, right = supports_m[span], supports_m[span + 1]
    inside = (x >= supports_m[0]) & (x <= supports_m[-1])
    values = np.interp((x - left) / (right - left), along, mean)
    return Trace(x, np.where(inside, values, mean.mean()), inside, line.shortest_m)
