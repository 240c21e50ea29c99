"""The line at rest as figures need it: the part that is drawn, its spans, its elasticity."""

from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.initial_configuration import InitialConfiguration
from arcless.figures.description import Axis, Figure, Layer, Rules
from arcless.figures.run.track import GROUP, LABEL

Floats = NDArray[np.float64]

ALONG, ACROSS, UP = 0, 1, 2
# A longer line is drawn around its middle: a page of one kilometre has some 0.3 MB of data. In m.
DRAWN = 3000.0
# Spans on either side of the middle one that figures show first.
BESIDE = 1
# A place this near to a support, in m, is at it.
AT_SUPPORT = 1e-6


class LineData:
    """A line at rest, and the part of it that is drawn.

    Parameters
    ----------
    found
        The initial configuration.

    Attributes
    ----------
    begin, end
        Ends of the part that is drawn, in m.
    cut
        True where the line is longer than that.
    """

    def __init__(self, found: InitialConfiguration) -> None:
        self.found = found
        self.mesh, self.points = found.equilibrium.mesh, found.equilibrium.positions
        self.supports: Floats = np.array(found.equilibrium.support_places())
        first, last = float(self.supports[0]), float(self.supports[-1])
        middle = 0.5 * sum(found.equilibrium.middle_span())
        self.cut = last - first > DRAWN
        self.begin = max(first, middle - 0.5 * DRAWN) if self.cut else first
        self.end = min(last, middle + 0.5 * DRAWN) if self.cut else last

    @cached_property
    def whole(self) -> tuple[float, float]:
        """Ends in m of what a reader can see: the part that is drawn, with a margin."""
        margin = 0.02 * (self.end - self.begin)
        return self.begin - margin, self.end + margin

    @cached_property
    def shown(self) -> tuple[float, float]:
        """Ends in m of the spans that are shown first, with a margin."""
        number = self.found.middle_span - 1
        first, last = max(0, number - BESIDE), min(len(self.supports) - 1, number + 1 + BESIDE)
        left, right = float(self.supports[first]), float(self.supports[last])
        margin = 0.02 * (right - left)
        return max(left - margin, self.whole[0]), min(right + margin, self.whole[1])

    @property
    def axis(self) -> Axis:
        """Axis that the figures along the track share."""
        return Axis(LABEL, "m", *self.shown, bounds=self.whole, group=GROUP)

    @cached_property
    def spans(self) -> list[tuple[int, float, float]]:
        """Number from 1, begin and end in m of each span of the part that is drawn."""
        return [
            (number, left, right)
            for number, (left, right) in enumerate(pairwise(self.supports.tolist()), start=1)
            if self.begin <= left and right <= self.end
        ]

    @cached_property
    def elasticity(self) -> tuple[Floats, Floats]:
        """Positions in m along the part that is drawn, and elasticities there in m/N.

        Supports are among them. Every span has the places that the numbers of the middle one are
        from: spans that are alike have the same extremes, although droppers lie between places.
        """
        rest = self.found.equilibrium
        pieces = [rest.elasticity_positions(left, right) for _, left, right in self.spans]
        x = np.concatenate([*(piece[:-1] for piece in pieces), pieces[-1][-1:]])
        return x, rest.elasticity(x)

    def elasticity_of(self, left: float, right: float) -> Floats:
        """Return the elasticities in m/N between two places in m, both ends included."""
        x, values = self.elasticity
        return values[(x >= left - AT_SUPPORT) & (x <= right + AT_SUPPORT)]

    @property
    def overlaps(self) -> list[int]:
        """Numbers of the spans in which two tension lengths run side by side."""
        x = self.mesh.positions[:, ALONG]
        wires = [next(iter(own.contact.values())) for own in self.mesh.systems]
        ends = [(x[wire[0]], x[wire[-1]]) for wire in wires]
        return [
            number
            for number, left, right in self.spans
            if sum(bool(first < 0.5 * (left + right) < last) for first, last in ends) > 1
        ]

    def inside(self, x: Floats) -> NDArray[np.bool_]:
        """Tell for places in m whether they are drawn."""
        found: NDArray[np.bool_] = (x >= self.begin) & (x <= self.end)
        return found

    def support_rules(self) -> Rules:
        """Return the supports as lines from edge to edge."""
        at = self.supports[self.inside(self.supports)]
        return Rules(axis="x", at=at, colour="support", name="support", dash="dotted")

    def along(
        self, key: str, title: str, y: Axis, layers: Sequence[Layer], **more: str | int
    ) -> Figure:
        """Return a figure along the track; supports lie below its layers."""
        return Figure(key, title, self.axis, y, [self.support_rules(), *layers], **more)  # type: ignore[arg-type]
