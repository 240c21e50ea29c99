"""One linear complementarity problem.

``y = Hx + w``, ``x ≥ 0``, ``y ≥ 0``, ``xᵀy = 0``, solved by principal pivoting in the core.
For contacts of an elastic structure ``x`` holds the forces in N, ``y`` the gaps in m, ``H`` the
flexibility in m/N and ``w`` the gaps without forces in m. See ``docs/guide/lcp.md``.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from arcless import _core
from arcless.lcp.arrays import Array, check_symmetric, finite, numbers
from arcless.lcp.failures import LcpInputError, LcpUnsolvedError

# Smallest part of a diagonal entry that the rows before it leave unexplained (a squared Cholesky
# pivot at unit diagonal). The core's PIVOT_MIN: below it, rounding decides about the sign.
DEFINITE_MIN = 1e-14


@dataclass(frozen=True)
class LcpInfo:
    """Effort and accuracy of a solution.

    Parameters
    ----------
    pivots : int
        Exchanges of a variable between zero and free.
    fallback_used : bool
        Whether the energy criterion came back to a set of contacts that it had left, and the finite
        least-index rule took over.
    residual : float
        Largest violation of the four conditions, relative to the largest terms that are added up in
        any row, all at unit diagonal of H; at most 1e-10, else the problem counts as not solved.
    status : str
        Always ``"solved"``; anything else is raised.
    """

    pivots: int
    fallback_used: bool
    residual: float
    status: Literal["solved"] = "solved"


def solve(H: ArrayLike, w: ArrayLike, *, symmetric: bool = True) -> tuple[Array, Array, LcpInfo]:
    """Solve ``y = Hx + w``, ``x ≥ 0``, ``y ≥ 0``, ``xᵀy = 0``.

    Parameters
    ----------
    H : array_like of float, shape (n, n)
        Symmetric positive definite matrix. Each row may have its own unit, as long as
        ``x_k y_k`` has the same one everywhere.
    w : array_like of float, shape (n,)
        Value of ``y`` without any ``x``.
    symmetric : bool, optional
        With False, H only has to be a P-matrix (every principal minor positive), as in a time step
        where droppers and contacts act on each other. That is not checked in advance; a pivot that
        contradicts it raises `LcpUnsolvedError`.

    Returns
    -------
    x : ndarray of float, shape (n,)
        Forces: none negative, zero where y is positive.
    y : ndarray of float, shape (n,)
        Gaps: none negative, zero where x is positive.
    info : LcpInfo
        Pivots, use of the fallback, residual.

    Raises
    ------
    LcpInputError
        H is not square, finite, symmetric or positive definite, does not fit w, or is empty.
    LcpUnsolvedError
        A bound on the pivots was reached, or rounding spoiled the solution.

    Examples
    --------
    Two contacts, pressed by 1 mm; the second opens by half of it:

    >>> from arcless import lcp
    >>> x, y, info = lcp.solve([[2e-6, -1e-6], [-1e-6, 2e-6]], [-1e-3, 1e-3])
    >>> x.round(6).tolist(), y.round(6).tolist(), info.pivots
    ([500.0, 0.0], [0.0, 0.0005], 1)
    """
    matrix, vector = _arrays(H, w)
    if symmetric:
        scaled = _scaled(matrix)
        check_symmetric("H", matrix, np.diagonal(matrix))
        _check_definite(scaled)
    return pivoted(matrix, vector)


def pivoted(matrix: Array, vector: Array) -> tuple[Array, Array, LcpInfo]:
    """Solve a problem whose arrays are known to fit."""
    try:
        x, y, pivots, fallback_used, residual = _core.solve_lcp(matrix.ravel(), vector)
    except _core.NativeError as error:
        _, _, details = error.args
        raise LcpUnsolvedError(
            "the complementarity problem could not be solved",
            got=details["reason"],
            hint="check the signs and units of H",
            pivots=details["pivots"],
            residual=details["residual"],
        ) from error
    return x, y, LcpInfo(pivots, fallback_used, residual)


def _arrays(H: ArrayLike, w: ArrayLike) -> tuple[Array, Array]:
    matrix, vector = numbers("H", H), numbers("w", w)
    if vector.ndim != 1:
        raise LcpInputError("w", got=f"shape {vector.shape}", expected="one dimension")
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1]:  # noqa: PLR2004 - a matrix
        raise LcpInputError("H", got=f"shape {matrix.shape}", expected="a square matrix")
    if matrix.shape[0] != vector.size:
        raise LcpInputError(
            "w",
            got=f"{vector.size} entries",
            expected=f"{matrix.shape[0]}, as many as H has rows",
        )
    if vector.size == 0:
        raise LcpInputError("H", got="n = 0", expected="at least one row")
    return finite("H", matrix), finite("w", vector)


def _scaled(matrix: Array) -> Array:
    """Bring H to unit diagonal, after a look at the diagonal's signs."""
    diagonal = np.diagonal(matrix)
    if (diagonal <= 0).any():
        k = int(np.argmax(diagonal <= 0))
        raise LcpInputError(
            "H", got=f"H[{k}, {k}] = {diagonal[k]:g}", expected="a positive definite matrix"
        )
    root = np.sqrt(diagonal)
    scaled: Array = matrix / root / root[:, np.newaxis]
    return scaled


def _check_definite(scaled: Array) -> None:
    try:
        least = float(np.diagonal(np.linalg.cholesky(scaled)).min()) ** 2
    except np.linalg.LinAlgError:
        least = 0.0
    if least < DEFINITE_MIN:
        smallest = float(np.linalg.eigvalsh(scaled)[0])
        raise LcpInputError(
            "H",
            got=f"a smallest eigenvalue of {smallest:.2g} at unit diagonal",
            expected="a positive definite matrix",
            hint="two rows that say the same, or a mechanism that nothing holds?",
        )
