"""Time step of the founding paper, formula by formula, for any elastic system with contacts.

G. N. Kolesnikov, D. A. Kuvshinov, "Numerical modelling of the semi-coercive mechanical interaction
of a pantograph and an overhead contact line at high locomotive speed" (in Russian), Petrozavodsk
State University, about 2009. The text has no equation numbers. The numbers here count its formulas
as ``docs/theory/published-method.md`` lists them, which also leads to their places in a run.

Symbols, the paper's own in brackets where they differ::

    u (U)      displacements, m            M          mass matrix, kg
    u_1, u_2   u_{i−1} and u_{i−2}, m      C_d (K)    damping matrix, N·s/m
    p (P)      nodal loads, N              K (r)      stiffness matrix, N/m
    n (N)      contact forces, N           C          contact map
    d (D)      gaps, m; d0 at u = 0        R          reactions of fictitious links, N
    T          friction forces, N          τ, i       time step, s; its number

Model::

    1    R = M ü + C_d u̇ + K u − p − C n = 0
    2    d = Cᵀu + d0
    3    dᵀn = 0,   d ≥ 0,   n ≥ 0

Steps 1 and 2, the one-sided differences, turn model 1 into R_i = A u_i + p̂_i − C n_i::

    1    u̇_i = (u_i − u_{i−1})/τ
    2    ü_i = (u_i − 2u_{i−1} + u_{i−2})/τ²

Steps 3 to 11 stand at the lines of `PublishedStep` that compute them.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from arcless.lcp.arrays import Array, check_symmetric, finite, numbers, shaped
from arcless.lcp.failures import LcpInputError
from arcless.lcp.problem import DEFINITE_MIN, LcpInfo, pivoted

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
        Pivots and residual of the complementarity problem.
    """

    u: Array
    force: Array
    gap: Array
    info: LcpInfo


class PublishedStep:
    """Backward differences, block Jordan exchange and complementarity: one step of the paper.

    The scheme is of first order, stable for every τ and dissipative (a motion of angular frequency
    ω is damped by about ωτ/2 of critical).

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
        A matrix is not square, finite or symmetric, sizes differ, M has a negative eigenvalue, the
        step is not positive, or ``M/τ² + C_d/τ + K`` is not positive definite.

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
        # Copies: the arrays stay those of the caller.
        self._tau, self._M = np.float64(tau), _mass(mass).copy()
        self._C_d = self._matrix("damping", damping).copy()
        with np.errstate(all="ignore"):  # what is beyond all numbers has no pivot in A
            self._B = 2 * self._M / self._tau**2 + self._C_d / self._tau  # step 4
        self.reform(stiffness)

    @property
    def size(self) -> int:
        """Number of degrees of freedom n."""
        return len(self._M)

    @property
    def time_step(self) -> float:
        """Step τ, s."""
        return float(self._tau)

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
        M, C_d, tau = self._M, self._C_d, self._tau
        K = self._matrix("stiffness", stiffness)
        with np.errstate(all="ignore"):  # what is beyond all numbers has no pivot
            A = M / tau**2 + C_d / tau + K  # step 3
            check_symmetric("mass", M, np.diagonal(A) * tau**2)
            check_symmetric("damping", C_d, np.diagonal(A) * tau)
            check_symmetric("stiffness", K, np.diagonal(A))
            self._A_inverse = _inverse(A)

    def problem(
        self, u_1: ArrayLike, u_2: ArrayLike, load: ArrayLike, contact_map: ArrayLike,
        initial_gap: ArrayLike,
    ) -> tuple[Array, Array]:  # fmt: skip
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
        _, _, H, w = self._table_2(u_1, u_2, load, contact_map, initial_gap)
        return H, w

    def step(
        self, u_1: ArrayLike, u_2: ArrayLike, load: ArrayLike, contact_map: ArrayLike,
        initial_gap: ArrayLike,
    ) -> Step:  # fmt: skip
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
            As for `problem`; or the displacements are beyond all numbers.
        LcpUnsolvedError
            The problem has no verified solution: contacts that exclude each other.
        """
        A_C, u_free, H, w = self._table_2(u_1, u_2, load, contact_map, initial_gap)
        # Step 8: y = H x + w, yᵀx = 0, y ≥ 0, x ≥ 0 with y = d_i, x = n_i, by Jordan exchange with
        # the energy criterion.
        n, d, info = pivoted(H, w)
        with np.errstate(all="ignore"):  # what is beyond all numbers is refused
            u = A_C @ n + u_free  # step 11
        return Step(finite("u_i", u), n, d, info)

    def _table_2(self, *given: ArrayLike) -> tuple[Array, Array, Array, Array]:
        """Return A⁻¹C, −A⁻¹p̂_i, H and w: table 2 without the columns of R_i, which are zero."""
        u_1, u_2, p, C, d0 = self._fitting(*given)
        M, B, A_inverse, tau = self._M, self._B, self._A_inverse, self._tau
        with np.errstate(all="ignore"):  # what is beyond all numbers is refused by the solver
            p_hat = M @ u_2 / tau**2 - B @ u_1 - p  # step 5
            # Step 6, table 1:
            #     [R_i]   [ A   −C ] [u_i]   [p̂_i]
            #     [d_i] = [ Cᵀ   0 ] [n_i] + [d0 ]
            # Step 7, table 2, by block Jordan exchange of R and u:
            #     [u_i]   [ A⁻¹      A⁻¹C   ] [R_i]   [ −A⁻¹p̂_i       ]
            #     [d_i] = [ CᵀA⁻¹    CᵀA⁻¹C ] [n_i] + [ d0 − CᵀA⁻¹p̂_i ]
            A_C, u_free = A_inverse @ C, -A_inverse @ p_hat
            H = C.T @ A_C  # step 9
            w = d0 + C.T @ u_free  # step 10
        return A_C, u_free, H, w

    def _matrix(self, name: str, values: ArrayLike) -> Array:
        return shaped(name, values, self._M.shape, "as the mass matrix")

    def _fitting(
        self, u_1: ArrayLike, u_2: ArrayLike, load: ArrayLike, contact_map: ArrayLike,
        initial_gap: ArrayLike,
    ) -> tuple[Array, Array, Array, Array, Array]:  # fmt: skip
        why = f"for {self.size} degrees of freedom"
        one = shaped("u_1", u_1, (self.size,), why)
        two = shaped("u_2", u_2, (self.size,), why)
        p = shaped("load", load, (self.size,), why)
        d0 = numbers("initial_gap", initial_gap)
        if d0.ndim != 1:
            raise LcpInputError("initial_gap", got=f"shape {d0.shape}", expected="one dimension")
        m = len(finite("initial_gap", d0))
        C = shaped("contact_map", contact_map, (self.size, m), f"{why} and {m} initial gaps")
        if not (acts := C.any(axis=0)).all():
            column = f"contact_map[:, {int(np.argmin(acts))}]"
            raise LcpInputError(column, got="zeros", expected="a contact that acts on something")
        return one, two, p, C, d0


