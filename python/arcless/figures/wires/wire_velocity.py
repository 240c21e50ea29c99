"""Recorded displacements of a wire → its velocity over position and time.

The velocity of node j in row i is the central difference of the recorded rows around it,

    v = (u[i + 1, j] − u[i − 1, j]) / (t[i + 1] − t[i − 1]).

Of a wave of angular frequency ω, in rows dt apart, it is sin(ω dt) / (ω dt) of the velocity, too
small by the part (ω dt)² / 6 as long as ω dt is small (Taylor's theorem): by 1.6 % at 10 Hz in rows
5 ms apart. Then means are taken over the nodes and rows of each cell of a grid, which adds nothing
that was not recorded: a cell is never narrower than the nodes are apart, nor shorter than the rows.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Displacements that are gone through at a time: 32 MB of velocities and as much of places.
BLOCK = 4_000_000
# Part of a cell by which a sample may be before it and counts in it. Nodes or rows as far apart as
# cells are wide fall on their edges, and rounding (1e-10) would leave some cells empty; more than
# some per mille would move what is seen.
EDGE = 1e-3


@dataclass(frozen=True, eq=False)
class WireMotion:
    """Displacement of a wire around the pantographs, as it was recorded.

    Attributes
    ----------
    times
        Time of each row in s.
    x
        Position of each node of the wire in m; rises.
    first
        Node at which each row begins.
    up
        Displacement upwards from rest in m, shape (rows, nodes of a row); NaN beyond the wire.
    """

    times: Floats
    x: Floats
    first: NDArray[np.integer]
    up: NDArray[np.floating]


@dataclass(frozen=True, eq=False)
class Grid:
    """Mean velocity in equal cells of position and time.

    Attributes
    ----------
    x, t
        Edges of the whole grid: positions in m, times in s.
    values
        Velocity upwards in m/s, shape (cells in time, cells along the track); NaN where nothing was
        recorded.
    largest
        Largest velocity of a single node in a single row, in m/s.
    """

    x: tuple[float, float]
    t: tuple[float, float]
    values: Floats
    largest: float


def velocity_grid(
    motions: Sequence[WireMotion],
    x: tuple[float, float],
    t: tuple[float, float],
    columns: int,
    rows: int,
) -> Grid:
    """Return the velocity of wires over a part of the track and of time.

    Parameters
    ----------
    motions
        What was recorded of each wire; where two run side by side a cell has the mean of both.
    x, t
        Ends of the part, in m and s, the lower first.
    columns, rows
        Most cells along the track and in time; there are fewer where the record is coarser.
    """
    columns = min(_cells(one.x, x, columns) for one in motions)
    rows = min(_cells(one.times, t, rows) for one in motions)
    sums, counts, largest = np.zeros(rows * columns), np.zeros(rows * columns), 0.0
    for motion in motions:
        for place, velocity in _cell_of_each(motion, x, t, columns, rows):
            sums += np.bincount(place, velocity, sums.size)
            counts += np.bincount(place, minlength=sums.size)
            largest = max(largest, float(np.abs(velocity).max(initial=0.0)))
    with np.errstate(invalid="ignore"):  # no samples: NaN, which is what is meant
        values = (sums / np.where(counts > 0.0, counts, np.nan)).reshape(rows, columns)
    return Grid(x, t, values, largest)


def _cells(places: Floats, ends: tuple[float, float], most: int) -> int:
    """Return how many equal cells a range has of which none is narrower than samples are apart."""
    begin, end = np.searchsorted(places, ends)
    near = places[max(0, begin - 1) : end + 1]
    apart = float(np.diff(near).max(initial=0.0))
    if apart <= 0.0:
        return 1
    return max(1, min(most, int((ends[1] - ends[0]) / apart + EDGE**2)))


def _cell_of_each(
    motion: WireMotion, x: tuple[float, float], t: tuple[float, float], columns: int, rows: int
) -> Iterator[tuple[NDArray[np.intp], Floats]]:
    """Go through the record; yield the number of the cell and the velocity of each sample."""
    width = motion.up.shape[1]
    begin = max(1, int(np.searchsorted(motion.times, t[0])))
    end = min(motion.times.size - 1, int(np.searchsorted(motion.times, t[1], side="right")))
    step = max(1, BLOCK // max(width, 1))
    for first in range(begin, end, step):
        last = min(first + step, end)
        nodes, velocity = _velocities(motion, first, last)
        along = (motion.x[np.clip(nodes, 0, motion.x.size - 1)] - x[0]) / (x[1] - x[0])
        time = (motion.times[first:last] - t[0]) / (t[1] - t[0])
        column = np.floor(along * columns + EDGE).astype(np.intp)
        row = np.minimum((time * rows + EDGE).astype(np.intp), rows - 1)
        known = (column >= 0) & (column < columns) & np.isfinite(velocity)
        place = row[:, None] * columns + column
        yield place[known], velocity[known]


def _velocities(motion: WireMotion, first: int, last: int) -> tuple[NDArray[np.intp], Floats]:
    """Return the node and the velocity of each sample of some rows; NaN where a neighbour lacks."""
    width = motion.up.shape[1]
    chosen = np.arange(first, last)
    columns = np.arange(width)
    nodes = motion.first[chosen].astype(np.intp)[:, None] + columns

    def beside(row: NDArray[np.intp]) -> Floats:
        """Return displacements of the same nodes in another row, NaN outside of its window."""
        moved = nodes - motion.first[row].astype(np.intp)[:, None]
        inside = (moved >= 0) & (moved < width)
        found = motion.up[row[:, None], np.clip(moved, 0, width - 1)].astype(np.float64)
        return np.where(inside, found, np.nan)

    times = motion.times
    apart = (times[chosen + 1] - times[chosen - 1])[:, None]
    return nodes, (beside(chosen + 1) - beside(chosen - 1)) / apart
