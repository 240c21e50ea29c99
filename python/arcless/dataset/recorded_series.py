"""One dropper's force or one support's uplift over time, however the line was recorded.

Of a long line a row holds only what is near the pantographs: `near_dropper_force[t, k]` belongs to
dropper `dropper_order[near_dropper_first[t] + k]`, and the same of supports.
"""

from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

Place = Literal["dropper", "support"]
CHANNELS = {"dropper": "dropper_force", "support": "support_uplift"}


def is_recorded(dataset: "Dataset", place: Place) -> bool:
    """Return whether a dataset has the forces of droppers or the uplift of supports over time."""
    channel = CHANNELS[place]
    return channel in dataset or f"near_{channel}" in dataset


def passage(
    dataset: "Dataset", place: Place, index: int
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """Return the rows along `line_time` at which a place was recorded, and its values there.

    Parameters
    ----------
    dataset
        As built by a run or opened from a file.
    place
        "dropper", with the force in N, or "support", with the uplift in m.
    index
        Of the place along the dimension of this name, from 0.

    Raises
    ------
    KeyError
        Nothing of the kind was recorded; see `is_recorded`.
    """
    channel = CHANNELS[place]
    if channel in dataset:
        values: NDArray[np.float64] = dataset[channel].values[:, index]
        return np.arange(len(values)), values
    near: NDArray[Any] = dataset[f"near_{channel}"].values
    at = int(np.flatnonzero(dataset[f"{place}_order"].values == index)[0])
    column = at - dataset[f"near_{place}_first"].values
    rows = np.flatnonzero((column >= 0) & (column < near.shape[1]))
    return rows, near[rows, column[rows]]
