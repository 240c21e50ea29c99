"""Tensioned beams at rest, exactly: T v″ − EI v⁗ = −q, v downwards, small slopes.

ℓ = √(EI/T) is the length over which bending rounds a kink. A chain of segments h has differences
for derivatives: 2 sinh(h/2ℓ′) = h/ℓ gives its ℓ′. Independent of the program.
"""

from dataclasses import dataclass
from math import asinh, cosh, sinh, sqrt, tanh
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Beam:
    """A beam hinged at both ends; a chain where the length of its segments is given. SI units."""

    span: float
    tension: float
    bending: float
    segment: float | None = None

    @property
    def rounding(self) -> float:
        """Length ℓ (or ℓ′ of a chain) in m."""
        ell = sqrt(self.bending / self.tension)
        h = self.segment
        return ell if h is None else 0.5 * h / asinh(0.5 * h / ell)

    def under_weight(self, x: Any, weight: float) -> Any:
        """Sag in m at places x under a weight in N/m."""
        ell, span = self.rounding, self.span
        rounded = 1.0 - np.cosh((x - 0.5 * span) / ell) / cosh(0.5 * span / ell)
        string = 0.5 * x * (span - x)
        return weight / self.tension * (string - self.bending / self.tension * rounded)

    def under_force(self, x: Any, force: float, at: float) -> Any:
        """Sag in m at places x under a force in N at one place.

        ℓ sinh a sinh b/sinh c, c = a + b + what is between, by exponentials that do not overflow;
        of a chain h/sinh(h/ℓ′) stands for ℓ.
        """
        ell, h = self.rounding, self.segment
        left, right = np.minimum(x, at), self.span - np.maximum(x, at)

        def less(length: Any) -> Any:
            return 1.0 - np.exp(-2.0 * length / ell)

        between = np.exp(-(self.span - left - right) / ell)
        factor = ell if h is None else h / sinh(h / ell)
        rounded = 0.5 * factor * between * less(left) * less(right) / less(self.span)
        return force / self.tension * (left * right / self.span - rounded)


def stiffness(length: float, tension: float, bending: float) -> Floats:
    """Forces and moments at both ends for unit deflections and turns there (v₁, θ₁, v₂, θ₂).

    From v = A + Bx + C cosh(x/ℓ) + D sinh(x/ℓ); divided by cosh, as above. A string has no turns.
    """
    if bending == 0.0:
        pull = tension / length * np.array([[1.0, -1.0], [-1.0, 1.0]])
        return np.kron(pull, np.diag([1.0, 0.0]))
    u = length * sqrt(tension / bending)
    th, sech = tanh(u), 1.0 / cosh(min(u, 700.0))
    over = bending / (length * (2.0 * sech - 2.0 + u * th))
    near, far = over * u * (u - th), over * u * (th - u * sech)
    turn = (near + far) / length
    shift = 2.0 * turn / length + tension / length
    return np.array(
        [
            [shift, turn, -shift, turn],
            [turn, near, -turn, far],
            [-shift, -turn, shift, -turn],
            [turn, far, -turn, near],
        ]
    )
