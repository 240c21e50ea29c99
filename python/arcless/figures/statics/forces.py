"""Forces in the line at rest: droppers, supports, steady arms."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arcless.figures.description import Axis, Figure, Layer, Points, Segments, Tip
from arcless.figures.description.tokens import of_series
from arcless.figures.statics.line_data import LineData

Rows = Sequence[dict[str, Any]]
LOW = 210


@dataclass(frozen=True)
class Forces:
    """Forces of one figure.

    Attributes
    ----------
    key, title, label
        Of the figure, and of its axis.
    rows
        Parts of the line, each with ``name`` and ``x_m``.
    of
        Key of the force in N in a row.
    """

    key: str
    title: str
    label: str
    rows: Rows
    of: str


def dropper_forces(line: LineData) -> list[Figure]:
    """Return the force of every dropper; none of a line without droppers."""
    rows = [one for one in line.found.droppers if line.begin <= one["x_m"] <= line.end]
    if not rows:
        return []
    wires = list(dict.fromkeys((one["from"], one["to"]) for one in rows))
    layers: list[Layer] = []
    for index, pair in reversed([*enumerate(wires)]):  # a legend begins at the top
        own = [one for one in rows if (one["from"], one["to"]) == pair]
        name = "dropper" if len(wires) == 1 else f"{pair[0]} to {pair[1]}"
        tips = (_texts(own), _numbers("length between clamps", own, "length_m", "m", "0.000"))
        colour = "dropper" if len(wires) == 1 else of_series(index)
        layers += _stems(own, "force_N", colour, name, *tips)
    found = Forces("dropper-forces", "Dropper forces at rest", "dropper force", rows, "force_N")
    return [_figure(line, found, layers)]


def support_forces(line: LineData) -> list[Figure]:
    """Return the vertical force on every support: of the messenger wire, or of the rail itself."""
    found = line.found.supports
    key = next((name for name in HELD if name in found[0]), "")
    rows = _known(line, found, key)
    if not rows:
        return []
    layers = _stems(rows, key, "messenger_wire", "vertical force", _texts(rows))
    title = f"Vertical force of the {HELD[key]} on supports at rest"
    return [_figure(line, Forces("support-forces", title, "vertical force", rows, key), layers)]


def steady_arm_forces(line: LineData) -> list[Figure]:
    """Return the force in every steady arm, tension positive; none of a line without arms."""
    rows = _known(line, line.found.supports, ARM)
    if not rows:
        return []
    layers = _stems(rows, ARM, "arm", "steady arm", _texts(rows))
    title = "Steady-arm forces at rest, tension positive"
    return [_figure(line, Forces("steady-arm-forces", title, "force", rows, ARM), layers)]


HELD = {"messenger_force_N": "messenger wire", "contact_support_force_N": "contact wire"}
ARM = "steady_arm_force_N"


def _known(line: LineData, found: Rows, key: str) -> Rows:
    return [
        one for one in found if one.get(key) is not None and line.begin <= one["x_m"] <= line.end
    ]


def _stems(rows: Rows, key: str, colour: str, name: str, *tips: Tip) -> list[Layer]:
    x, values = (np.array([one[of] for one in rows]) for of in ("x_m", key))
    shown = (*tips, Tip("force", "y", "N"), Tip("position", "x", "m"))
    return [
        Segments(x, np.zeros_like(x), x, values, colour=colour, width=2.5, alpha=0.5, name=name),
        Points(x, values, colour=colour, size=6.0, name=name, tips=shown),
    ]


def _texts(rows: Rows) -> Tip:
    return Tip("", [one["name"] for one in rows], form="")


def _numbers(label: str, rows: Rows, key: str, unit: str, form: str) -> Tip:
    return Tip(label, [one[key] for one in rows], unit, form)


def _figure(line: LineData, found: Forces, layers: Sequence[Layer]) -> Figure:
    values = np.array([one[found.of] for one in found.rows])
    low, high = min(0.0, float(values.min())), max(0.0, float(values.max()))
    margin = 0.08 * (high - low) or 1.0
    y = Axis(found.label, "N", low - margin if low < 0.0 else 0.0, high + margin)
    largest = found.rows[int(np.abs(values).argmax())]
    return line.along(
        found.key, found.title, y, layers, height=LOW,
        alt=f"{found.title}: {len(values)} values from {values.min():.1f} to {values.max():.1f} N;"
        f" the largest is at {largest['name']}, {largest['x_m']:.1f} m.",
    )  # fmt: skip
