"""Recorded motion of the contact wires of a run."""

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.motion_lanes import nodes_of_lane, values_in
from arcless.dataset.plain_dataset import columns_of
from arcless.figures.wires.wire_velocity import WireMotion

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

_KIND = "contact_wire"


def contact_wires(dataset: "Dataset") -> list[WireMotion]:
    """Return the recorded motion of each contact wire; empty where it was not recorded.

    Columns of the record are the lanes one behind the other, `motion_count` of them for each; those
    of a lane begin at its node `motion_first` of the row. Of each of the wires that share a lane
    the rows are kept whose columns reach it.
    """
    if "motion_up" not in dataset:
        return []
    times = np.asarray(dataset["motion_time"].values, dtype=np.float64)
    counts = np.asarray(dataset["motion_count"].values)
    ends = np.cumsum(counts)
    x = np.asarray(dataset[f"{_KIND}_node_x"].values, dtype=np.float64)
    found = []
    for place, name in enumerate(dataset["motion_wire"].values):
        kind, _, number = str(name).rpartition(" ")
        if kind == _KIND:
            first = np.asarray(dataset["motion_first"].values[:, place], dtype=np.int64)
            # Other wires have most of the columns, and of a long run hundreds of megabytes.
            own = slice(int(ends[place] - counts[place]), int(ends[place]))
            up = columns_of(dataset, "motion_up", own)
            for nodes, before in _wires(dataset, int(number)):
                reached = _rows(first - before, up.shape[1], len(nodes))
                found.append(
                    WireMotion(
                        times[reached],
                        x[nodes],
                        (first - before)[reached],
                        _of_wire(up[reached], (first - before)[reached], len(nodes)),
                    )
                )
    return found


def _wires(dataset: "Dataset", lane: int) -> Iterator[tuple[NDArray[np.intp], int]]:
    """Yield the nodes of each wire in a lane, and how many nodes of the lane are before it."""
    nodes = nodes_of_lane(values_in(dataset), _KIND, lane)
    if f"{_KIND}_node_lane" not in dataset:
        yield nodes, 0
        return
    cuts = np.flatnonzero(np.diff(dataset[f"{_KIND}_node_wire"].values[nodes])) + 1
    for begin, end in pairwise([0, *cuts, len(nodes)]):
        yield nodes[begin:end], int(begin)


def _rows(first: NDArray[np.int64], width: int, nodes: int) -> slice:
    """Return the rows that reach a wire, and one more on each side for the velocity."""
    reaching = np.flatnonzero((first < nodes) & (first + width > 0))
    if not reaching.size:
        return slice(0, 0)
    return slice(max(int(reaching[0]) - 1, 0), int(reaching[-1]) + 2)


def _of_wire(
    up: NDArray[np.floating], first: NDArray[np.int64], nodes: int
) -> NDArray[np.floating]:
    """Return displacements with NaN beyond the ends of the wire."""
    if not up.size or (first.min() >= 0 and first.max() + up.shape[1] <= nodes):
        return up
    places = first[:, None] + np.arange(up.shape[1])
    return np.where((places >= 0) & (places < nodes), up, np.float32(np.nan))
