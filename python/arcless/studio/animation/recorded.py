"""Recorded motion of a result, by the wires of its geometry.

A result holds the motion of a kind of wires as ``KIND_motion`` (row, place): displacements upwards
in m of the nodes ``KIND_motion_first`` (row) and those that follow, numbered among all of the kind;
``KIND_motion_across`` to the left, of lines in space; rows are at ``motion_time``.
"""

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.plain_dataset import Dataset
from arcless.errors import OutputError
from arcless.studio.animation.rows import Motion, Numbers, WireRows
from arcless.studio.at_rest.plain_geometry import KINDS, Geometry, WireData


def recorded(data: Dataset, geometry: Geometry) -> Motion:
    """Return the recorded motion of all wires.

    Parameters
    ----------
    data
        Dataset of a run.
    geometry
        Its line at rest.

    Raises
    ------
    OutputError
        No motion was recorded.
    """
    if "motion_time" not in data:
        raise OutputError(
            "the run has no recorded motion",
            hint="`arcless run SCENARIO --set output.motion=true` records it",
        )
    wires = [
        _of_wire(data, number, wire)
        for number, wire in enumerate(geometry["wires"])
        if f"{KINDS[wire['kind']][0]}_motion" in data
    ]
    return Motion(np.asarray(data["motion_time"].values, dtype=float), tuple(wires))


def _of_wire(data: Dataset, number: int, wire: WireData) -> WireRows:
    """Return the rows of one wire, of the windows over all wires of its kind."""
    name = f"{KINDS[wire['kind']][0]}_motion"
    up = np.asarray(data[name].values)
    window = np.asarray(data[f"{name}_first"].values).astype(np.int64) - wire["first"]
    nodes = len(wire["x"])
    first = np.clip(window, 0, nodes)
    count = np.clip(window + up.shape[1], 0, nodes) - first
    across = data[f"{name}_across"].values if f"{name}_across" in data else None
    return WireRows(
        number,
        first,
        count,
        _shifted(up, first - window),
        None if across is None else _shifted(np.asarray(across), first - window),
    )


def _shifted(values: NDArray[np.float32], by: Numbers) -> NDArray[np.float32]:
    """Return each row from a place of its own on; behind its end the last value is repeated."""
    places = np.minimum(np.arange(values.shape[1]) + by[:, None], values.shape[1] - 1)
    return np.take_along_axis(values, places, axis=1)
