"""The track as an axis: its range, supports and spans along it, names of places on it."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.explanation.landmarks import beside
from arcless.figures.description import Axis, Curve, Figure, Layer, Rules, Strip, Texts, Tip
from arcless.figures.description.thinning import envelope, every
from arcless.figures.description.tokens import of_pantograph
from arcless.figures.run.run_data import Floats, RunData

GROUP = "track"
LABEL = "position along the track"
# Points in the file of an unfiltered channel, shared by the pantographs.
RAW_POINTS = 6000
# Points of filtered channels of runs that are too long for all samples.
EXTREMES = 8000
# Most supports or droppers that are marked.
MARKS = 1000
# Two spans are as long as each other within this.
SAME_LENGTH = 0.01


def titled(run: RunData, title: str, pantograph: int) -> str:
    """Return a title with the name of the pantograph, where there are several."""
    return f"{title}, {run.pantographs[pantograph]}" if len(run.pantographs) > 1 else title


def axis(run: RunData) -> Axis:
    """Return the axis that the figures along the track share."""
    begin, end = float(run.position[0].min()), float(run.position[-1].max())
    margin = 0.01 * (end - begin)
    low, high = begin - margin, end + margin
    line = run.supports
    bounds = (min(begin, *line[:1]) - margin, max(end, *line[-1:]) + margin) if line.size else None
    return Axis(LABEL, "m", low, high, bounds or (low, high), group=GROUP)


def ground(run: RunData) -> list[Layer]:
    """Return what lies below all figures along the track: the analysis section, the supports."""
    begin, end = run.assessment.section_m
    section = Strip(axis="x", low=begin, high=end, colour="section", alpha=0.06)
    return [section, *supports(run)]


def gaps(run: RunData, pantograph: int) -> list[Layer]:
    """Return stretches of the section that the numbers of a pantograph leave out, as shades."""
    found = run.left_out(pantograph)
    return [
        Strip(axis="x", low=found[row][0], high=found[row][1], colour="open", alpha=0.18,
              name="" if place else "left out")
        for place, row in enumerate(every(len(found), MARKS) if found else ())
    ]  # fmt: skip


def supports(run: RunData) -> list[Layer]:
    """Return the supports as lines from edge to edge."""
    if not run.supports.size:
        return []
    at = run.supports[every(run.supports.size, MARKS)]
    return [Rules(axis="x", at=at, colour="support", name="support", dash="dotted")]


def filtered(run: RunData, pantograph: int, values: Floats, word: str, **look: Any) -> Curve:
    """Return a filtered channel of a pantograph over its position.

    Parameters
    ----------
    run
        The run.
    pantograph
        Number of the pantograph, from 0.
    values
        The whole channel, in the unit that is shown.
    word
        Name of the quantity, its unit and the decimals to show, such as ``"height m 0.000"``.
    **look
        Others of the curve.
    """
    name, unit, form = word.rsplit(" ", 2)
    tips = [Tip(name, "y", unit, form), Tip("position", "x", "m")]
    if run.sampled is None:
        rows = envelope(values, EXTREMES // len(run.pantographs))
        x = run.position[rows, pantograph]
    else:
        rows, x = run.sampled[pantograph].rows, run.sampled[pantograph].x
        tips.append(Tip("time", run.sampled[pantograph].t, "s", "0.000"))
    look = {"colour": of_pantograph(pantograph), "width": 1.6, "tips": tuple(tips), **look}
    return Curve(x, values[rows], **look)


def thinned(run: RunData) -> str:
    """Return a sentence where filtered channels are too long to draw all samples."""
    return "" if run.sampled is not None else " Of this long run the extremes are drawn."


def unfiltered(
    run: RunData,
    pantograph: int,
    values: Floats,
    *,
    shown: NDArray[np.bool_] | None = None,
    **look: Any,
) -> Curve:
    """Return an unfiltered channel of a pantograph, of which every peak is kept.

    Parameters
    ----------
    run
        The run.
    pantograph
        Number of the pantograph, from 0.
    values
        The whole channel, in the unit that is shown.
    shown
        Samples that are drawn; all of them without.
    **look
        Others of the curve.
    """
    rows = np.arange(values.size) if shown is None else np.flatnonzero(shown)
    most = rows.size if run.whole else max(200, RAW_POINTS // len(run.pantographs))
    kept = rows[envelope(values[rows], most)]
    look = {"colour": "raw", "width": 0.9, **look}
    return Curve(run.position[kept, pantograph], values[kept], **look)


def span_at(run: RunData, x: float) -> int | None:
    """Return the number of the span that a place is in, from 1; None beyond the line."""
    place = int(np.searchsorted(run.supports, x, side="right"))
    return place if 0 < place < run.supports.size else None


def place_name(run: RunData, x: float) -> str:
    """Return where a place is in words: span, and distance to the nearest dropper or support."""
    span = span_at(run, x)
    where = f"{x:.1f} m" if span is None else f"{x:.1f} m, span {span}"
    near = _nearest(run, x, span)
    return f"{where}, {near}" if near else where


def _nearest(run: RunData, x: float, span: int | None) -> str:
    """Return the distance to what is nearest: a support, or a dropper of the span."""
    if span is None:
        return ""
    left, right = run.supports[span - 1], run.supports[span]
    places = [(abs(x - left), x - left, f"support {span}")]
    places.append((abs(x - right), x - right, f"support {span + 1}"))
    droppers = run.values("dropper_x")[run.values("dropper_span") == span]
    if droppers.size:
        names = run.values("dropper")[run.values("dropper_span") == span]
        nearest = int(np.argmin(np.abs(droppers - x)))
        name = str(names[nearest]).removeprefix(f"span {span} ")
        places.append((abs(x - droppers[nearest]), x - droppers[nearest], name))
    _, signed, name = min(places, key=lambda place: place[0])
    return beside(signed, name)


def span_numbers(run: RunData, low: float, high: float, y: float) -> list[Layer]:
    """Return the numbers of the spans between two places, at a height."""
    inner = [
        (0.5 * (left + right), f"span {number}")
        for number, (left, right) in enumerate(
            zip(run.supports[:-1], run.supports[1:], strict=True), start=1
        )
        if low - SAME_LENGTH <= left and right <= high + SAME_LENGTH
    ]
    if not inner:
        return []
    x, texts = zip(*inner, strict=True)
    return [Texts(np.array(x), np.full(len(x), y), list(texts), colour="soft", baseline="top")]


def along(
    run: RunData, key: str, title: str, y: Axis, layers: Sequence[Layer], **more: Any
) -> Figure:
    """Return a figure along the track; supports and the analysis section lie below its layers."""
    return Figure(key, title, axis(run), y, [*ground(run), *layers], **more)
