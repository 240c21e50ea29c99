"""Figures of the collector head: where the contact wire lies on it, and where that wears it."""

import numpy as np

from arcless.figures.description import Axis, Bars, Curve, Figure, Layer, Rules, Tip
from arcless.figures.description.tokens import of_pantograph, of_series
from arcless.figures.run.run_data import Floats, RunData
from arcless.figures.run.track import along, filtered, titled

# Width of the parts of a head, and the least range that is drawn, in mm.
PART, LEAST = 20.0, 100.0


def lateral(run: RunData) -> list[Figure]:
    """Return the lateral position of the wires on each head along the track."""
    found = []
    for i, name in enumerate(run.pantographs):
        wires = _wires(run, i)
        if not wires:
            return []
        reach = _reach(run, i, [y for _, y, _ in wires])
        layers: list[Layer] = list(_limits(run, i, "y"))
        for place, (title, y, _) in reversed([*enumerate(wires)]):  # a legend begins at the top
            colour = of_pantograph(i) if len(wires) == 1 else of_series(place)
            layers.append(filtered(run, i, y, "lateral position mm 0", name=title, colour=colour))
        largest = max(float(np.nanmax(np.abs(y), initial=0.0)) for _, y, _ in wires)
        found.append(
            along(
                run, f"lateral-{i + 1}",
                titled(run, "Lateral position of the contact wire on the collector head", i),
                Axis("lateral position", "mm", -reach, reach), layers,
                alt=f"Lateral position of the contact wire on the head of {name}, at most"
                f" {largest:.0f} mm from the middle.",
            )
        )  # fmt: skip
    return found


def wear_pattern(run: RunData) -> list[Figure]:
    """Return the share of friction and of distance over the width of each head.

    Work of friction per part of the head, dW = μ F ds: with one coefficient of friction its share
    is that of ∫F ds, of the unfiltered force.
    """
    found = []
    for i, name in enumerate(run.pantographs):
        wires = _wires(run, i)
        if not wires:
            return []
        reach = PART * np.ceil(_reach(run, i, [y for _, y, _ in wires]) / PART)
        edges = np.arange(-reach, reach + 0.5 * PART, PART)
        inside = run.record.inside[:, i]
        step = np.gradient(run.position[:, i])
        distance, work = np.zeros(edges.size - 1), np.zeros(edges.size - 1)
        for _, y, force in wires:
            known = inside & np.isfinite(y)
            distance += np.histogram(y[known], edges, weights=step[known])[0]
            work += np.histogram(y[known], edges, weights=(step * force)[known])[0]
        distance, work = (_percent(values) for values in (distance, work))
        stairs_x = np.repeat(edges, 2)[1:-1]
        tips = (Tip("from", edges[:-1], "mm", "0"), Tip("to", edges[1:], "mm", "0"),
                Tip("share of the friction work", work, "%"),
                Tip("share of the distance", distance, "%"))  # fmt: skip
        layers: list[Layer] = [
            *_limits(run, i, "x"),
            Bars(edges[:-1], edges[1:], np.zeros_like(work), work, colour=of_pantograph(i),
                 alpha=0.7, name="share of the friction work", tips=tips),
            Curve(stairs_x, np.repeat(distance, 2), colour="ink", width=1.2, dash="dashed",
                  name="share of the distance"),
        ]  # fmt: skip
        top = 1.1 * max(float(work.max()), float(distance.max()), 1e-9)
        most = int(work.argmax())
        found.append(
            Figure(
                f"wear-pattern-{i + 1}", titled(run, "Wear pattern of the contact strip", i),
                Axis("lateral position on the head", "mm", -reach, reach),
                Axis(f"share per {PART:g} mm", "%", 0.0, top), layers,
                caption="Friction work, force times distance, shows where the strip wears by"
                " friction. In the analysis section.",
                alt=f"Share of the friction work over the width of the head of {name}, largest"
                f" between {edges[most]:.0f} and {edges[most + 1]:.0f} mm.",
            )
        )  # fmt: skip
    return found


def _wires(run: RunData, pantograph: int) -> list[tuple[str, Floats, Floats]]:
    """Return name, lateral position in mm, and unfiltered force in N of each wire on a head."""
    if run.assessment.pantographs[pantograph].max_lateral_position_mm is None:  # planar
        return []
    if run.has("wire_contact_lateral", "wire_contact_force"):
        prefix = f"{run.pantographs[pantograph]} strip "
        names = [str(name) for name in run.values("contact")]
        lateral_mm, force = (
            1e3 * run.values("wire_contact_lateral"),
            run.values("wire_contact_force"),
        )
        return [
            (name.removeprefix(f"{run.pantographs[pantograph]} "), lateral_mm[:, k], force[:, k])
            for k, name in enumerate(names)
            if name.startswith(prefix) and np.isfinite(lateral_mm[:, k]).any()
        ]
    if not run.has("contact_lateral"):
        return []
    lateral_mm = 1e3 * run.values("contact_lateral")[:, pantograph]
    if not np.isfinite(lateral_mm).any():
        return []
    return [("contact wire", lateral_mm, run.record.force[:, pantograph])]


def _reach(run: RunData, pantograph: int, wires: list[Floats]) -> float:
    """Return the half-width that is drawn, in mm: of the wires and of the limit."""
    limit = run.limit("lateral_position", pantograph) or 0.0
    return 1.1 * max(LEAST, limit, *(float(np.nanmax(np.abs(y), initial=0.0)) for y in wires))


def _limits(run: RunData, pantograph: int, axis: str) -> list[Layer]:
    limit = run.limit("lateral_position", pantograph)
    if limit is None:
        return []
    name = f"limit of the lateral position: ±{limit:g} mm"
    at = np.array([-limit, limit])
    return [Rules(axis="x" if axis == "x" else "y", at=at, colour="limit", dash="dashed",
                  width=1.6, name=name)]  # fmt: skip


def _percent(values: Floats) -> Floats:
    return 100.0 * values / max(float(values.sum()), 1e-12)
