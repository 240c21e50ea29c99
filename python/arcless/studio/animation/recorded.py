"""Recorded motion of a result, by the wires of its geometry."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.motion_lanes import nodes_of_lane, values_in
from arcless.dataset.plain_dataset import Dataset
from arcless.errors import OutputError
from arcless.studio.animation.rows import Motion, Numbers, Singles, WireRows
from arcless.studio.at_rest.plain_geometry import KINDS, Geometry, WireData


class _Columns(NamedTuple):
    """Columns of a lane: its nodes among those of the kind, the first (row), displacements in m."""

    kind: str
    nodes: Numbers
    first: Numbers
    up: Singles
    across: Singles | None


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
    if "motion_up" not in data:
        raise OutputError(
            "the run has no recorded motion",
            hint="`arcless run SCENARIO --set output.motion=true` records it",
        )
    columns = _columns(data)
    wires = [
        _of_wire(number, wire, one)
        for number, wire in enumerate(geometry["wires"])
        for one in columns
        if one.kind == KINDS[wire["kind"]][0] and wire["first"] in one.nodes
    ]
    times = np.asarray(data["motion_time"].values, dtype=float)
    return Motion(times, tuple(one for one in wires if one.count.any()))


def _columns(data: Dataset) -> list[_Columns]:
    """Return the columns of each recorded wire; a row begins at a node of its own."""
    names = [str(name).rsplit(" ", 1) for name in data["motion_wire"].values]
    counts = np.asarray(data["motion_count"].values).astype(int)
    first = np.asarray(data["motion_first"].values).astype(np.int64)
    ends = np.cumsum(counts)
    up = np.asarray(data["motion_up"].values)
    across = np.asarray(data["motion_across"].values) if "motion_across" in data else None
    found = []
    for place, ((kind, number), end) in enumerate(zip(names, ends, strict=True)):
        own = slice(end - counts[place], end)
        nodes = nodes_of_lane(values_in(data), kind, int(number))
        sideways = None if across is None else across[:, own]
        found.append(_Columns(kind, nodes, first[:, place], up[:, own], sideways))
    return found


def _of_wire(number: int, wire: WireData, one: _Columns) -> WireRows:
    """Return the rows of a wire of the geometry, of a window over several of them."""
    window = one.first - int(np.searchsorted(one.nodes, wire["first"]))
    nodes = len(wire["x"])
    first = np.clip(window, 0, nodes)
    count = np.clip(window + one.up.shape[1], 0, nodes) - first
    across = None if one.across is None else _shifted(one.across, first - window)
    return WireRows(number, first, count, _shifted(one.up, first - window), across)


def _shifted(values: Singles, by: NDArray[np.int64]) -> Singles:
    """Return each row from a place of its own on; behind its end the last value is repeated."""
    places = np.minimum(np.arange(values.shape[1]) + by[:, None], values.shape[1] - 1)
    found: Singles = np.take_along_axis(values, places, axis=1)
    return found
