"""Wires by scikit-fem: cubic Hermite elements, quadrature and assembly are its own.

Energy of a wire with position r over its unstretched length s (docs/theory/wires.md):

    U = ∫ ½ EA ε² + ½ EI κ² − μ g z ds,    ε = ½ (r′·r′ − 1),    κ = (x′ z″ − z′ x″) / |r′|³
"""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.sparse import block_diag, bmat
from skfem import Basis, BilinearForm, ElementLineHermite, LinearForm, MeshLine
from skfem.helpers import d, dd

Array = Any
# ε² is of degree 8 in s; κ² is no polynomial, but nearly constant where wires are nearly straight.
QUADRATURE = 9


@BilinearForm
def mass_form(u: Any, v: Any, w: Any) -> Any:
    return u * v


@LinearForm
def force_form(v: Any, w: Any) -> Any:
    return w["slope"] * d(v)[0] + w["bend"] * dd(v)[0, 0]


@BilinearForm
def stiffness_form(u: Any, v: Any, w: Any) -> Any:
    slopes = w["ss"] * d(u)[0] * d(v)[0] + w["bb"] * dd(u)[0, 0] * dd(v)[0, 0]
    return slopes + w["sb"] * d(v)[0] * dd(u)[0, 0] + w["bs"] * dd(v)[0, 0] * d(u)[0]


@LinearForm
def unit_form(v: Any, w: Any) -> Any:
    return v


@dataclass
class Wire:
    """A piece of wire between hinges: where its elements end (s, m), EA, EI, μ."""

    ends: Array
    axial: float
    bending: float
    mass: float
    basis: Any = field(init=False)

    def __post_init__(self) -> None:
        mesh = MeshLine(np.asarray(self.ends))
        self.basis = Basis(mesh, ElementLineHermite(), intorder=QUADRATURE)

    @property
    def size(self) -> int:
        """Number of unknowns of one component."""
        return int(self.basis.N)

    def unknown(self, s: float, *, slope: bool = False) -> int:
        """Unknown of a component at the end of an element."""
        ends = self.basis.mesh.p[0]
        node = int(np.argmin(np.abs(ends - s)))
        assert abs(ends[node] - s) < 1e-9, f"no element ends at {s} m"
        return int(self.basis.nodal_dofs[int(slope), node])

    def terms(self, q: Array) -> tuple[Array, Any]:
        """Gradient and second derivative of the strain energy for the unknowns (x, z)."""
        fields = [self.basis.interpolate(part) for part in np.split(q, 2)]
        a = np.array([part.grad[0] for part in fields])
        b = np.array([part.hess[0, 0] for part in fields])
        strain = Strain(self.axial, self.bending, a, b)
        force = [
            force_form.assemble(self.basis, slope=strain.slope[p], bend=strain.bend[p])
            for p in (0, 1)
        ]
        blocks = [
            [stiffness_form.assemble(self.basis, **strain.second(p, r)) for r in (0, 1)]
            for p in (0, 1)
        ]
        return np.concatenate(force), bmat(blocks)

    def masses(self) -> Any:
        """Mass matrix for (x, z)."""
        one = self.mass * mass_form.assemble(self.basis)
        return block_diag([one, one])

    def weight(self, gravity: float) -> Array:
        """Weight on (x, z)."""
        down = -self.mass * gravity * unit_form.assemble(self.basis)
        return np.concatenate([np.zeros(self.size), down])


class Strain:
    """½ EA ε² + ½ EI κ² as a function of a = r′ and b = r″: first and second derivatives."""

    def __init__(self, axial: float, bending: float, a: Array, b: Array) -> None:
        s = (a**2).sum(axis=0)
        c = a[0] * b[1] - a[1] * b[0]
        c_a, c_b = np.array([b[1], -b[0]]), np.array([-a[1], a[0]])
        self.axial, self.bending, self.a, self.s = axial, bending, a, s
        self.c, self.c_a, self.c_b = c, c_a, c_b
        self.pull = axial * 0.5 * (s - 1.0)
        self.kappa = c * s**-1.5
        self.k_a = c_a * s**-1.5 - 3.0 * c * s**-2.5 * a
        self.k_b = c_b * s**-1.5
        self.slope = self.pull * a + bending * self.kappa * self.k_a
        self.bend = bending * self.kappa * self.k_b

    def second(self, p: int, r: int) -> dict[str, Array]:
        """Second derivatives by component p of the test function and r of the trial function."""
        a, s, c, same = self.a, self.s, self.c, float(p == r)
        k_aa = 15.0 * c * s**-3.5 * a[p] * a[r] - 3.0 * s**-2.5 * (
            self.c_a[p] * a[r] + self.c_a[r] * a[p] + c * same
        )

        def k_ab(p: int, r: int) -> Array:
            return (r - p) * s**-1.5 - 3.0 * self.c_b[r] * s**-2.5 * a[p]

        bent = self.bending
        return {
            "ss": self.pull * same + self.axial * a[p] * a[r]
            + bent * (self.k_a[p] * self.k_a[r] + self.kappa * k_aa),
            "bb": bent * self.k_b[p] * self.k_b[r],
            "sb": bent * (self.k_a[p] * self.k_b[r] + self.kappa * k_ab(p, r)),
            "bs": bent * (self.k_b[p] * self.k_a[r] + self.kappa * k_ab(r, p)),
        }  # fmt: skip
