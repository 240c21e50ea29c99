"""Position of a pantograph counted in spans, and in intervals between droppers.

In span n, from x_n over the length L_n, and between the droppers m and m + 1,

    ξ(x) = n + (x − x_n)/L_n,      ψ(x) = m + (x − x_m)/(x_{m+1} − x_m)

What a line repeats from span to span is periodic in ξ whatever the lengths and whatever the speed
does; what it repeats from dropper to dropper is periodic in ψ. Order tracking of machines counts
revolutions of a shaft in the same way.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.model import Line

Floats = NDArray[np.float64]

# Two spans hang alike if their droppers stand at the same parts of the span within this share of
# it. Looser, droppers that drift through the span pass for a pattern of the span; tighter,
# lengths typed in whole centimetres make a line irregular.
SAME_PART = 0.005
# Fewest intervals between droppers in a span that make droppers a repetition of their own.
FEWEST_INTERVALS = 2.0


@dataclass(frozen=True)
class LineCoordinate:
    """Places of supports, and of droppers (or hangers) that hold the contact wire, in m."""

    supports: Floats
    droppers: Floats

    @classmethod
    def of(cls, line: Line) -> "LineCoordinate":
        """Return the places of a line as designed: a dropper that is missing has its place."""
        supports = line.support_positions()
        held = [
            left + place
            for left, span in zip(supports, line.span_list(), strict=False)
            for place in span.holders.positions
        ]
        return cls(np.array(supports), np.unique(held))

    def spans(self, x: Floats) -> Floats:
        """Return the number of spans from the first support to places in m, fractions included."""
        return _counted(x, self.supports)

    def intervals(self, x: Floats) -> Floats:
        """Return the number of dropper intervals from the first dropper to places in m."""
        return _counted(x, self.droppers)

    def intervals_per_span(self, begin: float, end: float) -> float | None:
        """Return the mean number of dropper intervals in a span of a stretch in m.

        None where droppers are no repetition of their own: there are none, or hardly one a span.
        """
        if self.droppers.size <= 1:
            return None
        ends = np.array([begin, end])
        per_span = float(np.ptp(self.intervals(ends)) / np.ptp(self.spans(ends)))
        return per_span if per_span >= FEWEST_INTERVALS else None

    def hangs_alike(self, begin: float, end: float) -> bool:
        """Say whether the droppers stand at the same parts of all spans that a stretch touches."""
        ends = self.spans(np.array([begin, end]))
        first, last = np.floor(ends[0] + SAME_PART), np.floor(ends[1] - SAME_PART)
        at = self.spans(self.droppers)
        number = np.floor(at)
        parts = [at[number == one] - one for one in np.arange(first, last + 1)]
        return all(
            one.size == parts[0].size and bool(np.all(np.abs(one - parts[0]) <= SAME_PART))
            for one in parts
        )


def _counted(x: Floats, marks: Floats) -> Floats:
    """Return places counted in intervals between marks; beyond them, in the outermost ones."""
    count: Floats = np.interp(x, marks, np.arange(marks.size, dtype=np.float64))
    before, behind = x < marks[0], x > marks[-1]
    count[before] = (x[before] - marks[0]) / (marks[1] - marks[0])
    count[behind] += (x[behind] - marks[-1]) / (marks[-1] - marks[-2])
    return count
