"""Check of the recorded motion in a result file: its rows are nodes and droppers of the line.

A row says which node of a wire it begins with; a reader that believed any number would show the
displacement of one node at another one, or look for nodes that are not there.
"""

from typing import TYPE_CHECKING

import numpy as np

from arcless.dataset.schema import WIRES
from arcless.errors import ResultFormatError

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Plain

# Without these the displacements belong to no node.
_NEEDED = ("motion_time", "motion_wire", "motion_count", "motion_first")
_DROPPERS = ("motion_dropper_first", "motion_dropper_order")


def check_motion(dataset: "Plain", file: object) -> None:
    """Refuse recorded motion that is not of the wires and droppers of its line.

    Parameters
    ----------
    dataset
        Read from a file. Its displacements themselves are not read.
    file
        The file, for messages.

    Raises
    ------
    ResultFormatError
        A variable is missing, or its numbers do not fit those of the line.
    """
    if "motion_up" in dataset:
        _check_there(dataset, _NEEDED, file)
        _check_wires(dataset, file)
    if "motion_dropper_force" in dataset:
        _check_there(dataset, _DROPPERS, file)
        _check_droppers(dataset, file)


def _check_there(dataset: "Plain", names: tuple[str, ...], file: object) -> None:
    if missing := [name for name in names if name not in dataset]:
        raise ResultFormatError(
            "the motion in the result file is incomplete",
            where=str(file),
            expected=", ".join(missing),
        )


def _check_wires(dataset: "Plain", file: object) -> None:
    counts, first = dataset["motion_count"].values, dataset["motion_first"].values
    names = [str(name) for name in dataset["motion_wire"].values]
    nodes = np.array([_nodes(dataset, name, file) for name in names])
    columns = dataset["motion_node"].values.size
    if (counts < 0).any() or counts.sum() != columns:
        got, expected = f"{counts.sum()} nodes in a row", f"{columns}"
        raise _refusal("motion_count", file, got, expected)
    outside = (first < 0) | (first + counts > nodes)
    if outside.any():
        row, wire = np.unravel_index(int(np.argmax(outside)), outside.shape)
        got = f"node {first[row, wire]} in row {row}"
        expected = f"0 to {nodes[wire] - counts[wire]} of {names[wire]}"
        raise _refusal("motion_first", file, got, expected)


def _nodes(dataset: "Plain", name: str, file: object) -> int:
    """Return the number of nodes of a wire or lane, by its name."""
    kind, _, number = name.rpartition(" ")
    places, lane = f"{kind}_node_x", f"{kind}_node_lane"
    if kind not in WIRES or places not in dataset or not number.isdecimal():
        expected = "a wire of the line, such as contact_wire 1"
        raise _refusal("motion_wire", file, name, expected)
    if lane not in dataset:
        return int(dataset[places].values.size)
    return int(np.count_nonzero(dataset[lane].values == int(number)))


def _check_droppers(dataset: "Plain", file: object) -> None:
    order, first = dataset["motion_dropper_order"].values, dataset["motion_dropper_first"].values
    if not np.array_equal(np.sort(order), np.arange(order.size)):
        expected = f"each of 0 to {order.size - 1} once"
        raise _refusal("motion_dropper_order", file, "another order", expected)
    last = order.size - dataset["near_motion_dropper"].values.size
    outside = (first < 0) | (first > last)
    if outside.any():
        row = int(np.argmax(outside))
        got = f"place {first[row]} in row {row}"
        raise _refusal("motion_dropper_first", file, got, f"0 to {last}")


def _refusal(name: str, file: object, got: str, expected: str) -> ResultFormatError:
    return ResultFormatError(
        "the motion in the result file is not of its line",
        where=f"{file}: {name}",
        got=got,
        expected=expected,
    )
