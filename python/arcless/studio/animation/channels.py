"""Channels of a run at the times of its motion: pantographs, droppers, supports, force by place."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.plain_dataset import Dataset
from arcless.figures.description.thinning import envelope
from arcless.figures.run.run_data import RunData
from arcless.studio.animation.packing import block, text_of
from arcless.studio.animation.rows import Motion

# Values of the force of a pantograph that strips draw: the width of a large screen, twice. And
# their bytes, unfiltered and filtered, of position, lowest and highest value.
FORCES = 5000
FORCE_BYTES = 2 * 3 * FORCES * 4 * 4 / 3

Floats = NDArray[np.float64]


def wires(motion: Motion) -> list[dict[str, Any]]:
    """Return the displacements of wires."""
    found = []
    for one in motion.wires:
        found.append(block(f"wire.{one.wire}.up", one.first, one.count, one.up))
        if one.across is not None:
            found.append(block(f"wire.{one.wire}.across", one.first, one.count, one.across))
    return found


def pantographs(data: Dataset, times: Floats) -> list[dict[str, Any]]:
    """Return position, force, height of the wire, its uplift (not known), displacements of masses.

    Values are those of the last row of the record at or before each time in s.
    """
    rows = _rows(np.asarray(data["time"].values), times)
    unknown = np.full(rows.size, np.nan)
    found = []
    for number in range(len(data["pantograph"].values)):
        columns = [_column(data, name, rows, number) for name in ("position", "contact_force")]
        columns += [_column(data, "contact_height", rows, number), unknown]
        if "mass_displacement" in data:
            masses = np.asarray(data["mass_displacement"].values)[rows, number]
            columns += [mass for mass in masses.T if np.isfinite(mass).all()]
        found.append(_full(f"pantograph.{number}", np.column_stack(columns), singles=True))
    return found


def _column(data: Dataset, name: str, rows: NDArray[np.intp], number: int) -> Floats:
    if name not in data:
        return np.full(rows.size, np.nan)
    found: Floats = np.asarray(data[name].values)[rows, number]
    return found


def along(
    data: Dataset, name: str, channel: str, chosen: NDArray[np.intp], times: Floats
) -> list[dict[str, Any]]:
    """Return a channel of droppers or supports, those of all or of those near the pantographs.

    Parameters
    ----------
    data
        Dataset of the run.
    name
        Name of the variable of all, such as ``dropper_force``; of those near a pantograph it is
        ``near_dropper_force`` with ``near_dropper_first``.
    channel
        Name of the channel on the studio's stream.
    chosen
        Which droppers or supports the animation has, from 0.
    times
        Times of its rows in s.
    """
    kind = name.partition("_")[0]
    if not chosen.size:
        return []
    if name in data:
        rows = _rows(np.asarray(data["line_time"].values), times)
        return [_full(channel, np.asarray(data[name].values)[np.ix_(rows, chosen)])]
    if f"near_{name}" not in data:
        return []
    rows = _rows(np.asarray(data["line_time"].values), times)
    near = np.asarray(data[f"near_{name}"].values)[rows]
    first = np.asarray(data[f"near_{kind}_first"].values)[rows]
    return [_full(channel, _of_near(near, first, chosen))]


def droppers(data: Dataset, chosen: NDArray[np.intp], times: Floats) -> list[dict[str, Any]]:
    """Return the forces of droppers, at the rows of the motion where they were recorded with it."""
    if "motion_dropper_force" not in data or not chosen.size:
        return along(data, "dropper_force", "droppers", chosen, times)
    order = np.asarray(data["motion_dropper_order"].values).astype(int)
    place = np.empty(order.size, dtype=int)
    place[order] = np.arange(order.size)
    rows = _rows(np.asarray(data["motion_time"].values), times)
    near = np.asarray(data["motion_dropper_force"].values)[rows]
    first = np.asarray(data["motion_dropper_first"].values)[rows]
    return [_full("droppers", _of_near(near, first, place[chosen]))]


def _of_near(near: Floats, first: NDArray[Any], places: NDArray[np.intp]) -> Floats:
    """Return values at places, of rows that begin at a place of their own; NaN outside of them."""
    columns = places[None, :] - first.astype(int)[:, None]
    inside = (columns >= 0) & (columns < near.shape[1])
    values = np.take_along_axis(near, np.where(inside, columns, 0), axis=1)
    return np.where(inside, values, np.nan)


def _full(name: str, values: Floats, *, singles: bool = False) -> dict[str, Any]:
    rows, width = values.shape
    first, count = np.zeros(rows, dtype=int), np.full(rows, width)
    return block(name, first, count, values, singles=singles)


def _rows(recorded: Floats, times: Floats) -> NDArray[np.intp]:
    """Return the last recorded row at or before each time; rounding of times is no row."""
    found: NDArray[np.intp] = np.searchsorted(recorded, times + 1e-9, side="right") - 1
    return np.clip(found, 0, len(recorded) - 1)


def forces(run: RunData, low: float, high: float) -> dict[str, Any]:
    """Return unfiltered and filtered force in N between two positions in m, by pantograph."""
    both = {"raw": run.record.force, "filtered": run.record.bands.total}
    return {
        name: [
            _by_place(run.position[:, number], force[:, number], low, high)
            for number in range(force.shape[1])
        ]
        for name, force in both.items()
    }


def _by_place(x: Floats, force: Floats, low: float, high: float) -> dict[str, str] | None:
    inside = np.flatnonzero((x >= low) & (x <= high) & np.isfinite(force))
    if inside.size < 2:  # noqa: PLR2004 - a curve has two ends
        return None
    chosen = inside[envelope(force[inside], FORCES)]
    values = text_of(force[chosen], "<f4")
    return {"x": text_of(x[chosen], "<f4"), "low": values, "high": values}
