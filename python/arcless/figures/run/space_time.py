"""Space–time figure of a run: velocity of the contact wire over position and time.

Lines of the wave speed show where a disturbance would be that left a place when the first
pantograph was there. On a string under tension T with mass m per length the equation of motion
m ∂²u/∂t² = T ∂²u/∂x² has the solutions f(x − c t) and g(x + c t) (d'Alembert 1747, in any text on
waves), with

    c = √(T / m).

EN 50119, 5.2.4, calls c the wave propagation speed of the contact wire (from memory, mark C).
Bending stiffness makes short waves faster than c, droppers and supports reflect: lines are where a
first front is expected, not where the wire has to move.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.metadata import metadata
from arcless.figures.description import Axis, Curve, Figure, Layer, Map, Scale, Segments, Tip
from arcless.figures.description.tokens import of_pantograph
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import LABEL
from arcless.figures.wires.wire_motion import contact_wires
from arcless.figures.wires.wire_velocity import Grid, WireMotion, velocity_grid

Floats = NDArray[np.float64]

# Cells of the image in a report: a file holds 240 000 numbers at most, half a megabyte compressed.
COLUMNS, ROWS = 600, 400
# Spans in the figure of a report, around the middle of the section: waves are seen, not a texture.
SPANS = 4
# Part of the cells in % that may be beyond the ends of the scale. None: what is near a pantograph
# takes the whole scale, and waves are pale. More: waves are cut.
BEYOND_PERCENT = 0.5
# Most places from which lines of the wave speed begin: with more they hide what they are to show.
MOST_LINES = 5
# Pieces at whose ends a front is asked whether the motion was recorded there.
PIECES = 400
# Points of the path of a pantograph, which is straight where the speed is constant.
PATH_POINTS = 200
HEIGHT = 420


@dataclass(frozen=True, eq=False)
class WaveLine:
    """Front that leaves a place when the first pantograph is there: two lines of slope ± c.

    Attributes
    ----------
    x, t
        The place in m, and the time in s.
    """

    x: float
    t: float


class Front(NamedTuple):
    """Straight piece of a front, from (x0, t0) to (x1, t1), in m and s."""

    x0: float
    t0: float
    x1: float
    t1: float


def space_time(run: RunData) -> list[Figure]:
    """Return velocity of the contact wire over position and time, where its motion was recorded."""
    motions = contact_wires(run.dataset)
    if not motions:
        return []
    x, t = _window(run, motions)
    grid = velocity_grid(motions, x, t, COLUMNS, ROWS)
    if not np.isfinite(grid.values).any():
        return []
    speed = wave_speed(run)
    most = scale_end(grid)
    layers: list[Layer] = [
        Map(grid.x, grid.t, grid.values, tips=(Tip("velocity", "x", "m/s", "0.000"),)),
        *_waves(run, speed, grid),
        *paths(run, x, t),
    ]
    rows, columns = grid.values.shape
    waves = "" if speed is None else (
        f" Lines: fronts at the wave speed c = √(T/m) = {speed:.1f}\u00a0m/s, from supports that"
        " the first pantograph passes."
    )  # fmt: skip
    return [
        Figure(
            "space-time", "Velocity of the contact wire over position and time",
            Axis(LABEL, "m", *x), Axis("time", "s", *t, form="0.00"), layers,
            caption=f"Upwards is positive; means over {(x[1] - x[0]) / columns:.2g}\u00a0m and"
            f" {1e3 * (t[1] - t[0]) / rows:.2g}\u00a0ms. The scale ends where"
            f" {BEYOND_PERCENT:g}\u00a0% of the cells are beyond it.{waves}",
            alt=f"Velocity of the contact wire from {x[0]:.0f} to {x[1]:.0f} m and"
            f" {t[0]:.2f} to {t[1]:.2f} s, up to {grid.largest:.2f} m/s.",
            height=HEIGHT, scale=Scale("velocity, upwards", "m/s", -most, most, "diverging"),
        )
    ]  # fmt: skip


def wave_speed(run: RunData) -> float | None:
    """Return c of the contact wire in m/s as computed; None of a rail, which has none."""
    facts = metadata(run.dataset)
    known = facts.get("wave_speed_m_s")
    if known is not None:
        return float(known)
    wire = facts["scenario"]["line"]["contact_wire"]
    if not wire.get("tension") or not wire.get("mass"):
        return None
    return float(np.sqrt(wire["tension"] / wire["mass"]))


def scale_end(grid: Grid) -> float:
    """Return the end of the scale in m/s: nearly all cells are within, and zero is its middle."""
    known = np.abs(grid.values[np.isfinite(grid.values)])
    end = float(np.percentile(known, 100.0 - BEYOND_PERCENT)) if known.size else 0.0
    return end or grid.largest or 1.0


def wave_lines(run: RunData, x: tuple[float, float]) -> list[WaveLine]:
    """Return the places from which fronts are drawn: supports that the first pantograph passes.

    Of more than `MOST_LINES` in the range some are chosen, evenly.
    """
    path, time = run.position[:, 0], run.time
    passed = run.supports[(run.supports >= max(x[0], path[0]))
                          & (run.supports <= min(x[1], path[-1]))]  # fmt: skip
    step = max(1, -(-passed.size // MOST_LINES))
    return [WaveLine(float(at), float(np.interp(at, path, time))) for at in passed[::step]]


def paths(run: RunData, x: tuple[float, float], t: tuple[float, float]) -> list[Layer]:
    """Return the path of each pantograph inside of a part of track and time."""
    found: list[Layer] = []
    for i, name in enumerate(run.pantographs):
        place = run.position[:, i]
        rows = np.flatnonzero((place >= x[0]) & (place <= x[1]) & (run.time >= t[0])
                              & (run.time <= t[1]))  # fmt: skip
        if rows.size:
            kept = rows[np.unique(np.linspace(0, rows.size - 1, PATH_POINTS).astype(np.intp))]
            x_of, t_of = place[kept], run.time[kept]
            # With a darker edge: in dark pages the colours of pantographs are pale, as the map is.
            found.append(Curve(x_of, t_of, colour="wave", width=3.6))
            path = Curve(x_of, t_of, colour=of_pantograph(i), width=2.0, name=f"path of {name}")
            found.append(path)
    return found


def fronts(lines: Sequence[WaveLine], speed: float, grid: Grid) -> list[Front]:
    """Return the two fronts of each place, as far as the motion was recorded.

    Parameters
    ----------
    lines
        Places from which they leave.
    speed
        Wave speed in m/s.
    grid
        Velocities; where it has none there is nothing to see, and a front ends.
    """
    found = []
    for line in lines:
        for way in (1.0, -1.0):
            edge = grid.x[1] if way > 0.0 else grid.x[0]
            last = min(grid.t[1], line.t + way * (edge - line.x) / speed)
            time = np.linspace(line.t, last, PIECES) if last > line.t else np.empty(0)
            place = line.x + way * speed * (time - line.t)
            seen = np.flatnonzero(_recorded(grid, place, time))
            if seen.size:
                first = seen[0]
                end = first + int(np.argmin(np.append(np.diff(seen) == 1, False)))
                found.append(Front(*(float(one) for one in (place[first], time[first],
                                                           place[end], time[end]))))  # fmt: skip
    return [one for one in found if one.t1 > one.t0]


def _recorded(grid: Grid, x: Floats, t: Floats) -> NDArray[np.bool_]:
    """Say at which places and times the grid has a velocity."""
    rows, columns = grid.values.shape
    column = np.floor((x - grid.x[0]) / (grid.x[1] - grid.x[0]) * columns).astype(np.intp)
    row = np.floor((t - grid.t[0]) / (grid.t[1] - grid.t[0]) * rows).astype(np.intp)
    inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
    values = grid.values[np.clip(row, 0, rows - 1), np.clip(column, 0, columns - 1)]
    known: NDArray[np.bool_] = inside & np.isfinite(values)
    return known


def _waves(run: RunData, speed: float | None, grid: Grid) -> list[Layer]:
    if speed is None:
        return []
    drawn = fronts(wave_lines(run, grid.x), speed, grid)
    if not drawn:
        return []
    x0, t0, x1, t1 = np.array(drawn).T
    name = f"wave speed, {speed:.1f} m/s"
    return [Segments(x0, t0, x1, t1, colour="wave", width=1.2, name=name)]


def _window(
    run: RunData, motions: Sequence[WireMotion]
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the part of a report: some spans around the middle of the section, as they are run."""
    middle = float(np.mean(run.assessment.section_m))
    near = run.supports[np.argsort(np.abs(run.supports - middle))[: SPANS + 1]]
    begin, end = (
        (float(near.min()), float(near.max())) if near.size > 1 else run.assessment.section_m
    )
    times = motions[0].times
    first = np.interp(begin, run.position[:, 0], run.time)
    last = np.interp(end, run.position[:, -1], run.time)
    return (begin, end), (max(float(times[0]), float(first)), min(float(times[-1]), float(last)))
