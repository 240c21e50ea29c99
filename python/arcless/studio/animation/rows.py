"""Recorded motion of wires as rows of nodes, by the wires of the geometry at rest."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Singles = NDArray[np.float32]
Numbers = NDArray[np.int64]


@dataclass(frozen=True)
class WireRows:
    """Displacements of nodes of a wire, one window of them in each row.

    Attributes
    ----------
    wire
        Number of the wire in the geometry, from 0.
    first, count
        First node of each row, from 0, and number of nodes, (row).
    up, across
        Displacement from rest in m, upwards and to the left, (row, node of the window); values
        behind `count` mean nothing. `across` is None in a plane.
    """

    wire: int
    first: Numbers
    count: Numbers
    up: Singles
    across: Singles | None

    def taken(self, rows: Numbers) -> "WireRows":
        """Return some of the rows."""
        across = None if self.across is None else self.across[rows]
        return WireRows(self.wire, self.first[rows], self.count[rows], self.up[rows], across)

    def thinned(self, kept: NDArray[np.bool_]) -> "WireRows":
        """Return the displacements of the nodes that are kept, numbered among themselves.

        Parameters
        ----------
        kept
            Which nodes of the wire stay, (node).
        """
        number = np.concatenate([[0], np.cumsum(kept)])
        first = number[self.first]
        count = number[self.first + self.count] - first
        width = int(count.max(initial=0))
        nodes = np.flatnonzero(kept)
        # Behind the end of a row the last node of the wire stands: `count` says that it is none.
        places = np.minimum(first[:, None] + np.arange(width), max(nodes.size - 1, 0))
        columns = np.clip(nodes[places] - self.first[:, None], 0, self.up.shape[1] - 1)
        rows = np.arange(len(self.first))[:, None]
        across = None if self.across is None else self.across[rows, columns]
        return WireRows(self.wire, first, count, self.up[rows, columns], across)


@dataclass(frozen=True)
class Motion:
    """Motion of a line: times in s (row), and the windows of its wires, all with these rows."""

    times: NDArray[np.float64]
    wires: tuple[WireRows, ...]
