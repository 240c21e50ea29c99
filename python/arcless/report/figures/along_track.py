"""Figures along the track: force, height and uplift, on one shared axis."""

from typing import Any

import numpy as np

from arcless.dataset.recorded_series import Place, is_recorded, passage
from arcless.report.drawing.bokeh_objects import Field, Model, columns
from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import GREY, add_hover, add_legend, colour, plain, single
from arcless.report.drawing.thinning import envelope, every
from arcless.report.figures.run_data import RunData
from arcless.report.figures.track_axis import (
    MARKS,
    RAW_POINTS,
    SMOOTH_POINTS,
    hover,
    series,
    support_entry,
    track_figure,
)
from arcless.report.figures.wire_points import wire_points

X_LABEL_FRONT = "position of the first pantograph, m"

TRACES, TRACE_POINTS = 24, 400

# Drawn part of a place's channel, in m: from the train ahead of it to the last one gone.
BEFORE_M, AFTER_M = 100.0, 200.0


def force(scene: RunData) -> Figure:
    """Draw the contact force, unfiltered and filtered, with supports and droppers marked."""
    title = f"Contact force after the {scene.assessment.low_pass_Hz:g} Hz low-pass, and unfiltered"
    fig = track_figure(scene, title, "contact force, N", height=360)
    entries, filtered, unfiltered = [], [], []
    for i, name in enumerate(scene.pantographs):
        raw = series(scene, i, scene.record.force[:, i], RAW_POINTS)
        smooth = series(scene, i, scene.record.bands.total[:, i], SMOOTH_POINTS)
        thin = fig.draw("Line", raw, color=colour(i), line_width=0.8, alpha=0.5)
        thick = fig.draw("Line", smooth, color=colour(i), line_width=1.6, name=plain(name))
        entries.append((name, [thick]))
        filtered.append(thick)
        unfiltered.append(thin)
    entries.append(("unfiltered", unfiltered))
    if scene.has("dropper_x"):
        x = single(scene.values("dropper_x")[every(scene.values("dropper_x").size, MARKS)])
        feet = {"x": x, "y": np.zeros_like(x)}
        ticks = fig.draw("Scatter", feet, marker="dash", angle=np.pi / 2, size=8, color=GREY)
        entries.append(("dropper", [ticks]))
    entries += support_entry(scene, fig)
    add_legend(fig, entries)
    hover(fig, filtered, "force", "0.0 N")
    return fig


def gap(scene: RunData) -> Figure | None:
    """Draw the gap between strip and wire where contact is lost, or could be without a trace."""
    values = scene.values("contact_gap")
    if not (scene.rigid_contact or np.any(scene.record.force <= 0.0)):
        return None
    fig = track_figure(scene, "Gap between collector strip and contact wire", "gap, mm")
    entries, lines = [], []
    for i, name in enumerate(scene.pantographs):
        path = series(scene, i, 1e3 * values[:, i], RAW_POINTS)
        line = fig.draw("Line", path, color=colour(i), line_width=1.2, name=plain(name))
        entries.append((name, [line]))
        lines.append(line)
    largest = float(1e3 * values.max(initial=0.0))
    fig.y_range = Model("Range1d", start=0.0, end=1.1 * largest or 1.0)
    add_legend(fig, [*entries, *support_entry(scene, fig)])
    hover(fig, lines, "gap", "0.000 mm")
    return fig


def height(scene: RunData) -> Figure:
    """Draw the height of the contact point over the height of the wire at rest."""
    fig = track_figure(scene, "Height of the contact point", "height above rail, m")
    entries, hovered = [], []
    if scene.has("contact_wire_node_x", "contact_wire_node_z"):
        x, z = wire_points(scene, "contact_wire", "z", SMOOTH_POINTS)
        rest = fig.draw("Line", {"x": single(x), "y": single(z)}, color=GREY)
        entries.append(("contact wire at rest", [rest]))
    for i, name in enumerate(scene.pantographs):
        path = series(scene, i, scene.dataset["contact_height"].values[:, i], SMOOTH_POINTS)
        line = fig.draw("Line", path, color=colour(i), line_width=1.4, name=plain(name))
        entries.append((name, [line]))
        hovered.append(line)
    fig.yaxis.formatter = Model("NumeralTickFormatter", format="0.00")
    add_legend(fig, [*entries, *support_entry(scene, fig)])
    hover(fig, hovered, "height", "0.000 m")
    return fig


