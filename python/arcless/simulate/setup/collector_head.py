"""Collector head → masses, dampers, springs of its strips, and where a wire touches them.

With the chain below, whose last mass stands at u, strip s has a height z, a roll angle θ (positive
when the side of positive y rises) and modal amplitudes q:

    m z̈ + c (ż − u̇) + k (z − u) = g V² − Σ λ
    J θ̈ + c_θ θ̇ + k_θ θ = −Σ λ y
    m_q (q̈ + 2 ζ ω q̇ + ω² q) = −Σ λ φ(y)

and its height where a wire touches it at y is z + y θ + Σ φ(y) q: the force of every wire enters by
the same vector as the height it feels. Small angles; the last mass itself does not roll.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.model.pantograph.head import CollectorHead
from arcless.pantograph.equation_of_motion import mode_shapes
from arcless.simulate.setup.core_data import StripData

Floats = NDArray[np.float64]

# Knots per strip for mode shapes: the straight pieces between them miss a cubic spline of a first
# bending mode (wave length about twice the strip) by π²/8/40² < 0.1 % of its amplitude.
SHAPE_KNOTS = 81


@dataclass(frozen=True)
class HeadParts:
    """Parts that a head adds to a chain besides its matrices; the chain's coordinates come first.

    `lift` has the aerodynamic coefficients of all coordinates.
    """

    lift: Floats
    strips: list[StripData]


def add_head(head: CollectorHead, below: int) -> HeadParts:
    """Return aerodynamic coefficients (n) and strips of a head.

    Parameters
    ----------
    head
        Its strips; their matrices are those of `arcless.pantograph.equation_of_motion`.
    below
        Number of masses of the chain it stands on.
    """
    lift = np.zeros(below + head.size)
    lift[[below + number * head.strip_size for number in range(head.strips)]] = head.aerodynamic
    return HeadParts(lift, [_strip(head, below, number) for number in range(head.strips)])


def _strip(head: CollectorHead, below: int, number: int) -> StripData:
    places = _knots(head)
    shapes = [np.ones(len(places))]
    if head.roll is not None:
        shapes.append(places)
    shapes.extend(mode_shapes(head, places))
    vectors = np.zeros((len(places), below + head.size))
    first = below + number * head.strip_size
    vectors[:, first : first + head.strip_size] = np.column_stack(shapes)
    return StripData(
        offset=head.offsets()[number],
        half_width=head.half_length,
        knots=places.tolist(),
        vectors=vectors.tolist(),
    )


def _knots(head: CollectorHead) -> Floats:
    if head.modes:
        return np.linspace(-head.half_length, head.half_length, SHAPE_KNOTS)
    if head.roll is not None:
        return np.array([-head.half_length, head.half_length])
    return np.zeros(1)
