"""Observations of a run that the conclusions of the founding paper speak of."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from arcless.validate.hanger_joints import JointChanges, joint_changes

if TYPE_CHECKING:
    from arcless.results import Result

# Smaller gaps, in mm, are not counted: round-off is far below this, the gaps of a wire above.
SMALLEST_GAP = 1e-3


@dataclass(frozen=True, slots=True)
class Observation:
    """Observations of a run for the conclusions, of its first pantograph inside the section.

    Attributes
    ----------
    speed
        Speed, m/s.
    low, high
        Lowest and highest contact force, unfiltered, N.
    changes
        Its changes at hanger joints and elsewhere.
    gap
        Largest gap, mm.
    gaps_at
        Where gaps are largest, one place for each gap, m.
    loss
        Share of time without contact, %.
    """

    speed: float
    low: float
    high: float
    changes: JointChanges
    gap: float
    gaps_at: tuple[float, ...]
    loss: float

    @property
    def width(self) -> float:
        """Width of the interval of the contact force, N."""
        return self.high - self.low

    @property
    def kmh(self) -> str:
        """Speed as text."""
        return f"{3.6 * self.speed:.0f} km/h"


def observe(result: "Result") -> Observation:
    """Return the observations that the conclusions speak of."""
    dataset = result.dataset
    begin, end = result.assessment.section_m
    x, force, gap = (
        dataset[name].values[:, 0] for name in ("position", "contact_force", "contact_gap")
    )
    numbers = result.assessment.pantographs[0]
    inside = (x >= begin) & (x <= end)
    open_ = inside & (1e3 * gap > SMALLEST_GAP)
    turns = np.flatnonzero(np.diff(np.concatenate(([0], open_, [0]))))
    places = [first + int(np.argmax(gap[first:last])) for first, last in turns.reshape(-1, 2)]
    return Observation(
        speed=result.assessment.speed_m_s,
        low=numbers.unfiltered_min_force_N,
        high=numbers.unfiltered_max_force_N,
        changes=joint_changes(x, force, dataset["dropper_x"].values, (begin, end)),
        gap=1e3 * float(gap[inside].max()),
        gaps_at=tuple(float(x[place]) for place in places),
        loss=numbers.contact_loss_percent,
    )
