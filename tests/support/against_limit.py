"""Errors of a scenario as it is shipped, in shares of the goals."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

import arcless
from tests.support import at_rest
from tests.support.assessed import QUANTITIES, Assessed, differences
from tests.support.limit import Limit, limit, with_forces
from tests.support.starts import spread

Floats = NDArray[np.float64]
# In percent of the value, minima of the mean force: an assessment tells nothing smaller.
GOAL, GOAL_TRAILING = 1.0, 1.5
GOAL_AT_REST = 0.3
# One loss of 5 ms, the shortest that counts as an arc, in the 5 s that a section takes.
ONE_LOSS_PERCENT = 0.1
UPLIFT = "uplift at supports"


@dataclass(frozen=True)
class Compared:
    """Comparison of a scenario with its limit; differences and goals in percent.

    Attributes
    ----------
    names : what each number is
    off, goals : by how much it is off, and may be
    right : the limit, and what both families of it differ by
    rest : largest differences at rest: elasticity, droppers, arms
    verdicts : criteria that are judged otherwise than by the limit, and not too close to tell
    close : criteria that are too close to tell
    scattered : numbers whose yardstick is their spread over starts, since contact is lost
    """

    names: list[str]
    off: Floats
    goals: Floats
    right: Limit
    rest: dict[str, float]
    verdicts: list[str]
    close: list[str]
    scattered: list[str] = field(default_factory=list)

    @property
    def share(self) -> float:
        """Largest difference of a run over its goal."""
        return float(np.max(np.abs(self.off) / self.goals))

    @property
    def share_at_rest(self) -> float:
        """Largest difference at rest over its goal."""
        return max(self.rest.values()) / GOAL_AT_REST

    @property
    def worst(self) -> str:
        """Name the number that is off most."""
        index = int(np.argmax(np.abs(self.off) / self.goals))
        return f"{self.names[index]} {self.off[index]:+.2f} %"


def compare(scenario: arcless.Scenario, changes: dict[str, Any] | None = None) -> Compared:
    """Hold a scenario, with changes by dotted path, against the limit of it without them."""
    given = with_forces(scenario)
    asked = given.with_(**(changes or {}))
    right, found = limit(given), Assessed.of(arcless.run(asked))
    off, goals = differences(found, right.right), _goals(len(given.pantographs))
    scattered: list[str] = []
    if right.right.loses_contact and np.any(np.abs(off) > goals):
        scatter = np.where(_lost(right.right), spread(given), 0.0)
        scattered = [
            name
            for name, one, goal in zip(_names(given), scatter, goals, strict=True)
            if one > goal
        ]
        goals = np.maximum(goals, scatter)
    differing, close = _verdicts(found, right.right)
    mean, _ = at_rest.limit_at_rest(given)
    rest = at_rest.off(at_rest.at_rest(asked), mean)
    return Compared(_names(given), off, goals, right, rest, differing, close, scattered)


def _names(scenario: arcless.Scenario) -> list[str]:
    own = [f"{what} of {place.name}" for place in scenario.pantographs for what in QUANTITIES]
    return [*own, UPLIFT]


def _goals(pantographs: int) -> Floats:
    trailing = [GOAL_TRAILING] * (len(QUANTITIES) * (pantographs - 1))
    return np.array([*[GOAL] * len(QUANTITIES), *trailing, GOAL])


def _lost(right: Assessed) -> NDArray[np.bool_]:
    """Tell for each number whether it is one of a pantograph that loses contact."""
    own = [loss > 0.0 for loss in right.loss_percent for _ in QUANTITIES]
    return np.array([*own, False])


def _verdicts(found: Assessed, right: Assessed) -> tuple[list[str], list[str]]:
    """Return criteria judged otherwise, and those whose limit is nearer than the goal."""
    differing, close = [], []
    for one, other in _judged(found, right):
        name, value, bound, passed = other
        near = bound is not None and abs(value - bound) <= _room(name, value, right)
        if near:
            close.append(name)
        elif passed != one[3]:
            differing.append(name)
    return differing, close


def _room(name: str, value: float, right: Assessed) -> float:
    """Return how near to its limit a criterion is too close to tell, in its own unit."""
    if name.startswith("contact_loss"):
        return ONE_LOSS_PERCENT
    scale = right.forces_N[0][0] if "min" in name else abs(value)
    return 0.01 * GOAL_TRAILING * scale


def _judged(found: Assessed, right: Assessed) -> Iterator[tuple[list[Any], list[Any]]]:
    known = {own[0]: own for own in found.verdicts}
    return ((known[own[0]], own) for own in right.verdicts if own[1] is not None)
