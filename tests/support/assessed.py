"""Assessed numbers of a run, and their difference between two runs of one scenario."""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.results import Result

# What the strip of each pantograph is assessed by, in the order of the tables.
QUANTITIES = ("mean", "standard deviation", "maximum", "minimum")
# Uplift that is less than a tenth of a millimetre, as on a conductor rail, is compared as if it
# were that: a percent of it is nothing.
LEAST_UPLIFT_MM = 0.1


@dataclass(frozen=True)
class Assessed:
    """Numbers and verdicts of a run.

    Attributes
    ----------
    forces_N : mean, standard deviation, maximum and minimum of each pantograph
    uplift_mm : largest uplift at a support
    loss_percent : time without contact of each pantograph
    verdicts : criterion and pantograph, value, limit, and whether it is met
    """

    forces_N: list[list[float]]  # noqa: N815 - the unit is part of the name
    uplift_mm: float
    loss_percent: list[float]
    verdicts: list[list[Any]]

    @classmethod
    def of(cls, result: Result) -> "Assessed":
        """Take them from a result."""
        found = result.assessment
        own = [
            [p.mean_force_N, p.std_force_N, p.max_force_N, p.min_force_N] for p in found.pantographs
        ]
        return cls(
            forces_N=own,
            uplift_mm=found.max_uplift_at_support_mm or 0.0,
            loss_percent=[p.contact_loss_percent for p in found.pantographs],
            verdicts=[
                [f"{c.name} {c.pantograph or ''}".strip(), c.value, c.limit, c.passed]
                for c in found.criteria
            ],
        )

    @classmethod
    def between(cls, one: "Assessed", other: "Assessed", share: float = 0.5) -> "Assessed":
        """Return the mean of two, with the verdicts of the first; `share` is that of the other.

        With a negative share it is the continuation beyond the first.
        """
        return cls(
            forces_N=(
                (1.0 - share) * np.array(one.forces_N) + share * np.array(other.forces_N)
            ).tolist(),
            uplift_mm=(1.0 - share) * one.uplift_mm + share * other.uplift_mm,
            loss_percent=one.loss_percent,
            verdicts=one.verdicts,
        )

    @classmethod
    def from_plain(cls, data: dict[str, Any]) -> "Assessed":
        """Take back what `to_plain` gave."""
        return cls(**data)

    def to_plain(self) -> dict[str, Any]:
        """Return plain values, ready for JSON."""
        return asdict(self)

    @property
    def loses_contact(self) -> bool:
        """True when any pantograph leaves the wire while it is assessed."""
        return max(self.loss_percent) > 0.0

    def numbers(self) -> NDArray[np.float64]:
        """Return all numbers in a row: four of each pantograph, and the uplift."""
        return np.array([*np.ravel(self.forces_N), self.uplift_mm])

    def scales(self) -> NDArray[np.float64]:
        """Return what a percent of each number is a percent of: of a minimum, the mean force."""
        scale = np.array(self.forces_N)
        scale[:, 3] = scale[:, 0]
        return np.array([*np.ravel(scale), max(self.uplift_mm, LEAST_UPLIFT_MM)])


def differences(found: Assessed, right: Assessed) -> NDArray[np.float64]:
    """Return how far each number is off, in percent: minima of the mean force."""
    off: NDArray[np.float64] = 100.0 * (found.numbers() - right.numbers()) / right.scales()
    return off
