"""Lanes of recorded motion: wires one behind the other, which share columns."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.plain_dataset import Dataset


def nodes_of_lane(read: Callable[[str], Any], kind: str, number: int) -> NDArray[np.int64]:
    """Return the numbers of the nodes of a kind that are in a lane.

    Parameters
    ----------
    read
        Gives the values of a variable of the result, None of one that it does not have.
    kind
        Kind of the wires, as in a result: "contact_wire".
    number
        The lane, counted from 1; without lanes in a result all nodes are in one.
    """
    lane_of = read(f"{kind}_node_lane")
    if lane_of is None:
        return np.arange(len(read(f"{kind}_node_x")))
    return np.flatnonzero(np.asarray(lane_of) == number)


def values_in(dataset: Dataset) -> Callable[[str], Any]:
    """Return a reader of the values of a dataset's variables; it gives None for missing ones."""
    return lambda name: dataset[name].values if name in dataset else None
