"""A simple line as two tensioned beams joined by springs, exactly; independent of the program.

Between supports, droppers and the force there is nothing but beam, whose exact stiffness is known
(`beams.stiffness`): no mesh. Both beams are hinged at both ends of the line, the upper one turns
freely at its supports. Sag counts in one way only: as the upper beam rises by u from its shape z₀,
its length changes by ∫ z₀′ u′ dx, and between fixed ends a tension EA/L times that comes up.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from tests.support.beams import Floats, stiffness

# Places that are nearer than this are one, in m.
NEAR = 1e-6


@dataclass(frozen=True)
class Wire:
    """Tension in N and bending stiffness in N m² of a beam."""

    tension: float
    bending: float

    @property
    def rounding(self) -> float:
        """Length ℓ in m over which bending rounds a kink."""
        return float(np.sqrt(self.bending / self.tension))


def hung_string(
    span: float, tension: float, weight: float, places: Any, loads: Any
) -> Callable[[float], float]:  # fmt: skip
    """Height over its supports of a string of many spans with the same loads in N in each."""

    def height(x: float) -> float:
        x = x % span
        left, right = np.minimum(x, places), span - np.maximum(x, places)
        return float(-(weight * x * (span - x) / 2 + (loads * left * right).sum() / span) / tension)

    return height


@dataclass(frozen=True)
class TwoBeams:
    """Spans of one length in m; stiffnesses of dropper, upper support and arm in N/m.

    Attributes
    ----------
    axial
        EA/L in N/m of the upper wire between fixed ends, 0 if it yields.
    shape
        Heights z₀ in m of the upper wire over places in m; needed with that.
    """

    spans: int
    span: float
    droppers: tuple[float, ...]
    lower: Wire
    upper: Wire
    dropper: float
    support: float
    arm: float
    axial: float = 0.0
    shape: Any = None

    @property
    def supports(self) -> Floats:
        return np.arange(self.spans + 1) * self.span

    @property
    def hung(self) -> Floats:
        """Places of all droppers in m."""
        return np.concatenate([start + np.array(self.droppers) for start in self.supports[:-1]])

    def lift(self, x: float, force: float = 1.0, carried: float = np.inf) -> float:
        """Rise in m at x under a force in N, where each dropper carries so much in N at rest."""
        slack = np.zeros(len(self.hung), dtype=bool)
        for _ in range(len(slack)):
            system = _System(self, x, slack)
            u = system.solve(x, force, carried)
            tension = carried + self.dropper * (u[system.above] - u[system.below])
            found = tension < 0.0
            if (found == slack).all():
                return float(u[system.row(x)])
            slack = found
        raise AssertionError("which droppers are slack is not found")


class _System:
    """Equations with a force at a place and some droppers slack.

    Unknown are rise and turn of each lower node, then rise, turn before and turn behind of each
    upper one; only at its supports do these differ.
    """

    def __init__(self, line: TwoBeams, x: float, slack: Any) -> None:
        self.line, self.slack = line, slack
        self.low = _places([*line.supports, *line.hung, x])
        self.high = _places([*line.supports, *line.hung])
        self.first = 2 * len(self.low)
        self.below = np.array([self.row(place) for place in line.hung])
        self.above = np.array([self.upper_row(place) for place in line.hung])
        self.matrix = np.zeros((self.first + 3 * len(self.high),) * 2)
        self._add_wires()
        self._add_springs()

    def row(self, x: float) -> int:
        return 2 * int(np.argmin(np.abs(self.low - x)))

    def upper_row(self, x: float) -> int:
        return self.first + 3 * int(np.argmin(np.abs(self.high - x)))

    def _turn(self, x: float, behind: bool) -> int:
        hinge = np.abs(self.line.supports[1:-1] - x).min() < NEAR
        return self.upper_row(x) + (2 if hinge and behind else 1)

    def _add(self, rows: list[int], part: Any) -> None:
        self.matrix[np.ix_(rows, rows)] += part

    def _add_wires(self) -> None:
        lower, upper = self.line.lower, self.line.upper
        for a, b in pairwise(self.low):
            rows = [self.row(a), self.row(a) + 1, self.row(b), self.row(b) + 1]
            self._add(rows, stiffness(b - a, lower.tension, lower.bending))
        stretch = np.zeros(len(self.matrix))
        for a, b in pairwise(self.high):
            ends = [self.upper_row(a), self.upper_row(b)]
            rows = [ends[0], self._turn(a, True), ends[1], self._turn(b, False)]
            self._add(rows, stiffness(b - a, upper.tension, upper.bending))
            if self.line.axial:
                slope = (self.line.shape(b) - self.line.shape(a)) / (b - a)
                stretch[ends] += [-slope, slope]
        self.matrix += self.line.axial * np.outer(stretch, stretch)

    def _add_springs(self) -> None:
        for below, above in zip(self.below[~self.slack], self.above[~self.slack], strict=True):
            self._add([below, above], self.line.dropper * np.array([[1.0, -1.0], [-1.0, 1.0]]))
        for place in self.line.supports[1:-1]:
            self._add([self.row(place)], self.line.arm)
            self._add([self.upper_row(place)], self.line.support)

    def solve(self, x: float, force: float, carried: float) -> Floats:
        """Rises and turns; what slack droppers carried at rest is taken off."""
        load = np.zeros(len(self.matrix))
        load[self.row(x)] = force
        load[self.below[self.slack]] -= carried if self.slack.any() else 0.0
        load[self.above[self.slack]] += carried if self.slack.any() else 0.0
        free = np.diag(self.matrix) > 0.0
        ends = self.line.supports[[0, -1]]
        free[[self.row(end) for end in ends] + [self.upper_row(end) for end in ends]] = False
        found = np.zeros(len(load))
        found[free] = np.linalg.solve(self.matrix[np.ix_(free, free)], load[free])
        return found


def _places(given: list[float]) -> Floats:
    """Return places in order, each once."""
    ordered = np.sort(given)
    return ordered[np.concatenate([[True], np.diff(ordered) > NEAR])]
