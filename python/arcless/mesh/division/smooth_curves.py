"""Smooth curves through given points."""

from collections.abc import Sequence

import numpy as np

from arcless.mesh.tables.mesh_types import Floats


def smooth(places: Sequence[float], values: Sequence[float], x: float | Floats) -> Floats:
    """Return a curve without kinks and without over-swing through points.

    Parameters
    ----------
    places, values
        The points; the curve is level at the inner ones that stand out.
    x
        Where it is wanted; not beyond the outer points.

    Notes
    -----
    Cubic pieces with the weighted harmonic mean of the slopes on both sides of a point (Fritsch
    and Butland, SIAM J. Sci. Stat. Comput. 5, 1984), not curved at the two ends.
    """
    at, height = np.asarray(places), np.asarray(values)
    step = np.diff(at)
    rise = np.diff(height) / step
    slope = np.zeros(len(at))
    inner = 1 + np.flatnonzero(rise[:-1] * rise[1:] > 0.0)
    before, behind = 2.0 * step[inner] + step[inner - 1], step[inner] + 2.0 * step[inner - 1]
    slope[inner] = (before + behind) / (before / rise[inner - 1] + behind / rise[inner])
    slope[0] = 1.5 * rise[0] - 0.5 * slope[1]
    slope[-1] = 1.5 * rise[-1] - 0.5 * slope[-2]
    piece = np.clip(np.searchsorted(at, x, side="right") - 1, 0, len(step) - 1)
    t = (x - at[piece]) / step[piece]
    bend = slope[piece] - rise[piece], slope[piece + 1] - rise[piece]
    share = rise[piece] * t + t * (1.0 - t) * ((1.0 - t) * bend[0] - t * bend[1])
    return np.asarray(height[piece] + step[piece] * share)
