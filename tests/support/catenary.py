"""A heavy wire that stretches: the exact curve it hangs in.

Independent of the program: no elements, only the balance of a piece of wire. With H the horizontal
tension, V what hangs below the first end and w the weight, all along the unstretched length σ,

    N² = H² + (V − wσ)²     dx/dσ = s(N) H/N     dz/dσ = −s(N) (V − wσ)/N

s(N) is the stretch under the tension N. For Hooke's law the integrals are elementary (Irvine, Cable
Structures, 1981); here they are taken by Gauss's rule, so that any law will do.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.polynomial.legendre import leggauss
from scipy.optimize import brentq, fsolve

Law = Callable[[Any, float], Any]
# Tension along a span is smooth on the scale H/w: forty points are exact to rounding.
POINTS, WEIGHTS = leggauss(40)


def hooke(tension: Any, axial: float) -> Any:
    """Stretch by N = EA (s − 1)."""
    return 1.0 + tension / axial


def green(tension: Any, axial: float) -> Any:
    """Stretch by N = EA ½ (s² − 1) s, the law of the cubic elements, by Newton's method."""
    s = 1.0 + tension / axial
    for _ in range(20):
        s = s - (0.5 * (s * s - 1.0) * s - tension / axial) / (0.5 * (3.0 * s * s - 1.0))
    return s


@dataclass(frozen=True)
class Catenary:
    """Weight and tensions in N/m and N, unstretched length in m; the first end is at x = z = 0."""

    weight: float
    axial: float
    law: Law
    horizontal: float
    hanging: float
    rest: float

    def tension(self, sigma: Any) -> Any:
        return np.hypot(self.horizontal, self.hanging - self.weight * sigma)

    def at(self, sigma: Any) -> tuple[Any, Any]:
        """Coordinates x and z (up) at unstretched lengths σ from the first end."""
        half = 0.5 * np.asarray(sigma, dtype=float)[..., None]
        along = half * (1.0 + POINTS)
        tension = self.tension(along)
        stretch = half * WEIGHTS * self.law(tension, self.axial) / tension
        x = (stretch * self.horizontal).sum(-1)
        z = -(stretch * (self.hanging - self.weight * along)).sum(-1)
        return x, z

    def height(self, x: Any) -> Any:
        """Height z over the place x, by Newton's method on σ."""
        sigma = np.asarray(x) * self.rest / self.at(self.rest)[0]
        for _ in range(20):
            tension = self.tension(sigma)
            slope = self.law(tension, self.axial) * self.horizontal / tension
            sigma = sigma - (self.at(sigma)[0] - x) / slope
        return self.at(sigma)[1]


def of_tension(
    span: float, weight: float, axial: float, horizontal: float, law: Law, *, rise: float = 0.0
) -> Catenary:
    """The wire of a horizontal tension between two ends, the second one higher by the rise."""

    def made(rest: float, hanging: float) -> Catenary:
        return Catenary(weight, axial, law, horizontal, hanging, rest)

    def missed(unknown: Any) -> Any:
        x, z = made(*unknown).at(unknown[0])
        return [x - span, z - rise]

    guess = [np.hypot(span, rise), 0.5 * weight * span - horizontal * rise / span]
    return made(*fsolve(missed, guess, xtol=1e-13))


def with_ends(
    before: Catenary, longer: float, weight: float, stiffness: float | None
) -> tuple[Catenary, float]:
    """A level wire whose unstretched length and weight have changed, and the way of its second end.

    Parameters
    ----------
    before
        The wire that was tensioned.
    longer
        Factor on its unstretched length.
    weight
        In N per metre of that.
    stiffness
        Of a spring at the second end in N/m; None: the end is fixed; 0: constant force.
    """
    span = before.at(before.rest)[0]
    rest = before.rest * longer

    def made(horizontal: float) -> Catenary:
        return replace(
            before, weight=weight, horizontal=horizontal, hanging=0.5 * weight * rest, rest=rest
        )

    def way(horizontal: float) -> float:
        return float(made(horizontal).at(rest)[0] - span)

    if stiffness == 0.0:
        found = before.horizontal
    elif stiffness is None:
        found = brentq(way, 1.0, 10 * before.horizontal, xtol=1e-10)
    else:
        k = stiffness
        found = brentq(
            lambda h: k * way(h) - before.horizontal + h, 1.0, 10 * before.horizontal, xtol=1e-10
        )
    return made(found), way(found)
