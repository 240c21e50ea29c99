"""Velocity of the contact wire over any part of track and time, as an image's numbers."""

from typing import Any

import numpy as np
from starlette.responses import Response

from arcless.figures.run import space_time as figure
from arcless.figures.run.run_data import RunData
from arcless.figures.wires.wire_velocity import velocity_grid
from arcless.studio.answers.answers import Refused
from arcless.studio.charts import asked
from arcless.studio.charts.charted_run import ChartedRun
from arcless.studio.charts.plain.binary import binary

# Most cells along the track and in time: those of a large screen. More take longer than a second.
MOST_COLUMNS, MOST_ROWS = 2400, 1600
# Fewest metres and seconds of a part: below, a range has no extent in singles.
LEAST_M, LEAST_S = 0.01, 1e-4


def answer(run: ChartedRun, question: asked.Question) -> Response:
    """Return mean velocities as singles, row by row, the earliest first; NaN where there is none.

    The header tells the part, the scale, the wave speed, places from which fronts leave, and the
    paths of the pantographs; of a run without recorded motion only that it is one.

    Raises
    ------
    Refused
        The part has no extent.
    """
    motions = run.motions
    if not motions:
        return binary(b"", {"recorded": False})
    whole_x = (
        float(min(one.x[0] for one in motions)),
        float(max(one.x[-1] for one in motions)),
    )
    whole_t = float(motions[0].times[0]), float(motions[0].times[-1])
    x = _part(question, ("x0", "x1"), whole_x, LEAST_M)
    t = _part(question, ("from", "to"), whole_t, LEAST_S)
    columns = asked.whole(question, "width", 600, 1, MOST_COLUMNS)
    rows = asked.whole(question, "height", 400, 1, MOST_ROWS)
    grid = velocity_grid(motions, x, t, columns, rows)
    data, speed = run.data, figure.wave_speed(run.data)
    about: dict[str, Any] = {
        "recorded": True,
        "rows": grid.values.shape[0],
        "columns": grid.values.shape[1],
        "x": list(x),
        "t": list(t),
        "whole_x": list(whole_x),
        "whole_t": list(whole_t),
        "scale_end": figure.scale_end(grid),
        "largest": grid.largest,
        "wave_speed": speed,
        "fronts": [] if speed is None else figure.fronts(figure.wave_lines(data, x), speed, grid),
        "supports": [float(at) for at in data.supports if x[0] <= at <= x[1]],
        "paths": _paths(data, x, t),
    }
    return binary(grid.values.astype("<f4").tobytes(), about)


def _part(
    question: asked.Question, names: tuple[str, str], whole: tuple[float, float], least: float
) -> tuple[float, float]:
    low = asked.number(question, names[0], whole[0])
    high = asked.number(question, names[1], whole[1])
    if not high - low >= least:
        raise Refused(400, f"`{names[0]}` to `{names[1]}` has no extent")
    return low, high


def _paths(run: RunData, x: tuple[float, float], t: tuple[float, float]) -> list[dict[str, Any]]:
    found = []
    for layer in (one for one in figure.paths(run, x, t) if one.name):
        xs, ts = np.asarray(vars(layer)["x"]), np.asarray(vars(layer)["y"])
        found.append({
            "name": layer.name, "colour": layer.colour,
            "x": [round(float(one), 3) for one in xs], "t": [round(float(one), 5) for one in ts],
        })  # fmt: skip
    return found
