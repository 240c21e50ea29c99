"""Natural frequencies of a pantograph whose strip stands on the elasticity of the line.

    (k_p + s e eᵀ − ω² m) φ = 0,   1/s = e_line + 1/(n k_c)

with the matrices m, k_p of the pantograph, the vector e that picks the height of its strips, the
elasticity e_line of the line, and n contacts of stiffness k_c. It is the line as a spring without
mass: right where the pantograph swings slower than a span does, and a guess above that.
Source: T. X. Wu & M. J. Brennan, J. Sound Vib. 219 (1999) 483 (abstract) for pantograph and line as
one oscillator on a stiffness that varies along the span.
"""

from dataclasses import dataclass
from math import inf, pi

import numpy as np
from numpy.typing import NDArray

from arcless.model.pantograph.joint import Joint
from arcless.model.pantograph.pantograph import Pantograph
from arcless.pantograph.equation_of_motion import matrices, raising_the_strips

Floats = NDArray[np.float64]

# Share of a mode's elastic energy that is the line's: with less, the line neither makes it nor
# moves it.
LEAST_SHARE = 0.01


@dataclass(frozen=True)
class Band:
    """A value with the lowest and the highest that it stands for, in one unit."""

    low: float
    middle: float
    high: float

    def scaled(self, factor: float) -> "Band":
        """Return it times a positive factor."""
        return Band(factor * self.low, factor * self.middle, factor * self.high)


@dataclass(frozen=True)
class PantographMode:
    """A natural mode of a pantograph on the line.

    Attributes
    ----------
    frequency
        In Hz at the largest, the mean and the lowest elasticity.
    damping_ratio
        φᵀcφ/2ω of the pantograph's linear dampers, 1; friction, dampers with a table and the line
        take energy away beyond it.
    share
        Share of its elastic energy that is in the line, 1.
    """

    frequency: Band
    damping_ratio: float
    share: float


def why_no_modes(pantograph: Pantograph) -> str | None:
    """Return why a pantograph has no natural frequencies of its own; None where it has."""
    if pantograph.fmu is not None:
        return "an FMU does not say what is inside: no natural frequencies are known"
    joints: dict[str, Joint] = {f"masses.{i}": one for i, one in enumerate(pantograph.masses)}
    if pantograph.matrices is not None:
        of_matrices = enumerate(pantograph.matrices.joints)
        joints = {f"matrices.joints.{i}": joint for i, joint in of_matrices}
    for place, joint in joints.items():
        if joint.stiffness_table is not None:
            field = f"{place}.stiffness_table"
            return f"{field} is no constant: it has no natural frequency for all amplitudes"
    return None


def modes(
    pantograph: Pantograph, elasticity: Band, contact_stiffness: float
) -> list[PantographMode]:
    """Return the modes of a pantograph that the line takes part in, slowest first.

    Parameters
    ----------
    pantograph
        A chain of masses or matrices, without tables.
    elasticity
        Of the line, m/N.
    contact_stiffness
        Of one contact in N/m, infinite for a rigid one.
    """
    found = matrices(pantograph)
    m, c, k = found.mass, found.damping, found.stiffness
    height, strips = raising_the_strips(pantograph), 1
    if pantograph.head is not None:
        strips = pantograph.head.strips
    contact = 0.0 if contact_stiffness == inf else 1.0 / (strips * contact_stiffness)
    rows = [
        _modes(m, c, k, height, 1.0 / (value + contact))
        for value in (elasticity.high, elasticity.middle, elasticity.low)
    ]
    slow, mean, fast = (each[:, 0] for each in rows)
    return [
        PantographMode(Band(*map(float, ends)), float(zeta), float(share))
        for ends, (_, zeta, share) in zip(zip(slow, mean, fast, strict=True), rows[1], strict=True)
        if share >= LEAST_SHARE
    ]


def _modes(m: Floats, c: Floats, k: Floats, height: Floats, spring: float) -> Floats:
    """Return frequency in Hz, damping ratio and share of the spring of each mode, row by row."""
    lower = np.linalg.cholesky(m)
    half = np.linalg.solve(lower, k + spring * np.outer(height, height))
    squares, vectors = np.linalg.eigh(np.linalg.solve(lower, half.T))
    omega = np.sqrt(np.maximum(squares, 0.0))
    shapes = np.linalg.solve(lower.T, vectors)
    moving = omega > 0.0
    omega, shapes = omega[moving], shapes[:, moving]
    zeta = np.einsum("ij,ik,kj->j", shapes, c, shapes) / (2.0 * omega)
    share = spring * (height @ shapes) ** 2 / omega**2
    return np.column_stack([omega / (2.0 * pi), zeta, share])
