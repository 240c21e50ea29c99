"""The time step of the founding paper, for any elastic system with one-sided contacts.

The formulas and their numbers stand in ``docs/theory/published-method.md``, the code that computes
them in the core (``crates/core/src/published``).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from arcless import _core
from arcless.lcp.arrays import Array, finite, numbers, shaped
from arcless.lcp.failures import LcpInputError
from arcless.lcp.problem import LcpInfo, pivoted

# Smallest accepted eigenvalue of the mass matrix over its largest entry. Degrees of freedom without
# mass are allowed; assembly and the eigenvalue itself leave some 1e-14.
MASS_MIN = -1e-10


@dataclass(frozen=True)
class Step:
    """State at the end of a step, for n degrees of freedom and m contacts.

    Parameters
    ----------
    u : ndarray of float, shape (n,)
        Displacements u_i, m (rad for rotations).
    force : ndarray of float, shape (m,)
        Contact forces n_i, N: none negative, zero where the gap is open.
    gap : ndarray of float, shape (m,)
        Gaps d_i, m: none negative, zero where a force acts.
    info : LcpInfo
        What the complementarity problem of the step took.
    """

    u: Array
    force: Array
    gap: Array
    info: LcpInfo


class PublishedStep:
    """Backward differences, block Jordan exchange and complementarity: one step of the paper.

    The system is ``M ü + C_d u̇ + K u = p + C n`` with gaps ``d = Cᵀu + d0`` and ``d ≥ 0``,
    ``n ≥ 0``, ``dᵀn = 0``. Velocity and acceleration are ``(u_i − u_{i−1})/τ`` and
    ``(u_i − 2u_{i−1} + u_{i−2})/τ²``: first order, stable for every τ, dissipative (a motion of
    angular frequency ω is damped by about ωτ/2 of critical).

    Parameters
    ----------
    mass : array_like of float, shape (n, n)
        M, symmetric without negative eigenvalues, kg (kg·m² for rotations).
    damping : array_like of float, shape (n, n)
        C_d, symmetric, N·s/m.
    stiffness : array_like of float, shape (n, n)
        K, symmetric, N/m. It may be singular or indefinite as long as ``M/τ² + C_d/τ + K`` is
        positive definite.
    time_step : float
        τ, s.

    Raises
    ------
    LcpInputError
        A matrix is not square, finite or symmetric, the sizes differ, M has a negative eigenvalue,
        the step is not positive, or ``M/τ² + C_d/τ + K`` is not positive definite.

    Examples
    --------
    A mass of 1 kg, 2 mm above the floor, pushed down by 10 N, with steps of 0.1 s; it would pass
    through the floor within the first step:

    >>> from arcless import lcp
    >>> ball = lcp.PublishedStep([[1.0]], [[0.0]], [[0.0]], 0.1)
    >>> at_rest = [0.0]
    >>> step = ball.step(at_rest, at_rest, [-10.0], [[1.0]], [0.002])
    >>> step.u.round(6).tolist(), step.force.round(6).tolist(), step.gap.tolist()
    ([-0.002], [9.8], [0.0])
    """

    def __init__(
        self, mass: ArrayLike, damping: ArrayLike, stiffness: ArrayLike, time_step: float
    ) -> None:
        tau = numbers("time_step", time_step)
        if tau.ndim != 0 or not np.isfinite(tau) or tau <= 0:
            raise LcpInputError("time_step", got=str(time_step), expected="a positive number, s")
        m = numbers("mass", mass)
        if m.ndim != 2 or m.shape[0] != m.shape[1] or m.size == 0:  # noqa: PLR2004 - a matrix
            raise LcpInputError("mass", got=f"shape {m.shape}", expected="a square matrix")
        self._n = len(m)
        self._tau = float(tau)
        _check_mass(finite("mass", m))
        c, k = self._square("damping", damping), self._square("stiffness", stiffness)
        try:
            self._core = _core.PublishedStep(self._n, m.ravel(), c.ravel(), k.ravel(), self._tau)
        except _core.NativeError as error:
            raise _input_error(error) from error

    @property
    def size(self) -> int:
        """Number of degrees of freedom n."""
        return self._n

    @property
    def time_step(self) -> float:
        """Step τ, s."""
        return self._tau

    def reform(self, stiffness: ArrayLike) -> None:
        """Replace the stiffness; mass, damping and step stay. After an error the old one stays.

        Parameters
        ----------
        stiffness : array_like of float, shape (n, n)
            New K, symmetric, N/m.

        Raises
        ------
        LcpInputError
            As for the constructor.
        """
        try:
            self._core.reform(self._square("stiffness", stiffness).ravel())
        except _core.NativeError as error:
            raise _input_error(error) from error

    def problem(
        self,
        u_1: ArrayLike,
        u_2: ArrayLike,
        load: ArrayLike,
        contact_map: ArrayLike,
        initial_gap: ArrayLike,
    ) -> tuple[Array, Array]:
        """Return H and w of a step: ``H = CᵀA⁻¹C``, ``w = d0 − CᵀA⁻¹p̂``.

        Parameters
        ----------
        u_1, u_2 : array_like of float, shape (n,)
            Displacements u_{i−1} and u_{i−2} one and two steps ago, m. Equal for a start at rest.
        load : array_like of float, shape (n,)
            Nodal loads p_i, N, friction included.
        contact_map : array_like of float, shape (n, m)
            C: column j says on which degrees of freedom, in which direction, contact j pushes. It
            may be another one in every step.
        initial_gap : array_like of float, shape (m,)
            d0, gaps at u = 0, m.

        Returns
        -------
        H : ndarray of float, shape (m, m)
            Flexibility of the step between the contacts, m/N.
        w : ndarray of float, shape (m,)
            Gaps at the end of the step without contact forces, m.

        Raises
        ------
        LcpInputError
            An array has the wrong shape, an entry is not a finite number, or a contact acts on
            nothing.
        """
        H, w, _, _ = self._table(u_1, u_2, load, contact_map, initial_gap)
        return H, w

    def step(
        self,
        u_1: ArrayLike,
        u_2: ArrayLike,
        load: ArrayLike,
        contact_map: ArrayLike,
        initial_gap: ArrayLike,
    ) -> Step:
        """Take one step.

        Parameters
        ----------
        u_1, u_2, load, contact_map, initial_gap : array_like of float
            As for `problem`. Without contacts, m = 0, it is a step of backward differences.

        Returns
        -------
        Step
            Displacements, contact forces and gaps at the end of the step.

        Raises
        ------
        LcpInputError
            As for `problem`.
        LcpUnsolvedError
            The problem has no verified solution: contacts that exclude each other.
        """
        H, w, response, free = self._table(u_1, u_2, load, contact_map, initial_gap)
        force, gap, info = pivoted(H, w)
        return Step(response @ force + free, force, gap, info)  # u_i = A⁻¹C n_i − A⁻¹p̂_i

    def _table(
        self,
        u_1: ArrayLike,
        u_2: ArrayLike,
        load: ArrayLike,
        contact_map: ArrayLike,
        initial_gap: ArrayLike,
    ) -> tuple[Array, Array, Array, Array]:
        n = self._n
        why = f"for {n} degrees of freedom"
        one, two = shaped("u_1", u_1, (n,), why), shaped("u_2", u_2, (n,), why)
        p = shaped("load", load, (n,), why)
        gap = numbers("initial_gap", initial_gap)
        if gap.ndim != 1:
            raise LcpInputError("initial_gap", got=f"shape {gap.shape}", expected="one dimension")
        m = len(finite("initial_gap", gap))
        expected = f"{why} and {m} initial gaps"
        contacts = shaped("contact_map", contact_map, (n, m), expected)
        try:
            H, w, response, free = self._core.table(one, two, p, contacts.ravel(), gap)
        except _core.NativeError as error:
            raise _input_error(error) from error
        return H.reshape(m, m), w, response.reshape(n, m), free

    def _square(self, name: str, values: ArrayLike) -> Array:
        return shaped(name, values, (self._n, self._n), "as the mass matrix")


def friction(coefficient: float, previous_force: ArrayLike) -> Array:
    """Friction of Amontons and Coulomb with the forces of the step before: ``T_i = f n_{i−1}``.

    Add it to the load on the degrees of freedom along the surface, in the direction in which the
    other body slides: ``load + tangent_map @ friction(f, last.force)``. With the force of the step
    before, the step remains a complementarity problem of normal forces alone.

    Parameters
    ----------
    coefficient : float
        f ≥ 0.
    previous_force : array_like of float, shape (m,)
        Contact forces n_{i−1}, N.

    Returns
    -------
    ndarray of float, shape (m,)
        Friction forces T_i, N.

    Raises
    ------
    LcpInputError
        The coefficient is negative, or something is not a finite number.
    """
    f = numbers("coefficient", coefficient)
    if f.ndim != 0 or not np.isfinite(f) or f < 0:
        raise LcpInputError("coefficient", got=str(coefficient), expected="a number, not negative")
    force = numbers("previous_force", previous_force)
    if force.ndim != 1:
        got = f"shape {force.shape}"
        raise LcpInputError("previous_force", got=got, expected="one dimension")
    return _core.friction(float(f), finite("previous_force", force))


def _check_mass(mass: Array) -> None:
    least, limit = float(np.linalg.eigvalsh(mass)[0]), MASS_MIN * float(np.abs(mass).max())
    if least < limit:
        raise LcpInputError(
            "mass",
            got=f"an eigenvalue of {least:.3g}",
            expected="a matrix without negative eigenvalues",
        )


def _input_error(error: _core.NativeError) -> LcpInputError:
    _, message, details = error.args
    name = details["array"]
    reason = message.removeprefix(f"input array {name}: ")
    return LcpInputError(f"{name}: {reason}")
