"""Figures of the line itself: its shape at rest, its elasticity, and the energy ledger."""

import numpy as np
from numpy.typing import NDArray

from arcless.report.drawing.figure import Figure
from arcless.report.drawing.style import (
    COLOURS,
    DASHES,
    GREY,
    LIGHT,
    add_hover,
    add_legend,
    colour,
    figure,
    single,
)
from arcless.report.drawing.thinning import envelope, every
from arcless.report.figures.run_data import RunData
from arcless.report.figures.track_axis import MARKS, X_LABEL
from arcless.report.figures.wire_points import wire_points

Floats = NDArray[np.float64]

NODE_POINTS = 1500
ENERGY_ROWS = 500

WIRES = (
    ("contact_wire", "contact wire", 0),
    ("messenger_wire", "messenger wire", 7),
    ("auxiliary_wire", "auxiliary wire", 2),
    ("stitch_wire", "stitch wires", 1),
    ("bridle", "bridles", 1),
)


def side_view(scene: RunData) -> Figure | None:
    """Draw the line at rest from the side; heights are drawn larger than lengths."""
    fig = _view(scene, "Initial configuration, side view", "z", "height above rail, m", 280)
    if fig is None:
        return None
    if scene.has("dropper_x", "dropper_top_z", "dropper_bottom_z"):
        kept = every(scene.values("dropper_x").size, MARKS)
        x = single(scene.values("dropper_x")[kept])
        top, foot = (single(scene.values(f"dropper_{end}_z")[kept]) for end in ("top", "bottom"))
        fig.draw("Segment", {"x0": x, "y0": top, "x1": x, "y1": foot}, color=GREY)
    return fig


def plan_view(scene: RunData) -> Figure | None:
    """Draw the line at rest from above when it is not straight."""
    sides = [scene.values(f"{wire}_node_y") for wire, _, _ in WIRES]
    if not any(side.size and np.ptp(side) > 0.0 for side in sides):
        return None
    return _view(scene, "Initial configuration, from above", "y", "across the track, m", 220)


def elasticity(scene: RunData) -> Figure | None:
    """Draw the static elasticity of the contact wire."""
    if not scene.has("elasticity"):
        return None
    values = 1e3 * scene.values("elasticity")
    total = float(values.max() + values.min())
    title = "Elasticity of the contact wire at rest"
    if total > 0.0:
        title += f" (non-uniformity {100.0 * np.ptp(values) / total:.0f} %)"
    fig = figure(title, X_LABEL, "elasticity, mm/N")
    kept = envelope(values, NODE_POINTS)
    points = {"x": single(scene.values("elasticity_x")[kept]), "y": single(values[kept])}
    line = fig.draw("Line", points, color=colour(0), line_width=1.6)
    add_hover(fig, [line], [("elasticity", "@y{0.000} mm/N"), ("position", "@x{0.0} m")])
    return fig


def energy(scene: RunData) -> Figure | None:
    """Draw every term of the energy ledger over time."""
    terms = [(name, label) for name, label in energy_terms(scene) if settled(scene, name).any()]
    if not terms:
        return None
    fig = figure("Terms that are not zero throughout", "time, s", "energy, J", height=420)
    times = scene.values("line_time")[np.isfinite(scene.values(terms[0][0]))]
    kept = every(times.size, ENERGY_ROWS)
    time = single(times[kept])
    entries = []
    for i, (name, label) in enumerate(terms):
        dash = ((), DASHES)[i // len(COLOURS) % 2]
        points = {"x": time, "y": single(settled(scene, name)[kept])}
        line = fig.draw("Line", points, color=colour(i), line_dash=dash)
        add_hover(fig, [line], [(label, "@y{0.000} J"), ("time", "@x{0.000} s")])
        entries.append((label, [line]))
    add_legend(fig, entries)
    return fig


def energy_terms(scene: RunData) -> list[tuple[str, str]]:
    """Return name and short label of the ledger's terms in the dataset."""
    names = [str(name) for name in scene.dataset if str(name).startswith("energy_")]
    return [(name, name.removeprefix("energy_").replace("_", " ")) for name in names]


def settled(scene: RunData, name: str) -> Floats:
    """Return a term of the ledger in the rows at which it was settled."""
    values: Floats = scene.values(name)
    return values[np.isfinite(values)]


def _view(scene: RunData, title: str, axis: str, y_label: str, height: int) -> Figure | None:
    if not scene.has(f"contact_wire_node_{axis}", "contact_wire_node_x"):
        return None
    fig = figure(title, X_LABEL, y_label, height=height, x_range=scene.track)
    entries = []
    for wire, label, shade in WIRES:
        if not scene.has(f"{wire}_node_x", f"{wire}_node_{axis}"):
            continue
        x, values = wire_points(scene, wire, axis, NODE_POINTS)
        points = {"x": single(x), "y": single(values)}
        drawn = fig.draw("Line", points, color=colour(shade), line_width=1.5)
        add_hover(fig, [drawn], [(label, "@y{0.000} m"), ("position", "@x{0.0} m")])
        entries.append((label, [drawn]))
    supports = scene.values("support_x")
    if supports.size:
        places = single(supports[every(supports.size, MARKS)])
        lines = fig.draw("VSpan", {"x": places}, color=LIGHT, line_dash="dashed")
        entries.append(("support", [lines]))
    add_legend(fig, entries)
    return fig
