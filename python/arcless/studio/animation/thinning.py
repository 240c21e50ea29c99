"""Fewer rows, fewer nodes, and at last a shorter time, until a motion has a size."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.studio.animation.rows import Motion, Numbers, WireRows
from arcless.studio.at_rest.plain_geometry import Geometry

Masks = list[NDArray[np.bool_]]

# Times between rows in s and distances of nodes in m, finest first: the last is 25 rows a second,
# the least that looks like a motion, and a metre, a fifth of the distance of droppers.
LEVELS = ((0.0, 0.0), (0.01, 0.25), (0.02, 0.5), (0.04, 1.0))
# An integer of 16 bits in base64.
BYTES_A_VALUE = 2 * 4 / 3
# Of a row of a pantograph, singles; and of the numbers of first node and nodes of each window.
BYTES_A_PANTOGRAPH, BYTES_A_WINDOW = 60.0, 12.0
# Of the geometry as JSON: a node, a dropper, a support.
BYTES_A_NODE, BYTES_A_DROPPER, BYTES_A_SUPPORT = 36.0, 420.0, 320.0
# In a slot of times or positions, of its width: what rounding puts before its slot belongs to it.
# Far above rounding, and far below what anybody sees.
ROUNDING = 1e-6
# Share of the size that rows may have where the time is shortened: the rest is the line at rest.
SHARE = 0.7
# Share of a shortened time that lies before the worst place.
BEFORE = 0.4


@dataclass(frozen=True)
class Thinned:
    """A motion of a size.

    Attributes
    ----------
    motion
        What is left of it.
    kept
        Which nodes of each wire stay, by wire of the geometry.
    level
        Time between rows in s and distance of nodes in m; 0 for those of the record.
    whole
        True where it covers all times.
    """

    motion: Motion
    kept: Masks
    level: tuple[float, float]
    whole: bool


def thinned(
    motion: Motion, geometry: Geometry, worst_s: float, limit: float, pantographs: int = 1
) -> Thinned:
    """Return a motion in so many bytes of base64.

    Parameters
    ----------
    motion, geometry
        What was recorded, and its line at rest.
    worst_s
        Time in s that stays when the time must be shortened.
    limit
        Size in bytes, of the motion and its geometry.
    pantographs
        Number of pantographs.
    """
    for level in LEVELS:
        every, apart = level
        kept = _nodes(geometry, apart)
        rows = _rows(motion.times, every)
        wires = [one.taken(rows).thinned(kept[one.wire]) for one in motion.wires]
        size = _bytes_by_row(wires, len(rows), geometry, pantographs)
        if size.sum() + _bytes_at_rest(geometry, kept) <= limit:
            return Thinned(Motion(motion.times[rows], tuple(wires)), kept, level, True)
    # The line at rest of a shortened motion is a part of the whole: a share of the size at most.
    part = rows[_around(motion.times[rows], size, worst_s, SHARE * limit)]
    shorter = [one.taken(part) for one in motion.wires]
    kept = _near(geometry, kept, shorter)
    return Thinned(
        Motion(motion.times[part], tuple(one.thinned(kept[one.wire]) for one in shorter)),
        kept,
        level,
        False,
    )


def _near(geometry: Geometry, kept: Masks, wires: list[WireRows]) -> Masks:
    """Return the nodes that stay along the part of the line that any row has."""
    ends = []
    for one in wires:
        x = np.asarray(geometry["wires"][one.wire]["x"])
        some = one.count > 0
        ends += [x[one.first[some]].min(), x[(one.first + one.count - 1)[some]].max()]
    low, high = min(ends), max(ends)
    along = [np.asarray(wire["x"]) for wire in geometry["wires"]]
    return [mask & (x >= low) & (x <= high) for mask, x in zip(kept, along, strict=True)]


def _rows(times: NDArray[np.float64], every: float) -> Numbers:
    """Return the rows that are at least so many s apart, the first and the last among them."""
    if every == 0.0 or not len(times):
        return np.arange(len(times))
    slots = np.floor((times - times[0]) / every + ROUNDING).astype(int)
    first = np.flatnonzero(np.diff(slots, prepend=-1))
    return np.unique(np.append(first, len(times) - 1))


def _nodes(geometry: Geometry, apart: float) -> Masks:
    """Return which nodes stay: some so many m apart, ends, those of droppers and supports."""
    kept = []
    for wire in geometry["wires"]:
        x = np.asarray(wire["x"])
        slots = np.floor((x - x[0]) / apart + ROUNDING).astype(int) if apart else np.arange(len(x))
        mask = np.diff(slots, prepend=slots[0] - 1) != 0
        mask[[0, -1]] = True
        kept.append(mask)
    for dropper in geometry["droppers"]:
        kept[dropper["wire"]][dropper["node"]] = True
        kept[dropper["top_wire"]][dropper["top_node"]] = True
    for support in geometry["supports"]:
        kept[support["wire"]][support["node"]] = True
    return kept


def _bytes_by_row(
    wires: list[WireRows], rows: int, geometry: Geometry, pantographs: int
) -> NDArray[np.float64]:
    values = len(geometry["droppers"]) + len(geometry["supports"])
    size = np.full(rows, BYTES_A_PANTOGRAPH * pantographs + BYTES_A_VALUE * values)
    for one in wires:
        directions = 1 if one.across is None else 2
        size += directions * (BYTES_A_WINDOW + BYTES_A_VALUE * one.count)
    return size


def _bytes_at_rest(geometry: Geometry, kept: Masks) -> float:
    nodes = sum(int(mask.sum()) for mask in kept)
    held = BYTES_A_DROPPER * len(geometry["droppers"]) + BYTES_A_SUPPORT * len(geometry["supports"])
    return BYTES_A_NODE * nodes + held


def _around(
    times: NDArray[np.float64], size: NDArray[np.float64], worst_s: float, limit: float
) -> Numbers:
    """Return the rows around a time that fit, a share of them before it."""
    most = max(2, int(limit / size.max()))
    at = int(np.searchsorted(times, worst_s))
    first = min(max(0, at - int(BEFORE * most)), max(0, len(times) - most))
    return np.arange(first, min(first + most, len(times)))
