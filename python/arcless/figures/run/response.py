"""Figures of the line under the pantographs: uplift at supports, forces of droppers."""

from typing import Any

import numpy as np

from arcless.dataset.recorded_series import Place, is_recorded, passage
from arcless.figures.description import (
    Axis,
    Curve,
    Figure,
    Layer,
    Map,
    Points,
    Rules,
    Scale,
    Segments,
    Tip,
)
from arcless.figures.description.thinning import envelope, every
from arcless.figures.run.run_data import Floats, RunData
from arcless.figures.run.track import MARKS, along

# Places whose passage is drawn, points of each, and rows and columns of the map.
TRACES, TRACE_POINTS = 24, 400
ROWS, COLUMNS = 140, 320
# Drawn part of a passage, in m: from the train ahead of the place to the last one gone.
BEFORE_M, AFTER_M = 60.0, 120.0
MAP_HEIGHT = 420
# Part of the largest force below which a dropper counts as slack in a map.
SLACK = 1e-3
UPLIFT = "Uplift of the contact wire at supports"


def uplift(run: RunData) -> list[Figure]:
    """Return the maximum uplift at each support."""
    if not run.has("support_x", "support_uplift_max"):
        return []
    kept = every(run.values("support_x").size, MARKS)
    x, peak = run.values("support_x")[kept], 1e3 * run.values("support_uplift_max")[kept]
    names = [str(name) for name in run.values("support")[kept]]
    tips = (Tip("", names, form=""), Tip("maximum uplift", "y", "mm"), Tip("position", "x", "m"))
    layers: list[Layer] = [
        Segments(x, np.zeros_like(x), x, peak, colour="contact_wire", width=3.0, alpha=0.45),
        Points(x, peak, colour="contact_wire", size=8.0, name="maximum uplift", tips=tips),
    ]
    space = run.limit("uplift_space")
    top = float(peak.max(initial=0.0))
    if space is not None:
        half = 0.5 * space
        top = max(top, half)
        layers.append(
            Rules(axis="y", at=np.array([half]), colour="limit", dash="dashed", width=1.6,
                  name=f"half of the space for uplift: {half:g} mm")
        )  # fmt: skip
    inside = run.inside(x)
    found = f"{peak[inside].max():.1f} mm" if inside.size else "not known"
    y = Axis("maximum uplift", "mm", min(0.0, float(peak.min(initial=0.0))), 1.12 * top or 1.0)
    return [
        along(
            run, "uplift", UPLIFT, y, layers,
            alt=f"Maximum uplift at each support; in the analysis section at most {found}.",
        )
    ]  # fmt: skip


def uplift_passages(run: RunData) -> list[Figure]:
    """Return the uplift at the supports of the section while the train passes each."""
    if not is_recorded(run.dataset, "support"):
        return []
    inside = run.inside(run.values("support_x"))
    if not inside.size:
        return []
    peaks = run.values("support_uplift_max")[inside]
    chosen = inside[every(inside.size, TRACES)]
    most = inside[int(peaks.argmax())]
    pieces = [_passage(run, "support", int(i)) for i in (*chosen[chosen != most], most)]
    pale = [np.append(each, np.nan) for each in (p[0] for p in pieces[:-1])]
    values = [np.append(each, np.nan) for each in (1e3 * p[1] for p in pieces[:-1])]
    name = str(run.values("support")[most])
    x, y = pieces[-1][0], 1e3 * pieces[-1][1]
    layers: list[Layer] = [
        *_pantographs(run),
        Curve(x, y, colour="contact_wire", width=2.2, name=f"largest uplift: {name}",
              tips=(Tip("uplift", "y", "mm"), Tip("distance", "x", "m"))),
    ]  # fmt: skip
    if pale:
        others = Curve(np.concatenate(pale), np.concatenate(values), colour="raw", width=1.0,
                       name="other supports of the section")  # fmt: skip
        layers.insert(0, others)
    return [
        Figure(
            "uplift-passages", "Uplift while the train passes a support",
            Axis("distance past the support", "m", -BEFORE_M, _after(run)), Axis("uplift", "mm"),
            layers,
            caption=f"Supports of the analysis section, overlaid.{_whose(run)}",
            alt=f"Uplift at the supports while the train passes; largest at {name}:"
            f" {y.max(initial=0.0):.1f} mm.",
        )
    ]  # fmt: skip


