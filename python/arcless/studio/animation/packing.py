"""Arrays as text: integers of 16 bits with a step, or singles, little-endian, in base64."""

from base64 import b64encode
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.studio.animation.rows import Numbers

# The integer of a value that is not known, and the largest of the others.
UNKNOWN, LARGEST = -32768, 32767
# The finest step in the unit of the values, m or N: a micrometre, far below what is seen.
FINEST = 1e-6
_STEPS = (1.0, 2.0, 5.0)


def step_for(values: NDArray[Any]) -> float:
    """Return the step of integers that reach the largest value: 1, 2 or 5 times a power of ten."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    least = max(largest / LARGEST, FINEST)
    power = 10.0 ** np.floor(np.log10(least))
    # A step that rounding made a little smaller than itself is not too small.
    found = next((one * power for one in _STEPS if one * power >= least * (1 - 1e-12)), 10 * power)
    return float(f"{found:.6g}")


def text_of(values: NDArray[Any], kind: str) -> str:
    """Return the bytes of an array as base64; `kind` is a type of NumPy such as ``<f4``."""
    return b64encode(np.ascontiguousarray(values, dtype=np.dtype(kind)).tobytes()).decode("ascii")


def block(
    name: str, first: Numbers, count: Numbers, values: NDArray[Any], *, singles: bool = False
) -> dict[str, Any]:
    """Return a channel, one piece of it in each row.

    Parameters
    ----------
    name
        Name of the channel as the studio's stream has it, such as ``wire.0.up``.
    first, count
        Number of the first value of each row, and how many there are, (row).
    values
        In the unit of the channel, (row, value); what stands behind `count` is left out.
    singles
        Whether the values stay floating-point numbers.
    """
    inside = np.arange(values.shape[1]) < count[:, None]
    flat = values[inside]
    found: dict[str, Any] = {
        "name": name, "step": None, "first": text_of(first, "<u4"), "count": text_of(count, "<u4"),
    }  # fmt: skip
    if singles:
        return {**found, "values": text_of(flat, "<f4")}
    step = step_for(flat)
    known = np.isfinite(flat)
    integers = np.where(known, np.rint(np.where(known, flat, 0.0) / step), UNKNOWN)
    return {**found, "step": step, "values": text_of(integers, "<i2")}
