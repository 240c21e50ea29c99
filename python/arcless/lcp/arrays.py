"""Arrays from users: numbers, finite, of the shape that is needed."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from arcless.lcp.failures import LcpInputError

Array = NDArray[np.float64]

# |X_ij − X_ji| over the root of two diagonal entries. Products of measured or assembled matrices
# differ by some 1e-14; a wrong sign or a forgotten term differs by far more.
SYMMETRY_TOLERANCE = 1e-10


def numbers(name: str, values: ArrayLike) -> Array:
    """Return an array of real numbers in rows, of whatever shape."""
    try:
        array = np.asarray(values)
        if np.iscomplexobj(array):
            raise LcpInputError(name, got="complex numbers", expected="real numbers")
        return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)
    except (TypeError, ValueError) as error:
        if isinstance(error, LcpInputError):
            raise
        raise LcpInputError(name, got=str(error), expected="an array of numbers") from error


def finite(name: str, values: Array) -> Array:
    """Return `values` when every entry is a number; else say which is not."""
    bad = np.argwhere(~np.isfinite(values))
    if bad.size:
        index = tuple(int(i) for i in bad[0])
        place = ", ".join(str(i) for i in index)
        raise LcpInputError(f"{name}[{place}]", got=str(values[index]), expected="a number")
    return values


def shaped(name: str, values: ArrayLike, shape: tuple[int, ...], why: str) -> Array:
    """Return finite numbers of the given shape; `why` says where the shape comes from."""
    array = numbers(name, values)
    if array.shape != shape:
        raise LcpInputError(name, got=f"shape {array.shape}", expected=f"{shape}, {why}")
    return finite(name, array)


def check_symmetric(name: str, matrix: Array, diagonal: Array) -> None:
    """Refuse a matrix that is not symmetric, measured by a diagonal in its unit."""
    root = np.sqrt(np.abs(diagonal))
    with np.errstate(over="ignore"):  # an infinite difference is one
        wrong = np.abs(matrix - matrix.T) > SYMMETRY_TOLERANCE * np.outer(root, root)
    if wrong.any():
        i, j = (int(index) for index in np.argwhere(wrong)[0])
        raise LcpInputError(
            name,
            got=f"{name}[{i}, {j}] = {float(matrix[i, j])} and "
            f"{name}[{j}, {i}] = {float(matrix[j, i])}",
            expected=f"a symmetric matrix (to {SYMMETRY_TOLERANCE:g} of the diagonal)",
        )
