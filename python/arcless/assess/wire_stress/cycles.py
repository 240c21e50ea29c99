"""Cycles of a stress history by rainflow counting (ASTM E1049-85, mark C: not read by us).

With the exponent m of a Wöhler line N Δσ^m = const. and Palmgren and Miner's sum, the cycles n_i of
ranges Δσ_i do the damage of a single one of the equivalent range

  Δσ_e = (Σ n_i Δσ_i^m)^(1/m)

so that N(Δσ_e) passages are the life that the line gives. Neither m nor the line is known here.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Self

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError, OutputError
from arcless.units import show

Floats = NDArray[np.float64]

# Exponents of Wöhler lines of metals lie between 3 and some 15; outside, a typing error.
EXPONENTS = (1.0, 30.0)


@dataclass(frozen=True)
class Cycles:
    """Ranges of the cycles in Pa, largest first, and how often each was counted: 1, or ½."""

    ranges: Floats
    counts: Floats

    @classmethod
    def of(cls, history: Floats | Sequence[float]) -> Self:
        """Count the cycles of a history in Pa.

        Raises
        ------
        OutputError
            The package rainflow is not installed.
        """
        if find_spec("rainflow") is None:
            raise OutputError(
                "cycles of stress need the package rainflow, which is not installed",
                hint="pip install 'arcless[fatigue]'",
            )
        import rainflow

        all_of_them = rainflow.extract_cycles(history)
        found = [(span, count) for span, _, count, _, _ in all_of_them if span > 0.0]
        found.sort(reverse=True)
        pairs = np.array(found, dtype=float).reshape(-1, 2)
        return cls(pairs[:, 0], pairs[:, 1])

    @property
    def largest(self) -> float:
        """Largest range in Pa; 0 of a history that stays the same."""
        return float(self.ranges[0]) if len(self.ranges) else 0.0

    @property
    def count(self) -> float:
        """Number of cycles, half ones as ½."""
        return float(self.counts.sum())

    def equivalent_range(self, exponent: float) -> float:
        """Return Δσ_e in Pa for the exponent m of a Wöhler line."""
        check_exponent(exponent)
        if self.largest == 0.0:
            return 0.0
        # Over the largest range: powers of pascals would overflow.
        damage = float((self.counts * (self.ranges / self.largest) ** exponent).sum())
        return self.largest * float(damage ** (1.0 / exponent))


def check_exponent(exponent: float | str) -> float:
    """Return an exponent of a Wöhler line, which may be a text, as a number.

    Raises
    ------
    ModelError
        It is no number, or outside of `EXPONENTS`.
    """
    low, high = EXPONENTS
    expected = f"a number, {low:g} to {high:g}"
    try:
        number = float(exponent)
    except (TypeError, ValueError):
        number = math.nan
    if not low <= number <= high:
        raise ModelError("exponent of the Wöhler line", got=show(exponent), expected=expected)
    return number