def uplift(scene: RunData) -> Figure | None:
    """Draw the uplift at supports: the section's during the passage, and the peak of each."""
    if not scene.has("support_x", "support_uplift_max"):
        return None
    fig = track_figure(scene, "Uplift of the contact wire at supports", "uplift, mm")
    fig.xaxis.axis_label = f"{X_LABEL_FRONT} (peaks: of the support)"
    inside = scene.inside(scene.values("support_x"))
    chosen = inside[every(inside.size, TRACES)]
    tip = ("uplift", "$snap_y{0.0} mm")
    entries = _passages(scene, fig, "support", chosen, scale=1e3, tip=tip)
    x, peak = scene.values("support_x"), 1e3 * scene.values("support_uplift_max")
    kept = every(x.size, MARKS)
    data = {"x": single(x[kept]), "y": single(peak[kept]), "name": _names(scene, "support", kept)}
    dots = fig.draw("Scatter", data, size=6, color=colour(0))
    add_hover(fig, [dots], [("", "@name"), ("highest uplift", "@y{0.0} mm")])
    add_legend(fig, [*entries, ("peak at each support", [dots]), *support_entry(scene, fig)])
    return fig


def droppers(scene: RunData) -> Figure | None:
    """Draw the range of every dropper's force, and its force at rest."""
    if not scene.has("dropper_x", "dropper_force_min", "dropper_force_max"):
        return None
    fig = track_figure(scene, "Range of the dropper forces", "dropper force, N")
    kept = every(scene.values("dropper_x").size, MARKS)
    names = {"x": "dropper_x", "low": "dropper_force_min", "high": "dropper_force_max"}
    if scene.has("dropper_force_static"):
        names["rest"] = "dropper_force_static"
    data = {key: single(scene.values(name)[kept]) for key, name in names.items()}
    source = columns({**data, "name": _names(scene, "dropper", kept)})
    ends = ("x", "low", "x", "high")
    bars = fig.draw("Segment", source, *ends, line_width=3, color=colour(0), alpha=0.45)
    entries = [("lowest to highest", [bars])]
    tips = [("", "@name"), ("lowest", "@low{0.0} N"), ("highest", "@high{0.0} N")]
    if "rest" in data:
        rest = fig.draw("Scatter", source, "x", "rest", size=5, color=colour(1))
        entries.append(("at rest", [rest]))
        tips.append(("at rest", "@rest{0.0} N"))
    add_hover(fig, [bars], tips)
    add_legend(fig, [*entries, *support_entry(scene, fig)])
    return fig


def dropper_passages(scene: RunData) -> Figure | None:
    """Draw the forces of the droppers of the section's middle span while the train passes."""
    if not (scene.has("dropper_x", "dropper_span") and is_recorded(scene.dataset, "dropper")):
        return None
    span = scene.values("dropper_span")
    middle = int(np.argmin(np.abs(scene.values("dropper_x") - np.mean(scene.assessment.section_m))))
    chosen = np.flatnonzero(span == span[middle])[:TRACES]
    title = f"Dropper forces in span {int(span[middle])}"
    fig = track_figure(scene, title, "dropper force, N")
    fig.xaxis.axis_label = X_LABEL_FRONT
    tip = ("force", "$snap_y{0.0} N")
    _passages(scene, fig, "dropper", chosen, scale=1.0, tip=tip)
    support_entry(scene, fig)
    return fig


def _passages(
    scene: RunData, fig: Figure, place: Place, chosen: Any, *, scale: float, tip: tuple[str, str]
) -> list[tuple[str, list[Model]]]:
    """Draw the channel of some supports or droppers, each while the train is there."""
    x = scene.values(f"{place}_x")
    if not is_recorded(scene.dataset, place):
        return []
    pieces = [_passage(scene, place, i, x[i]) for i in chosen]
    data = {
        "xs": [single(scene.line_position[kept]) for kept, _ in pieces],
        "ys": [single(scale * values) for _, values in pieces],
        "name": _names(scene, place, chosen),
        "colour": [colour(n) for n in range(len(pieces))],
    }
    lines = fig.draw("MultiLine", data, line_width=1.2, color=Field("colour"))
    add_hover(fig, [lines], [("", "@name"), tip], line_policy="interp")
    return [("passage of the train", [lines])]


def _passage(scene: RunData, place: Place, index: int, x: float) -> tuple[Any, Any]:
    rows, values = passage(scene.dataset, place, index)
    beyond = scene.line_position[rows] - x
    train = float(np.ptp(scene.dataset["position"].values[0]))
    near = np.flatnonzero((beyond > -BEFORE_M) & (beyond < train + AFTER_M))
    kept = near[envelope(values[near], TRACE_POINTS)] if near.size else near
    return rows[kept], values[kept]


def _names(scene: RunData, dimension: str, kept: Any) -> list[str]:
    return [plain(str(name)) for name in scene.values(dimension)[kept]]
