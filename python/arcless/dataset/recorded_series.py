"""One dropper or one support over time, however the line was recorded.

Of a long line a row holds only what is near the pantographs: `near_dropper_force[t, k]` belongs to
dropper `dropper_order[near_dropper_first[t] + k]`, and the same of supports.
"""

from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.schema import VARIABLES

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

Place = Literal["dropper", "support"]
# Series of a place that is meant where none is named.
CHANNELS = {"dropper": "dropper_force", "support": "support_uplift"}


def series_of(place: Place) -> list[str]:
    """Return the names of all series of droppers or supports over time."""
    return [name for name, variable in VARIABLES.items() if variable.dims == ("line_time", place)]


def is_recorded(dataset: "Dataset", place: Place, channel: str | None = None) -> bool:
    """Return whether a dataset has a series of places; without a name that of `CHANNELS`."""
    channel = channel or CHANNELS[place]
    return channel in dataset or f"near_{channel}" in dataset


def passage(
    dataset: "Dataset", place: Place, index: int, channel: str | None = None
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """Return the rows along `line_time` at which a place was recorded, and its values there.

    Parameters
    ----------
    dataset
        As built by a run or opened from a file.
    place
        "dropper" or "support".
    index
        Of the place along the dimension of this name, from 0.
    channel
        Series, such as "support_force"; without one the force of a dropper in N, the uplift at a
        support in m.

    Raises
    ------
    KeyError
        Nothing of the kind was recorded; see `is_recorded`.
    """
    channel = channel or CHANNELS[place]
    if channel in dataset:
        values: NDArray[np.float64] = dataset[channel].values[:, index]
        return np.arange(len(values)), values
    near: NDArray[Any] = dataset[f"near_{channel}"].values
    at = int(np.flatnonzero(dataset[f"{place}_order"].values == index)[0])
    column = at - dataset[f"near_{place}_first"].values
    rows = np.flatnonzero((column >= 0) & (column < near.shape[1]))
    return rows, near[rows, column[rows]]
