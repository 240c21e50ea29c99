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
from math import pi

import numpy as np
from numpy.typing import NDArray

from arcless.model.pantograph.head import CollectorHead
from arcless.simulate.setup.core_data import StripData

Floats = NDArray[np.float64]

# Knots per strip for mode shapes: the straight pieces between them miss a cubic spline of a first
# bending mode (wave length about twice the strip) by π²/8/40² < 0.1 % of its amplitude.
SHAPE_KNOTS = 81


@dataclass(frozen=True)
class HeadRows:
    """Rows that a head adds to a chain of `below` masses; matrices are those of all coordinates."""

    mass: Floats
    damping: Floats
    stiffness: Floats
    lift: Floats
    strips: list[StripData]


def add_head(head: CollectorHead, below: int) -> HeadRows:
    """Return matrices (n × n), aerodynamic coefficients (n) and strips of a head.

    Parameters
    ----------
    head
        Its strips.
    below
        Number of masses of the chain it stands on; their rows are zero except for the suspension.
    """
    size = below + head.size
    mass, damping, stiffness = (np.zeros((size, size)) for _ in range(3))
    lift = np.zeros(size)
    for number in range(head.strips):
        first = below + number * head.strip_size
        joint = np.zeros(size)
        joint[first], joint[below - 1] = 1.0, -1.0
        mass[first, first] = head.mass
        damping += head.damping * np.outer(joint, joint)
        stiffness += head.stiffness * np.outer(joint, joint)
        lift[first] = head.aerodynamic
        for row, (inertia, viscosity, spring) in enumerate(_own(head), start=first + 1):
            mass[row, row], damping[row, row], stiffness[row, row] = inertia, viscosity, spring
    strips = [_strip(head, below, number) for number in range(head.strips)]
    return HeadRows(mass, damping, stiffness, lift, strips)


def _own(head: CollectorHead) -> list[tuple[float, float, float]]:
    """Return inertia, damping and stiffness of roll and modes of a strip."""
    own = []
    if head.roll is not None:
        own.append((head.roll.inertia, head.roll.damping, head.roll.stiffness))
    for mode in head.modes:
        omega = 2.0 * pi * mode.frequency
        viscosity = 2.0 * mode.damping_ratio * omega * mode.modal_mass
        own.append((mode.modal_mass, viscosity, mode.modal_mass * omega**2))
    return own


def _strip(head: CollectorHead, below: int, number: int) -> StripData:
    places = _knots(head)
    shapes = [np.ones(len(places))]
    if head.roll is not None:
        shapes.append(places)
    shapes.extend(_mode_shapes(head, places))
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


def _mode_shapes(head: CollectorHead, places: Floats) -> list[Floats]:
    if not head.modes:
        return []
    from scipy.interpolate import CubicSpline

    return [np.asarray(CubicSpline(head.shape_positions, m.shape)(places)) for m in head.modes]
