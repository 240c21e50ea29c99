"""Figures of a line at rest without a run: its shape, its elasticity, the forces in it."""

from collections.abc import Callable, Mapping

from arcless.figures.description import Figure
from arcless.figures.statics import elasticity, forces, views
from arcless.figures.statics.line_data import LineData

# Key → figures; those that a line has no parts for are none.
FIGURES: Mapping[str, Callable[[LineData], list[Figure]]] = {
    "side_view": views.side_view,
    "plan_view": views.plan_view,
    "elasticity": elasticity.along_track,
    "elasticity_by_span": elasticity.by_span,
    "dropper_forces": forces.dropper_forces,
    "support_forces": forces.support_forces,
    "steady_arm_forces": forces.steady_arm_forces,
}


def figures(line: LineData) -> dict[str, list[Figure]]:
    """Return all figures of a line at rest by their keys; see `FIGURES`."""
    return {key: make(line) for key, make in FIGURES.items()}


__all__ = ["FIGURES", "LineData", "figures"]
