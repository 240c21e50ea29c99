"""Rows that are recorded of a scenario and its limit."""

from typing import Any

import numpy as np

from tests.support.against_limit import GOAL_AT_REST, Compared
from tests.support.assessed import QUANTITIES
from tests.support.limit import AGREEMENT

GOALS = (
    "1 % of mean, deviation, maximum and uplift, minima 1 % of the mean force, 1.5 % of trailing"
    " pantographs: less than any measurement tells; where contact is lost, the spread over eight"
    " starts if that is more"
)
AT_REST = f"{GOAL_AT_REST} % of elasticity, of the mean dropper force and of arms: measured to 1 %"
NEITHER = "half of what the goals are; what is assessed cannot be sure of less"
ALIKE = "a criterion is too close to tell within 1.5 % of its limit, losses within one of 5 ms"


def record(evidence: Any, name: str, found: Compared) -> None:
    """Record all that is held against a limit."""
    if not found.right.right.loses_contact:
        evidence.below(
            f"{name}: families of the limit", found.right.apart, AGREEMENT, unit="%", reason=NEITHER
        )
    evidence.below(f"{name}: at rest", found.share_at_rest, 1.0, unit="of its goal", reason=AT_REST)
    evidence.below(
        f"{name}: run", found.share, 1.0, unit="of its goal", reason=GOALS, table=_table(found)
    )
    evidence.same(
        f"{name}: verdicts",
        compared=len(found.right.right.verdicts),
        differing=len(found.verdicts),
        reason=ALIKE,
    )


def _table(found: Compared) -> list[list[float]]:
    """Return a line for each pantograph: its numbers, and by how much each is off.

    Before them one of the line: uplift in mm and by how much it is off, elasticity, droppers and
    arms, what the families differ by, and how many numbers are held against their spread.
    """
    right, count = found.right.right, len(QUANTITIES)
    rest = [found.rest[name] for name in ("elasticity", "droppers", "arms")]
    first = [right.uplift_mm, float(found.off[-1]), *rest, found.right.apart]
    rows = [[*first, float(len(found.scattered))]]
    off = np.reshape(found.off[:-1], (-1, count))
    return rows + [[*own, *map(float, row)] for own, row in zip(right.forces_N, off, strict=True)]
