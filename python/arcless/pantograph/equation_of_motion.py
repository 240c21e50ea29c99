"""Pantograph of the model → matrices of its equation of motion.

Spring and damper i join mass i of the chain to the one below, the first to the base; strips of a
collector head stand on the last mass, each on its own suspension (`CollectorHead`):

    M = diag(m_i),   K = Σ k_i e_i e_iᵀ,   C = Σ c_i e_i e_iᵀ

with the elongations e_i of the joints.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

import numpy as np
from numpy.typing import NDArray

from arcless.model.pantograph.head import CollectorHead, StripMode
from arcless.model.pantograph.pantograph import Pantograph

Floats = NDArray[np.float64]
Numbers = list[float]


@dataclass(frozen=True)
class Matrices:
    """Mass, damping and stiffness of all coordinates of a pantograph (n × n), SI units."""

    mass: Floats
    damping: Floats
    stiffness: Floats


def unit_vector(size: int, i: int) -> Numbers:
    """Return a vector of zeros with a one at `i`."""
    return [float(k == i) for k in range(size)]


def elongation(size: int, i: int) -> Numbers:
    """Return the elongation between mass i of a chain and the mass below, or the base."""
    joint = unit_vector(size, i)
    if i > 0:
        joint[i - 1] = -1.0
    return joint


def matrices(pantograph: Pantograph) -> Matrices:
    """Return the matrices of a pantograph; what is given by tables is no part of them.

    Parameters
    ----------
    pantograph
        A chain of masses, or matrices. A matrix that is symmetric apart from rounding is made so;
        any other keeps its bits.
    """
    if pantograph.matrices is not None:
        parts = pantograph.matrices
        given = [np.array(m) for m in (parts.mass, parts.damping, parts.stiffness)]
        return Matrices(*((m + m.T) / 2.0 for m in given))
    chain = _chain(pantograph)
    if pantograph.head is None:
        return chain
    head = head_matrices(pantograph.head, len(pantograph.masses))
    return Matrices(
        chain.mass + head.mass, chain.damping + head.damping, chain.stiffness + head.stiffness
    )


def _chain(pantograph: Pantograph) -> Matrices:
    masses, size = pantograph.masses, pantograph.size
    mass = np.diag([part.mass for part in masses] + [0.0] * (size - len(masses)))
    stiffness, damping = np.zeros((size, size)), np.zeros((size, size))
    for i, part in enumerate(masses):
        joint = np.array(elongation(size, i))
        stiffness += (part.stiffness or 0.0) * np.outer(joint, joint)
        damping += (part.damping or 0.0) * np.outer(joint, joint)
    return Matrices(mass, damping, stiffness)


def head_matrices(head: CollectorHead, below: int) -> Matrices:
    """Return the matrices of a head's strips on a chain of `below` masses.

    Rows of the chain are zero except for the suspension of the strips.
    """
    size = below + head.size
    mass, damping, stiffness = (np.zeros((size, size)) for _ in range(3))
    for number in range(head.strips):
        first = below + number * head.strip_size
        joint = np.zeros(size)
        joint[first], joint[below - 1] = 1.0, -1.0
        mass[first, first] = head.mass
        damping += head.damping * np.outer(joint, joint)
        stiffness += head.stiffness * np.outer(joint, joint)
        for row, (inertia, viscosity, spring) in enumerate(_of_strip(head), start=first + 1):
            mass[row, row], damping[row, row], stiffness[row, row] = inertia, viscosity, spring
    return Matrices(mass, damping, stiffness)


def _of_strip(head: CollectorHead) -> list[tuple[float, float, float]]:
    """Return inertia, damping and stiffness of roll and modes of a strip."""
    own = []
    if head.roll is not None:
        own.append((head.roll.inertia, head.roll.damping, head.roll.stiffness))
    for mode in head.modes:
        omega = 2.0 * pi * mode.frequency
        viscosity = 2.0 * mode.damping_ratio * omega * mode.modal_mass
        own.append((mode.modal_mass, viscosity, mode.modal_mass * omega**2))
    return own


def mode_shapes(head: CollectorHead, places: Sequence[float] | Floats) -> list[Floats]:
    """Return the bending modes of a strip at places across the track in m, by cubic splines."""
    if not head.modes:
        return []
    from scipy.interpolate import CubicSpline

    def at(mode: StripMode) -> Floats:
        return np.asarray(CubicSpline(head.shape_positions, mode.shape)(places))

    return [at(mode) for mode in head.modes]


def raising_the_strips(pantograph: Pantograph) -> Floats:
    """Return the coordinates that raise the middle of the strips, the mean of all (n)."""
    if pantograph.matrices is not None:
        return np.array(pantograph.matrices.strip)
    head, below = pantograph.head, len(pantograph.masses)
    if head is None:
        return np.array(unit_vector(pantograph.size, pantograph.size - 1))
    # Roll leaves the middle where it is.
    roll = [] if head.roll is None else [0.0]
    middle = [1.0, *roll, *(float(shape[0]) for shape in mode_shapes(head, [0.0]))]
    vector = np.zeros(pantograph.size)
    for number in range(head.strips):
        first = below + number * head.strip_size
        vector[first : first + head.strip_size] = middle
    return vector / head.strips
