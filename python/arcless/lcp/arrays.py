"""Arrays from users: numbers, finite, of the shape that is needed."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from arcless.lcp.failures import LcpInputError

Array = NDArray[np.float64]


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
