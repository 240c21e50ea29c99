"""Recorded motion of the contact wires of a run."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arcless.figures.wires.wire_velocity import WireMotion

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

_KIND = "contact_wire"


def contact_wires(dataset: "Dataset") -> list[WireMotion]:
    """Return the recorded motion of each contact wire; empty where it was not recorded.

    Columns of the record are the wires one behind the other, `motion_count` of them for each; those
    of a wire begin at its node `motion_first` of the row.
    """
    if "motion_up" not in dataset:
        return []
    times = np.asarray(dataset["motion_time"].values, dtype=np.float64)
    counts = np.asarray(dataset["motion_count"].values)
    ends = np.cumsum(counts)
    found = []
    for place, name in enumerate(dataset["motion_wire"].values):
        kind, _, number = str(name).rpartition(" ")
        if kind == _KIND:
            columns = slice(int(ends[place] - counts[place]), int(ends[place]))
            found.append(
                WireMotion(
                    times,
                    _places(dataset, int(number)),
                    dataset["motion_first"].values[:, place],
                    dataset["motion_up"].values[:, columns],
                )
            )
    return found


def _places(dataset: "Dataset", number: int) -> NDArray[np.float64]:
    """Return the positions of the nodes of one contact wire in m."""
    x = np.asarray(dataset[f"{_KIND}_node_x"].values, dtype=np.float64)
    several = f"{_KIND}_node_wire"
    return x[dataset[several].values == number] if several in dataset else x
