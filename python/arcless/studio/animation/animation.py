"""The animation of a run, of a size, with what is said of it."""

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess import Assessment
from arcless.dataset.plain_dataset import Dataset
from arcless.errors import OutputError
from arcless.figures.run.run_data import RunData
from arcless.report.drawing.animation import Animation
from arcless.results import Result
from arcless.studio.animation import channels
from arcless.studio.animation.cut import Cut, cut
from arcless.studio.animation.packing import text_of
from arcless.studio.animation.recorded import recorded
from arcless.studio.animation.rows import Motion
from arcless.studio.animation.thinning import Thinned, thinned
from arcless.studio.at_rest.of_run import geometry_of_run

# Files that `make page` builds.
FOLDER = Path(__file__).resolve().parent.parent / "page" / "animation"
# Size of the motion in bytes of base64. A report has less than 2 MB besides; mail servers refuse
# 10 MB and more.
LIMIT = 4e6
# Time in s by which it begins before the worst place.
BEFORE = 1.0

Floats = NDArray[np.float64]


def animation_of(
    result: Result, *, assessment: Assessment | None = None, limit: float = LIMIT
) -> Animation:
    """Return the animation of a run as a report carries it.

    Parameters
    ----------
    result
        A run whose motion was recorded.
    assessment
        An assessment over another section or filter than the scenario's own.
    limit
        Size of its data in bytes: motion beyond it is thinned, and at last shortened to the time
        around the worst place.

    Raises
    ------
    OutputError
        The run has no recorded motion, or the player was not built.
    """
    data, geometry = result.latest, geometry_of_run(result)
    motion = recorded(data, geometry)
    script, style = _player()
    run = RunData(data, assessment or result.assessment)
    worst = _worst_places(run)
    worst_s = _time_at(run, worst[0])
    count = len(run.pantographs)
    small = thinned(motion, geometry, worst_s, limit - count * channels.FORCE_BYTES, count)
    left = cut(geometry, small.kept)
    packed = _packed(run, small, left, worst, worst_s)
    text = json.dumps(packed, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    return Animation(script, style, text, _caption(motion, small, packed, len(text)))


def _player() -> tuple[str, str]:
    """Return script and style of the player."""
    try:
        script = (FOLDER / "animation.js").read_text("utf-8")
        return script, (FOLDER / "animation.css").read_text("utf-8")
    except OSError as error:
        raise OutputError(
            "the player of animations is not built", hint="`make page` builds it"
        ) from error


def _worst_places(run: RunData) -> list[float]:
    """Return positions in m of large deviations of the filtered force, the largest first."""
    explained = run.explanation
    if explained is not None:
        places = [place for one in explained.pantographs for place in one.worst]
        places.sort(key=lambda place: -abs(place.deviation_N))
        if places:
            return [place.position_m for place in places]
    total, inside = run.record.bands.total, run.record.inside
    inside = inside if inside.any() else np.ones_like(inside)
    deviation = np.where(inside, np.abs(total - total[inside].mean()), 0.0)
    row, number = np.unravel_index(int(np.argmax(deviation)), deviation.shape)
    return [float(run.position[row, number])]


def _time_at(run: RunData, x: float) -> float:
    """Return the time in s at which the first pantograph is at a position in m."""
    return float(np.interp(x, run.position[:, 0], run.time))


def _packed(
    run: RunData, small: Thinned, left: Cut, worst: list[float], worst_s: float
) -> dict[str, Any]:
    times, data = small.motion.times, run.dataset
    low, high = _seen(run, times)
    blocks = [
        *channels.wires(small.motion),
        *channels.droppers(data, left.droppers, times),
        *channels.along(data, "support_uplift", "supports", left.supports, times),
        *channels.pantographs(data, times),
    ]
    begin = min(max(worst_s - BEFORE, times[0]), times[-1])
    return {
        "geometry": left.geometry,
        "pantographs": [{"name": name, "masses": _masses(data)} for name in run.pantographs],
        "times": text_of(times, "<f8"),
        "row_s": float(np.median(np.diff(times))) if len(times) > 1 else 0.0,
        "begin_s": float(begin),
        "blocks": blocks,
        "force": channels.forces(run, low, high),
        "worst": sorted({round(x, 2) for x in worst if low <= x <= high}),
    }


def _seen(run: RunData, times: Floats) -> tuple[float, float]:
    """Return between which positions in m any pantograph is at these times."""
    at = (run.time >= times[0]) & (run.time <= times[-1])
    seen = run.position[at]
    return float(seen.min()), float(seen.max())


def _masses(data: Dataset) -> list[str]:
    if "mass" not in data:
        return []
    return [f"mass {number}" for number in np.asarray(data["mass"].values).tolist()]


def _caption(motion: Motion, small: Thinned, packed: dict[str, Any], size: int) -> str:
    """Return what is seen, and what was left out of the record."""
    every = 1e3 * packed["row_s"]
    steps = [one["step"] for one in packed["blocks"] if one["name"].endswith((".up", ".across"))]
    nodes = "all nodes" if small.level[1] == 0.0 else f"nodes {small.level[1]:g} m apart"
    first, last = small.motion.times[[0, -1]]
    part = (
        "The whole of the recorded motion"
        if small.whole
        else f"The motion from {first:.1f} to {last:.1f} s, around the worst place, of"
        f" {motion.times[0]:.1f} to {motion.times[-1]:.1f} s recorded"
    )
    return (
        f"{part}: a row every {every:.3g} ms, {nodes}, displacements in steps of"
        f" {1e3 * max(steps):.3g} mm, {size / 1e6:.1f} MB. Between rows it is linear in time;"
        " outside of the recorded window around the pantographs the line is drawn at rest. Heights"
        " and displacements have the same scale, which the drawing names; distances of the masses"
        " from one another are a scheme. It begins a second before the worst place."
    )
