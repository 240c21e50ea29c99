"""One dropper or one support over time, however the line was recorded.

Of a long line a row holds only what is near the pantographs: `near_dropper_force[t, k]` belongs to
dropper `dropper_order[near_dropper_first[t] + k]`, and the same of supports.
"""

from collections.abc import Sequence
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.schema import VARIABLES
from arcless.errors import ModelError
from arcless.units import show

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


def asked_for(
    dataset: "Dataset", place: Place, name: str, channel: str | None = None
) -> tuple[int, str]:
    """Return the index of a place along its dimension, from 0, and the name of a series of it.

    Parameters
    ----------
    dataset
        As built by a run or opened from a file.
    place
        "dropper" or "support".
    name
        Of the place, as the dimension has it.
    channel
        Series; without one that of `CHANNELS`.

    Raises
    ------
    ModelError
        There is no such place, or nothing of the kind was recorded.
    """
    if not isinstance(place, str) or place not in CHANNELS:
        raise _unknown("kind of place", place, list(CHANNELS), " or ".join(CHANNELS))
    names = [str(one) for one in dataset[place].values] if place in dataset else []
    if name not in names:
        if not names:
            raise ModelError(f"the run has no {place}", got=show(name))
        numbered = f"{place} {name}"  # of `9` support 9
        written = numbered if numbered in names else str(name)
        expected = f"one of {len(names)}, {names[0]} to {names[-1]}"
        raise _unknown(place, name, names, expected, written)
    channel = channel or CHANNELS[place]
    there = [one for one in series_of(place) if is_recorded(dataset, place, one)]
    if channel in there:
        return names.index(name), channel
    if channel in series_of(place):
        raise ModelError(
            f"series of a {place} that was not recorded", got=show(channel),
            expected=", ".join(there) or None,
            hint=f"output.{place}s: true records it where the line has it",
        )  # fmt: skip
    raise _unknown(f"series of a {place}", channel, there, ", ".join(there))


def _unknown(
    what: str, given: object, known: Sequence[str], expected: str, written: str | None = None
) -> ModelError:
    close = get_close_matches(str(given) if written is None else written, known, n=1)
    hint = f"did you mean {close[0]}?" if close else None
    return ModelError(f"unknown {what}", got=show(given), expected=expected, hint=hint)


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
