"""A motion whose values are known: a hump of the wires that travels with each pantograph."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.studio.animation.rows import Motion, WireRows
from arcless.studio.at_rest.plain_geometry import Geometry

REACH = 60.0  # m, of the recorded window to either side


def uplift(x: Any, at: Any) -> Any:
    """Return the displacement in m at x where a pantograph is at another place, both in m."""
    return 0.05 * np.exp(-(((x - at) / 12.0) ** 2)) + 0.004 * np.sin(0.4 * (x - at))


def waving(geometry: Geometry, times: NDArray[np.float64], x: NDArray[np.float64]) -> Motion:
    """Return the motion of all wires; `x` are the positions of a pantograph in m, (time)."""
    wires = []
    for number, wire in enumerate(geometry["wires"]):
        along = np.asarray(wire["x"])
        first = np.searchsorted(along, x - REACH)
        count = np.searchsorted(along, x + REACH) - first
        up = np.full((len(times), int(count.max())), 9.0, dtype=np.float32)  # not to be seen
        for row, (begin, many) in enumerate(zip(first, count, strict=True)):
            up[row, :many] = uplift(along[begin : begin + many], x[row])
        across = -up if geometry["spatial"] else None
        wires.append(WireRows(number, first, count, up, across))
    return Motion(times, tuple(wires))
