"""Figures of the line itself: its shape at rest and its elasticity."""

from collections.abc import Sequence

import numpy as np

from arcless.figures.description import Axis, Curve, Figure, Layer, Segments, Tip
from arcless.figures.description.thinning import envelope, every
from arcless.figures.run.run_data import RunData
from arcless.figures.run.track import LABEL, MARKS, axis, supports
from arcless.figures.wires.wire_points import wire_points

NODE_POINTS = 1500
SIDE, PLAN = 280, 220

# Name in the dataset, label; the token of its colour is the former.
WIRES = (
    ("contact_wire", "contact wire"),
    ("messenger_wire", "messenger wire"),
    ("auxiliary_wire", "auxiliary wire"),
    ("stitch_wire", "stitch wires"),
    ("bridle", "bridles"),
)


def side_view(run: RunData) -> list[Figure]:
    """Return the line at rest from the side; heights are drawn larger than lengths."""
    layers: list[Layer] = []
    if run.has("dropper_x", "dropper_top_z", "dropper_bottom_z"):
        kept = every(run.values("dropper_x").size, MARKS)
        x, top, foot = (
            run.values(name)[kept] for name in ("dropper_x", "dropper_top_z", "dropper_bottom_z")
        )
        layers.append(Segments(x, top, x, foot, colour="dropper", name="dropper"))
    y = Axis("height above rail", "m", form="0.0")
    return _view(run, "side-view", "side view", y, "z", more=layers, height=SIDE)


def plan_view(run: RunData) -> list[Figure]:
    """Return the line at rest from above when it is not straight."""
    sides = [run.values(f"{wire}_node_y") for wire, _ in WIRES]
    if not any(side.size and np.ptp(side) > 0.0 for side in sides):
        return []
    y = Axis("across the track", "m", form="0.0")
    return _view(run, "plan-view", "from above", y, "y", more=[], height=PLAN)


def elasticity(run: RunData) -> list[Figure]:
    """Return the static elasticity of the contact wire."""
    if not run.has("elasticity"):
        return []
    values = 1e3 * run.values("elasticity")
    kept = envelope(values, NODE_POINTS)
    total = float(values.max() + values.min())
    uneven = f"non-uniformity {100.0 * np.ptp(values) / total:.0f} %" if total > 0.0 else ""
    curve = Curve(
        run.values("elasticity_x")[kept], values[kept], colour="contact_wire", width=1.8,
        tips=(Tip("elasticity", "y", "mm/N", "0.000"), Tip("position", "x", "m")),
    )  # fmt: skip
    title = "Elasticity of the contact wire at rest"
    return [
        Figure(
            "elasticity", f"{title}, {uneven}" if uneven else title, Axis(LABEL, "m"),
            Axis("elasticity", "mm/N", 0.0, 1.1 * float(values.max())), [curve],
            caption="In the middle span of the line, for a small force.",
            alt=f"Elasticity of the contact wire from {values.min():.3f} to {values.max():.3f}"
            f" mm/N. {uneven}",
        )
    ]  # fmt: skip


def _view(
    run: RunData, key: str, view: str, y: Axis, across: str, *, more: Sequence[Layer], height: int
) -> list[Figure]:
    """Return a view of the line: heights, or distances across, of the nodes of the wires."""
    if not run.has(f"contact_wire_node_{across}", "contact_wire_node_x"):
        return []
    wires: list[Layer] = []
    for wire, label in WIRES:
        if not run.has(f"{wire}_node_x", f"{wire}_node_{across}"):
            continue
        x, values = wire_points(run, wire, across, NODE_POINTS)
        tips = (Tip(label, "y", "m", "0.000"), Tip("position", "x", "m"))
        width = 2.0 if wire == "contact_wire" else 1.3
        wires.append(Curve(x, values, colour=wire, name=label, width=width, tips=tips))
    wires.reverse()  # the contact wire lies on top
    layers, title = [*supports(run), *more, *wires], f"Line at rest, {view}"
    return [Figure(key, title, axis(run), y, layers, height=height, alt=f"{title}.")]
