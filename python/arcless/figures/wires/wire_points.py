"""The wires of a result as points to draw, a gap between one wire and the next."""

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from arcless.figures.description.thinning import envelope, every

Floats = NDArray[np.float64]

# At least this many of each wire, and most wires that are drawn.
WIRE_POINTS, MOST_WIRES = 40, 1000


class Nodes(Protocol):
    """Variables by name, of a run or of a line at rest."""

    def values(self, name: str) -> NDArray[Any]:
        """Return a variable's values, empty where there is none."""


def wire_points(scene: Nodes, wire: str, axis: str, points: int) -> tuple[Floats, Floats]:
    """Return x and another coordinate of the nodes of all wires of one kind.

    NaN stands between several wires. About so many points are kept of all wires together, and of
    too many wires some.
    """
    x, values = scene.values(f"{wire}_node_x"), scene.values(f"{wire}_node_{axis}")
    owner = _owners(scene, wire)
    owners = np.unique(owner)
    pieces = [np.flatnonzero(owner == one) for one in owners[every(owners.size, MOST_WIRES)]]
    of_each = max(WIRE_POINTS, points // len(pieces))
    kept = [piece[envelope(values[piece], of_each)] for piece in pieces]
    if len(kept) == 1:
        return x[kept[0]], values[kept[0]]
    joined = [[np.append(data[piece], np.nan) for piece in kept] for data in (x, values)]
    return np.concatenate(joined[0]), np.concatenate(joined[1])


def _owners(scene: Nodes, wire: str) -> Floats:
    """Return a number for each node that tells the wires of one kind from each other."""
    told = [scene.values(f"{wire}_node_{which}") for which in ("wire", "support")]
    known = [values for values in told if values.size]
    if not known:
        return np.zeros(scene.values(f"{wire}_node_x").size)
    return np.asarray(np.unique(np.stack(known), axis=1, return_inverse=True)[1].ravel())
