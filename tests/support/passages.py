"""Passages with known content: a force that is written down over a line of any spans."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from arcless.explanation.landmarks import Landmark, Landmarks
from arcless.explanation.pantograph_explanation import (
    PantographExplanation,
    Passage,
    explained,
)
from arcless.explanation.signals.line_coordinate import LineCoordinate
from arcless.explanation.signals.span_deviations import whole_spans
from arcless.pantograph.natural_modes import Band, PantographMode

SPEED, RATE, LOW_PASS = 50.0, 400.0, 20.0
EQUAL = (60.0,) * 10
UNEQUAL = (48.0, 60.0, 54.0, 60.0, 66.0, 54.0, 48.0, 60.0, 66.0, 54.0)
SPACING = 6.0
# A mode half way between orders 3 and 4 of the span of 60 m, 35 periods in the whole of `EQUAL`.
MODE = PantographMode(Band(2.8, 35.0 / 12.0, 3.05), 0.01, 0.5)

Force = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], Any]


def line_of(spans: Sequence[float], spacing: float | None = SPACING) -> LineCoordinate:
    """Return a line with droppers one spacing apart, half of it from each support."""
    supports = np.concatenate([[0.0], np.cumsum(spans)])
    if spacing is None:
        return LineCoordinate(supports, np.empty(0))
    places = [
        left + np.arange(0.5 * spacing, length, spacing)
        for left, length in zip(supports, spans, strict=False)
    ]
    return LineCoordinate(supports, np.concatenate(places))


def passage_over(
    line: LineCoordinate,
    force: Force,
    *,
    modes: Sequence[PantographMode] = (MODE,),
    speed: Callable[[np.ndarray], np.ndarray] | None = None,
    ends: tuple[float, float] | None = None,
) -> Passage:
    """Return a passage whose force is a function of time, position, ξ and ψ."""
    begin, end = ends or (float(line.supports[0]), float(line.supports[-1]))
    time = np.arange(round((end - begin) / SPEED * RATE)) / RATE
    x = begin + SPEED * time if speed is None else begin + speed(time)
    time, x = time[x < end], x[x < end]
    psi = line.intervals(x) if line.droppers.size else np.zeros_like(x)
    values = 100.0 + np.broadcast_to(force(time, x, line.spans(x), psi), x.shape)
    mean_speed = float((x[-1] - x[0]) / (time[-1] - time[0]))
    return Passage(
        "P1", x, np.array(values), RATE, LOW_PASS, mean_speed, (begin, end),
        whole_spans(line.supports, (begin, end), (begin, end)), list(modes),
    )  # fmt: skip


def explain_force(line: LineCoordinate, force: Force, **more: Any) -> PantographExplanation:
    """Explain a force that is written down."""
    supports = tuple(float(x) for x in line.supports)
    parts = [Landmark(x, f"support {n}") for n, x in enumerate(supports, start=1)]
    marks = Landmarks(supports, tuple(parts), (), ())
    return explained(passage_over(line, force, **more), line, marks)


def share(found: PantographExplanation, key: str) -> float:
    """Return the share of a group in %."""
    (value,) = [one.share_percent for one in found.groups if one.key == key]
    return value
