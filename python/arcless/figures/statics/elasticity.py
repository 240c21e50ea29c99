"""Elasticity of the contact wire at rest: along the track, and by span."""

import numpy as np

from arcless.figures.description import Axis, Curve, Figure, Layer, Points, Segments, Strip, Tip
from arcless.figures.statics.line_data import AT_SUPPORT, Floats, LineData

LABEL = "elasticity"
# Of the range, what is left free above the highest value.
HEADROOM = 1.1


def along_track(line: LineData) -> list[Figure]:
    """Return the elasticity of all spans over the position."""
    x, values = line.elasticity
    values = 1e3 * values
    curve = Curve(
        x, values, colour="contact_wire", width=1.8, name=LABEL,
        tips=(Tip(LABEL, "y", "mm/N", "0.000"), Tip("position", "x", "m")),
    )  # fmt: skip
    left, right = line.found.equilibrium.middle_span()
    number = line.found.middle_span
    middle = Strip(
        axis="x", low=left, high=right, colour="section", alpha=0.06, name=f"span {number}"
    )
    uneven = f"non-uniformity {100 * line.found.elasticity_nonuniformity:.1f} % in span {number}"
    return [
        line.along(
            "elasticity", f"Elasticity of the contact wire at rest, {uneven}",
            Axis(LABEL, "mm/N", 0.0, HEADROOM * float(values.max())), [middle, curve],
            alt=f"Elasticity of the contact wire along the track, from {values.min():.3f} to"
            f" {values.max():.3f} mm/N; {uneven}.",
        )
    ]  # fmt: skip


def by_span(line: LineData) -> list[Figure]:
    """Return the range of the elasticity in each span; of overlaps the spans are marked.

    Of the first and last span the inner half counts: at the end of the line the wire is anchored.
    """
    numbers = np.array([number for number, _, _ in line.spans], dtype=float)
    low, high = 1e3 * _ranges(line)
    uneven = 100 * (high - low) / (high + low)
    tips = (
        Tip("span", [f"{number:.0f}" for number in numbers], form=""),
        Tip("lowest", low, "mm/N", "0.000"), Tip("highest", high, "mm/N", "0.000"),
        Tip("non-uniformity", uneven, "%"),
    )  # fmt: skip
    layers: list[Layer] = [
        Strip(axis="x", low=number - 0.5, high=number + 0.5, colour="pantograph_2", alpha=0.08,
              name="overlap") for number in line.overlaps
    ]  # fmt: skip
    layers += [
        Segments(numbers, low, numbers, high, colour="contact_wire", width=3.0, alpha=0.45,
                 name="lowest to highest"),
        Points(numbers, high, colour="contact_wire", size=7.0, name="highest", tips=tips),
        Points(numbers, low, colour="rest", size=7.0, name="lowest", tips=tips),
    ]  # fmt: skip
    most = int(np.argmax(uneven))
    return [
        Figure(
            "elasticity-by-span", "Elasticity by span",
            Axis("span", "", numbers[0] - 0.6, numbers[-1] + 0.6, form="0"),
            Axis(LABEL, "mm/N", 0.0, HEADROOM * float(high.max())), layers,
            alt=f"Range of the elasticity in {len(numbers)} spans, from {low.min():.3f} to"
            f" {high.max():.3f} mm/N; the non-uniformity is largest in span {numbers[most]:.0f}:"
            f" {uneven[most]:.1f} %.",
        )
    ]  # fmt: skip


def _ranges(line: LineData) -> Floats:
    """Return the lowest and highest elasticity of each span in m/N, without the line's ends."""
    x, values = line.elasticity
    found = []
    for _, left, right in line.spans:
        begin = 0.5 * (left + right) if left <= line.supports[0] + AT_SUPPORT else left
        end = 0.5 * (left + right) if right >= line.supports[-1] - AT_SUPPORT else right
        inside = values[(x >= begin - AT_SUPPORT) & (x <= end + AT_SUPPORT)]
        found.append((inside.min(), inside.max()))
    return np.array(found).T
