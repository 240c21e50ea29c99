"""Receptance of a chain of masses at its head, its poles, and the derivatives of both.

With the dynamic stiffness D(s) of a chain of n masses, from base to head, and the head's vector e,

    D(s) = K + s C + s² M,   H(s) = eᵀ x,   D x = e
    M = diag(m_i),   K = Σ k_i e_i e_iᵀ,   C = Σ c_i e_i e_iᵀ  or  L Lᵀ

where e_i is the elongation of joint i (`equation_of_motion`) and L a lower triangle. D is
symmetric, so that any change of it changes the receptance and a pole λ (D(λ) ψ = 0) by

    dH = −xᵀ dD x,   dλ = −ψᵀ dD ψ / ψᵀ(C + 2 λ M) ψ

(Friswell & Mottershead: Finite Element Model Updating in Structural Dynamics, Kluwer 1995, chapter
2.) Stable and passive by construction: with m > 0, k ≥ 0 and C ≥ 0 a force on the head does the
work −ω Im H(iω) |F|²/2 = ω² x*C x |F|²/2 ≥ 0 in a unit of time, and nothing in it has energy of
its own.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from arcless.pantograph.equation_of_motion import Matrices, elongation

Floats = NDArray[np.float64]
Complex = NDArray[np.complexfloating[Any, Any]]
Damping = Literal["joints", "full"]


@dataclass(frozen=True, eq=False)
class Chain:
    """A chain of masses with linear springs and dampers, from base to head.

    Attributes
    ----------
    mass
        In kg (n), positive.
    stiffness
        Of the spring below each mass in N/m (n), that of the first one to the base; not negative.
    damping
        Of the damper below each mass in N s/m (n); or the lower triangle L (n × n) of a damping
        matrix C = L Lᵀ, in √(N s/m).
    """

    mass: Floats
    stiffness: Floats
    damping: Floats

    @property
    def order(self) -> int:
        """Number of masses n."""
        return self.mass.size

    @property
    def kind(self) -> Damping:
        """``"joints"`` for a damper in each joint, ``"full"`` for a damping matrix."""
        return "joints" if self.damping.ndim == 1 else "full"

    @property
    def parameters(self) -> int:
        """Number of parameters: masses, springs, and dampers or entries of L."""
        return 2 * self.order + of_damping(self.order, self.kind)

    @property
    def matrices(self) -> Matrices:
        """Mass, damping and stiffness (n × n), SI units, in heights of the masses."""
        joints = elongations(self.order)
        stiffness = joints.T @ (self.stiffness[:, None] * joints)
        if self.kind == "full":
            damping = self.damping @ self.damping.T
        else:
            damping = joints.T @ (self.damping[:, None] * joints)
        return Matrices(np.diag(self.mass), damping, stiffness)

    def receptance(self, frequency: Floats) -> Complex:
        """Return H(iω) in m/N at frequencies in Hz."""
        return self._head_moved(2j * np.pi * frequency)[:, -1]

    def receptance_changes(self, frequency: Floats) -> tuple[Complex, Complex]:
        """Return H(iω) in m/N at frequencies in Hz (f), and its derivatives (f × parameters)."""
        s = 2j * np.pi * frequency
        x = self._head_moved(s)
        return x[:, -1], -self._work(s, x)

    def poles(self) -> tuple[Complex, Complex]:
        """Return the poles λ in rad/s, one of each conjugate pair, and their derivatives.

        The slowest stand first; a pole that is real stands alone.
        """
        from scipy.linalg import eig

        parts, n = self.matrices, self.order
        zero, one = np.zeros((n, n)), np.eye(n)
        left = np.block([[zero, one], [-parts.stiffness, -parts.damping]])
        right = np.block([[one, zero], [zero, parts.mass]])
        values, vectors = eig(left, right)
        kept = np.flatnonzero(values.imag >= 0.0)
        kept = kept[np.argsort(np.abs(values[kept]))]
        s, psi = values[kept], vectors[:n, kept].T
        scale = np.einsum("fi,ij,fj->f", psi, parts.damping, psi)
        scale = scale + 2.0 * s * np.einsum("fi,ij,fj->f", psi, parts.mass, psi)
        return s, -self._work(s, psi) / scale[:, None]

    def _head_moved(self, s: Complex) -> Complex:
        """Return x of D(s) x = e for each s (f × n), in m for a force of 1 N on the head."""
        parts = self.matrices
        dynamic = parts.stiffness + s[:, None, None] * parts.damping
        dynamic = dynamic + (s**2)[:, None, None] * parts.mass
        force = np.zeros((s.size, self.order, 1))
        force[:, -1] = 1.0
        moved: Complex = np.linalg.solve(dynamic, force)[:, :, 0]
        return moved

    def _work(self, s: Complex, x: Complex) -> Complex:
        """Return xᵀ (∂D/∂p) x for each s and parameter p (f × parameters)."""
        stretched = x @ elongations(self.order).T
        rate = s[:, None]
        if self.kind == "joints":
            damped = rate * stretched**2
        else:
            rows, columns = np.tril_indices(self.order)
            damped = 2.0 * rate * x[:, rows] * (x @ self.damping)[:, columns]
        return np.concatenate([rate**2 * x**2, stretched**2, damped], axis=1)


@lru_cache(64)  # asked for in every evaluation of a search
def elongations(order: int) -> Floats:
    """Return the elongations of all joints, one in each row (n × n)."""
    return np.array([elongation(order, joint) for joint in range(order)])


def of_damping(order: int, kind: Damping) -> int:
    """Return how many numbers describe the damping of a chain of so many masses."""
    return order if kind == "joints" else order * (order + 1) // 2


def with_full_damping(chain: Chain) -> Chain:
    """Return a chain with its dampers in the joints as the damping matrix that they are.

    L is the transposed triangle of QR of the rows √c_i e_i, which also exists where some c_i is 0.
    """
    if chain.kind == "full":
        return chain
    rows = np.sqrt(chain.damping)[:, None] * elongations(chain.order)
    upper: Floats = np.linalg.qr(rows)[1]
    return Chain(chain.mass, chain.stiffness, upper.T)