def dropper_range(run: RunData) -> list[Figure]:
    """Return the range of every dropper's force, and its force at rest."""
    if not run.has("dropper_x", "dropper_force_min", "dropper_force_max"):
        return []
    kept = every(run.values("dropper_x").size, MARKS)
    if not kept.size:
        return []
    x, low, high = (
        run.values(name)[kept] for name in ("dropper_x", "dropper_force_min", "dropper_force_max")
    )
    names = [str(name) for name in run.values("dropper")[kept]]
    tips = [Tip("", names, form=""), Tip("minimum", low, "N"), Tip("maximum", high, "N")]
    rest = run.values("dropper_force_static")
    slack = low <= 0.0
    layers: list[Layer] = [
        Segments(x, low, x, high, colour="dropper", width=3.0, alpha=0.7,
                 name="minimum to maximum"),
    ]  # fmt: skip
    if rest.size:
        tips.append(Tip("at rest", rest[kept], "N"))
        layers.append(Points(x, rest[kept], colour="messenger_wire", size=5.0, name="at rest"))
    layers.append(Points(x, high, colour="dropper", size=4.0, tips=tuple(tips)))
    if slack.any():
        layers.append(
            Points(x[slack], low[slack], colour="slack", shape="triangle", size=7.0,
                   name="slack at some time")
        )  # fmt: skip
    return [
        along(
            run, "droppers", "Range of the dropper forces", Axis("dropper force", "N"), layers,
            alt=f"Range of the dropper forces, from {low.min():.1f} to {high.max():.1f} N;"
            f" {int(slack.sum())} of {len(x)} droppers are slack at some time.",
        )
    ]  # fmt: skip


def dropper_map(run: RunData) -> list[Figure]:
    """Return the forces of the section's droppers while the train passes, as a map."""
    if not (run.has("dropper_x", "dropper_span") and is_recorded(run.dataset, "dropper")):
        return []
    chosen = _rows(run)
    if not chosen.size:
        return []
    left, right = -BEFORE_M, _after(run)
    half = 0.5 * (right - left) / COLUMNS
    places = left + half * (2.0 * np.arange(COLUMNS) + 1.0)
    forces = np.full((chosen.size, COLUMNS), np.nan)
    for row, index in enumerate(chosen):
        x, values = _passage(run, "dropper", int(index), thin=False)
        if x.size > 1:
            forces[row] = np.interp(places, x, values, left=np.nan, right=np.nan)
    high = float(np.nanmax(forces, initial=1.0))
    spans = run.values("dropper_span")[chosen]
    first = np.append(True, spans[1:] != spans[:-1])
    labels = tuple(f"span {span}" if new else "" for span, new in zip(spans, first, strict=True))
    grid = Map((left, right), (-0.5, chosen.size - 0.5), forces,
               tips=(Tip("dropper force", "x", "N"),))  # fmt: skip
    slack = int(np.sum(np.nanmin(forces, axis=1, initial=np.inf) <= SLACK * high))
    return [
        Figure(
            "dropper-map", "Dropper forces while the train passes",
            Axis("distance past the dropper", "m", left, right),
            Axis("dropper", "", -0.5, chosen.size - 0.5, categories=labels),
            [grid, *_pantographs(run)],
            caption="One row for each dropper, in their order along the track from the bottom."
            f"{_whose(run)}",
            alt=f"Forces of {chosen.size} droppers while the train passes, up to {high:.0f} N;"
            f" {slack} of them go slack.",
            height=MAP_HEIGHT,
            scale=Scale("dropper force", "N", SLACK * high, high, under="slack",
                        under_label="slack"),
        )
    ]  # fmt: skip


def _rows(run: RunData) -> Any:
    """Return the droppers of the map: of whole spans around the middle of the section."""
    x, spans = run.values("dropper_x"), run.values("dropper_span")
    inside = run.inside(x)
    if inside.size <= ROWS:
        return inside
    middle = float(np.mean(run.assessment.section_m))
    chosen: Any = np.empty(0, dtype=np.intp)
    numbers = np.unique(spans[inside])
    centres = [abs(float(x[spans == number].mean()) - middle) for number in numbers]
    for number in numbers[np.argsort(centres)]:
        more = np.append(chosen, np.flatnonzero(spans == number))
        if more.size > ROWS and chosen.size:
            break
        chosen = more
    return np.sort(chosen)[:ROWS]


def _after(run: RunData) -> float:
    """Return the end of a passage in m: the last pantograph has left the place behind."""
    return AFTER_M + float(np.ptp(run.position[0]))


def _whose(run: RunData) -> str:
    """Return a sentence about the distance, where there are several pantographs."""
    return " The distance is that of the first pantograph." if len(run.pantographs) > 1 else ""


def _pantographs(run: RunData) -> list[Layer]:
    """Return rules where each pantograph is at the place."""
    at = float(run.position[0].max()) - np.asarray(run.position[0], dtype=float)
    name = "pantographs at the place" if at.size > 1 else "pantograph at the place"
    return [Rules(axis="x", at=at, colour="ink", dash="dotted", width=1.2, name=name)]


def _passage(run: RunData, place: Place, index: int, *, thin: bool = True) -> tuple[Floats, Floats]:
    """Return distance of the first pantograph beyond a place in m, and the recorded values."""
    rows, values = passage(run.dataset, place, index)
    beyond = run.line_position[rows] - run.values(f"{place}_x")[index]
    near = np.flatnonzero((beyond > -BEFORE_M) & (beyond < _after(run)))
    kept = near[envelope(values[near], TRACE_POINTS)] if near.size and thin else near
    return beyond[kept], values[kept]