def friction(coefficient: float, previous_force: ArrayLike) -> Array:
    """Return the friction of Amontons and Coulomb with the last step's forces: ``T_i = f n_{i−1}``.

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
    n_1 = numbers("previous_force", previous_force)
    if n_1.ndim != 1:
        raise LcpInputError("previous_force", got=f"shape {n_1.shape}", expected="one dimension")
    with np.errstate(all="ignore"):
        return finite("friction", f * finite("previous_force", n_1))  # algorithm 4


def exchange(table: Array, k: int) -> None:
    """Exchange the variables of row k and column k of a table (Jordan).

    ``T_kk ← 1/P,  T_kj ← −T_kj/P,  T_ik ← T_ik/P,  T_ij ← T_ij − T_ik T_kj/P`` with ``P = T_kk``.
    Columns beyond the rows are constants.
    """
    row, column, inverse = table[k].copy(), table[:, k].copy(), 1.0 / table[k, k]
    # Product before division: a symmetric table stays symmetric to the last bit.
    table -= np.multiply.outer(column, row) * inverse
    table[k], table[:, k], table[k, k] = -row * inverse, column * inverse, inverse


def _inverse(A: Array) -> Array:
    """Return A⁻¹, by exchange of all rows; every pivot of a positive definite A is positive."""
    table = A.copy()
    for k, diagonal in enumerate(np.diagonal(A)):
        pivot = table[k, k]
        if not (np.isfinite(pivot) and pivot > DEFINITE_MIN * abs(diagonal)):
            raise LcpInputError(
                "A = M/τ² + C_d/τ + K",
                got=f"a pivot of {pivot:.3g} in row {k}, diagonal {diagonal:.3g}",
                expected="a positive definite matrix",
                hint="something without mass that nothing holds, or too short or too long a step?",
            )
        exchange(table, k)
    return table


def _mass(given: ArrayLike) -> Array:
    M = numbers("mass", given)
    if M.ndim != 2 or M.shape[0] != M.shape[1] or M.size == 0:  # noqa: PLR2004 - a matrix
        raise LcpInputError("mass", got=f"shape {M.shape}", expected="a square matrix")
    least = float(np.linalg.eigvalsh(finite("mass", M))[0])
    if least < MASS_MIN * float(np.abs(M).max()):
        raise LcpInputError(
            "mass",
            got=f"an eigenvalue of {least:.3g}",
            expected="a matrix without negative eigenvalues",
        )
    return M
