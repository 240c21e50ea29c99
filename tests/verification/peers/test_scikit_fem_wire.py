"""Stepped wire with a mass and a spring, by scikit-fem

A straight wire of 30 m under T = 22 kN, pinned at both ends: a contact wire (1.35 kg/m,
EI 195 N m²) for 12 m, then a stiff insert (3 kg/m, EI 20 kN m²); a mass of 30 kg at 20 m, a spring
of 20 kN/m to ground at 24 m. It has no closed form. As a beam under tension (second order of
Euler and Bernoulli, any book on vibrations):

`∫ EI w″v″ + T w′v′ dx + k w v = ω² (∫ μ w v dx + m w v)`,    or `= F v` at rest

with Hermite elements of scikit-fem of 0.05 m, which resolve `√(EI/T)` = 0.1 m. So here the theory
is another one, too: straight, linear, and without a coordinate along the wire.

Arcless counts along the unstretched wire. With the stretch λ, `EA ½ (λ² − 1) λ = T`, what it has
per unstretched metre is per metre of the wire under tension μ/λ, and EI/λ (its bending energy is
½ EI κ² per unstretched metre). λ − 1 is 1.5e-3, so this has to be respected; it follows from the
definitions and is fitted to nothing. Its elements are 0.0625 m long, gravity is zero.
The record was written with scikit-fem 12.0.2.
"""

from typing import Any

import numpy as np
import pytest

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.mesh.tables.parts import Parts
from tests.support.faults import Fault, scaled
from tests.support.structures import add_element, at_rest, mesh_of

pytest.importorskip("skfem", reason="scikit-fem is not installed: `make peers`")

import skfem
from scipy.sparse import diags
from scipy.sparse.linalg import eigsh, splu
from skfem.helpers import d, dd

LENGTH, STEP, MASS_AT, SPRING_AT = 30.0, 12.0, 20.0, 24.0
T, EA, MASS, SPRING = 22e3, 15e6, 30.0, 20e3
PIECES = ((195.0, 1.35), (20e3, 3.0))  # EI N m², kg/m
ELEMENT, FINE = 0.0625, 0.05
ALONG, UP, GIVEN = 0, 1, 0
FREQUENCIES = 8


def stretch() -> float:
    """λ of EA ½ (λ² − 1) λ = T."""
    roots = np.roots([0.5 * EA, 0.0, -0.5 * EA, -T])
    return float(max(roots.real[np.abs(roots.imag) < 1e-9]))


def by_arcless() -> Equilibrium:
    x = np.linspace(0.0, LENGTH, round(LENGTH / ELEMENT) + 1)
    flat, parts, longer = np.zeros_like(x), Parts(), stretch()
    for k in range(len(x) - 1):
        bending, mass = PIECES[int(x[k] + 0.5 * ELEMENT > STEP)]
        rest = (x[k + 1] - x[k]) / longer
        add_element(parts, k, rest=rest, axial=EA, mass=mass, tension=T, bending=bending)
    parts.add_mass(round(MASS_AT / ELEMENT), MASS)
    parts.add_spring(round(SPRING_AT / ELEMENT), UP, GIVEN, stiffness=SPRING)
    for end in (0, len(x) - 1):
        parts.fix(end, ALONG, UP)
    places = np.column_stack([x, flat, flat])
    slopes = np.column_stack([np.full_like(x, longer), flat, flat])
    return at_rest(mesh_of(2, places, slopes, parts, list(range(len(x) - 1))))


class Beam:
    """Return the wire of scikit-fem: stiffness, masses, and its free unknowns."""

    def __init__(self) -> None:
        mesh = skfem.MeshLine(np.linspace(0.0, LENGTH, round(LENGTH / FINE) + 1))
        self.basis = skfem.Basis(mesh, skfem.ElementLineHermite())
        per_metre = 1.0 / stretch()

        @skfem.BilinearForm
        def bending(u: Any, v: Any, w: Any) -> Any:
            pieces = [one * per_metre for one, _ in PIECES]
            value = np.where(w.x[0] > STEP, pieces[1], pieces[0])
            return value * dd(u)[0, 0] * dd(v)[0, 0] + T * d(u)[0] * d(v)[0]

        @skfem.BilinearForm
        def inertia(u: Any, v: Any, w: Any) -> Any:
            pieces = [one * per_metre for _, one in PIECES]
            return np.where(w.x[0] > STEP, pieces[1], pieces[0]) * u * v

        self.stiffness = bending.assemble(self.basis) + self._point(SPRING, SPRING_AT)
        self.masses = inertia.assemble(self.basis) + self._point(MASS, MASS_AT)
        held = {self.at(0.0), self.at(LENGTH)}
        self.free = np.array(sorted(set(range(self.basis.N)) - held))

    def at(self, x: float) -> int:
        node = int(np.argmin(np.abs(self.basis.mesh.p[0] - x)))
        assert abs(self.basis.mesh.p[0][node] - x) < 1e-9
        return int(self.basis.nodal_dofs[0, node])

    def _point(self, value: float, x: float) -> Any:
        return diags(value * (np.arange(self.basis.N) == self.at(x)))

    def _inner(self) -> tuple[Any, Any]:
        inner = np.ix_(self.free, self.free)
        return self.stiffness.tocsc()[inner], self.masses.tocsc()[inner]

    def elasticity(self, x: np.ndarray) -> np.ndarray:
        places = np.searchsorted(self.free, [self.at(place) for place in x])
        unit = np.zeros((len(self.free), len(x)))
        unit[places, range(len(x))] = 1.0
        return splu(self._inner()[0]).solve(unit)[places, range(len(x))]

    def frequencies(self) -> np.ndarray:
        stiffness, masses = self._inner()
        squares = eigsh(stiffness, FREQUENCIES, masses, sigma=0.0, return_eigenvectors=False)
        return np.sqrt(np.sort(squares)) / (2.0 * np.pi)


def test_elasticity(evidence) -> None:
    x = np.array([3.0, 6.0, 9.0, 14.0, 17.0, 20.0, 23.0, 27.0])
    mine, theirs = by_arcless().elasticity(x), Beam().elasticity(x)
    evidence.below(
        "elasticity at 8 places, largest relative difference",
        float(np.abs(mine / theirs - 1.0).max()), 1e-5, unit="1",
        reason="under the force the wire bends within ℓ = √(EI/T) = 0.09 m, which is ℓ/2T, up to"
        " 2 % of the elasticity; cubic elements lose (h/ℓ)⁴/720 = 3e-4 of that in either program",
    )  # fmt: skip


def test_frequencies(evidence) -> None:
    mine, theirs = by_arcless().frequencies(FREQUENCIES), Beam().frequencies()
    evidence.below(
        f"{FREQUENCIES} natural frequencies, largest relative difference",
        float(np.abs(mine / theirs - 1.0).max()), 1e-6, unit="1",
        reason="the largest eigenvalue of the beam is 1e9 times the lowest: its rounding is 1e-7;"
        " elements lose less",
    )  # fmt: skip


FAULTS = [
    *(Fault(f"{column} of {kind} 1 % too large", scaled(kind, column, 1.01), test_elasticity)
      for kind, column in (("springs", "stiffness"), ("wires", "EI"))),
    *(Fault(f"mass of {kind} 0.1 % too large", scaled(kind, "mass", 1.001), test_frequencies)
      for kind in ("masses", "wires")),
    Fault("EA of the wires 1 % too large", scaled("wires", "EA", 1.01), test_frequencies),
]  # fmt: skip
