"""The line at rest from the side and from above.

Drawn is what the mesh holds: every wire element by the name of its wire, every dropper between its
two nodes, every bar to its anchor. No type of line has a drawing of its own.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.figures.description import Axis, Curve, Figure, Layer, Points, Segments, Texts, Tip
from arcless.figures.description.tokens import of_series, tokens
from arcless.figures.statics.line_data import ACROSS, ALONG, UP, Floats, LineData
from arcless.mesh import PLANAR

SIDE, PLAN = 340, 250
# Part of the range of heights, and of the largest lateral position, that is left free around them.
MARGIN, BESIDE_WIRES = 0.08, 0.25
# Smallest range of heights that fills the figure, and the one below which the axis has mm. In m.
LEAST, FINE = 0.02, 0.4
# Lines of more spans have their numbers alone, which do not cover one another.
NAMED_SPANS = 20
# Names of wires, where they are not those of the fields of a line.
NAMES = {"stitch_wire": "stitch wires", "bridle": "bridles"}


def side_view(line: LineData) -> list[Figure]:
    """Return the line from the side; heights are drawn larger than lengths."""
    heights = line.points[line.inside(line.points[:, ALONG]), UP]
    low, high = float(heights.min()), float(heights.max())
    margin = MARGIN * max(high - low, LEAST)
    top = high + 2.0 * margin
    form = "0.0" if high - low > FINE else "0.000"
    y = Axis("height above rail", "m", low - margin, top, form=form)
    sag = 1e3 * line.found.contact_wire_sag_m
    count = len(line.found.droppers)
    layers = [*_layers(line, UP), *_span_numbers(line, top)]
    return [
        line.along(
            "side-view", "Line at rest, side view", y, layers, height=SIDE,
            alt=f"Line at rest from the side: wires between {low:.2f} and {high:.2f} m above rail,"
            f" {count} droppers; the height of the contact wire varies by {sag:.1f} mm in span"
            f" {line.found.middle_span}. Heights are drawn larger than lengths.",
        )
    ]  # fmt: skip


def plan_view(line: LineData) -> list[Figure]:
    """Return the line from above; none of a line without stagger."""
    if not np.ptp(line.points[:, ACROSS]) > 0.0:
        return []
    wires = line.points[np.unique(line.mesh.elements["nodes"])]
    lateral = float(np.abs(wires[line.inside(wires[:, ALONG]), ACROSS]).max())
    edge = (1.0 + BESIDE_WIRES) * max(lateral, 0.05)
    y = Axis("across the track", "m", -edge, edge, form="0.00")
    return [
        line.along(
            "plan-view", "Line at rest, from above", y, [*_layers(line, ACROSS), _staggers(line)],
            height=PLAN,
            caption="Steady arms continue beyond the figure; move it to see their ends.",
            alt=f"Line at rest from above: wires up to {lateral:.3f} m from the middle of the"
            " track.",
        )
    ]  # fmt: skip


def _layers(line: LineData, axis: int) -> list[Layer]:
    return [*_droppers(line, axis), *_bars(line, axis), *_wires(line, axis)]


def _wires(line: LineData, axis: int) -> Iterator[Layer]:
    """Yield the wires, the contact wire last; elements that do not meet leave a gap."""
    ends = line.mesh.elements["nodes"]
    by_name = list(enumerate(line.mesh.wire_rows.items()))
    for index, (field, rows) in sorted(by_name, key=lambda one: one[1][0] == "contact_wire"):
        x, y = _chained(ends[rows], line, axis)
        if x.size == 0:
            continue
        name = NAMES.get(field, field.replace("_", " "))
        known = field in tokens()["light"]
        word = "height" if axis == UP else "lateral position"
        yield Curve(
            x, y, colour=field if known else of_series(index), name=name,
            width=2.0 if field == "contact_wire" else 1.4,
            tips=(Tip(f"{name}, {word}", "y", "m", "0.000"), Tip("position", "x", "m")),
        )  # fmt: skip


def _droppers(line: LineData, axis: int) -> Iterator[Layer]:
    """Yield the droppers, each between the two nodes that it joins."""
    pairs = zip(line.mesh.droppers, line.found.droppers, strict=True)
    kept = [pair for pair in pairs if line.begin <= pair[0].x <= line.end]
    if not kept:
        return
    places, chosen = zip(*kept, strict=True)
    top, foot = (line.points[[place.nodes[end] for place in places]] for end in (0, 1))
    tips = (
        Tip("", [one["name"] for one in chosen], form=""),
        Tip("length between clamps", [one["length_m"] for one in chosen], "m", "0.000"),
        Tip("force", [one["force_N"] for one in chosen], "N"),
    )
    yield Segments(**_between(top, foot, axis), colour="dropper", name="dropper", tips=tips)


def _bars(line: LineData, axis: int) -> Iterator[Layer]:
    """Yield the bars that hold a wire sideways, from the wire to their anchor."""
    nodes = line.mesh.parts["struts"]["node"]
    if len(nodes) == 0:
        return
    anchors = line.found.equilibrium.arrays["strut_anchor"].reshape(len(nodes), -1)
    if anchors.shape[1] == PLANAR:  # along and up
        anchors = np.column_stack([anchors[:, 0], np.zeros(len(nodes)), anchors[:, 1]])
    held = line.points[nodes]
    kept = line.inside(held[:, ALONG])
    ends = _between(held[kept], anchors[kept], axis)
    yield Segments(**ends, colour="arm", name="steady arm", width=2.0)


def _staggers(line: LineData) -> Layer:
    """Return marks of the contact wire at the supports."""
    places = [place for place in line.mesh.supports if line.begin <= place.x <= line.end]
    points = line.points[[place.contact_node for place in places]]
    tips = (
        Tip("", [place.name for place in places], form=""),
        Tip("stagger", "y", "m", "0.000"),
        Tip("position", "x", "m"),
    )
    return Points(
        points[:, ALONG], points[:, ACROSS], colour="contact_wire", name="stagger", tips=tips
    )


def _span_numbers(line: LineData, top: float) -> list[Layer]:
    if not line.spans:
        return []
    word = "span " if len(line.spans) <= NAMED_SPANS else ""
    middles = np.array([0.5 * (left + right) for _, left, right in line.spans])
    texts = [f"{word}{number}" for number, _, _ in line.spans]
    return [Texts(middles, np.full(len(texts), top), texts, colour="soft", baseline="top")]


def _between(one: Floats, other: Floats, axis: int) -> dict[str, Any]:
    """Return the ends of straight pieces."""
    return {
        "x0": one[:, ALONG], "y0": one[:, axis], "x1": other[:, ALONG], "y1": other[:, axis],
    }  # fmt: skip


def _chained(ends: NDArray[np.int64], line: LineData, axis: int) -> tuple[Floats, Floats]:
    """Return elements as one line: where an element does not begin at the last one's end, a gap."""
    ends = ends[line.inside(line.points[ends].mean(axis=1)[:, ALONG])]
    if len(ends) == 0:
        return np.empty(0), np.empty(0)
    breaks = np.flatnonzero(ends[1:, 0] != ends[:-1, 1]) + 1
    x, y = [], []
    for piece in np.split(ends, breaks):
        nodes = np.append(piece[:, 0], piece[-1, 1])
        x.append(np.append(line.points[nodes, ALONG], np.nan))
        y.append(np.append(line.points[nodes, axis], np.nan))
    return np.concatenate(x), np.concatenate(y)
