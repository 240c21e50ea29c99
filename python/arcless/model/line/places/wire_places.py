"""Places on the wires of a line at which something is attached, before any mesh is made."""

from collections.abc import Sequence
from itertools import pairwise

from arcless.model.line.line import Line
from arcless.model.line.parts.spans import SpanType

# Nearer to one another two places are one, in m.
SAME_PLACE = 1e-3


def shortest_distances(line: Line) -> dict[str, list[float]]:
    """Return distances in m between neighbouring places by wire, for those where they are short.

    Places of droppers, hangers, supports and clamps in each type of span. Masses and inserts on
    wires cut spans where they stand: distances to their neighbours are among them.
    """
    own: dict[str, set[float]] = {
        name: set()
        for name in ("contact_wire", "messenger_wire", "auxiliary_wire", "stitch_wire", "bridle")
    }
    for span in line.span_types.values():
        for name, places in _places(line, span).items():
            own[name] |= set(_gaps(places))
    extra = _on_wires(line)
    starts = line.support_positions()
    for index, span in enumerate(line.span_list() if extra else []):
        left, right = starts[index], starts[index + 1]
        inside = [(wire, x - left) for wire, x in extra if left - 1 < x < right + 1]
        for name, places in _places(line, span).items() if inside else ():
            more = [x for wire, x in inside if wire == name]
            own[name] |= set(_gaps([*places, *more]))
    return {name: sorted(gaps) for name, gaps in own.items()}


def _places(line: Line, span: SpanType) -> dict[str, list[float]]:
    """Return the places in a span, from its left support, by wire."""
    ends = [0.0, span.length]
    clamps: list[float] = []
    if line.stitch_wire is not None:
        half = 0.5 * line.stitch_wire.length
        clamps = [half, span.length - half]
    droppers, lower = span.droppers.positions, span.holders.positions
    bridled: list[float] = []
    if line.bridle is not None:
        half = 0.5 * line.bridle.length
        bridled = [half, span.length - half]
    near = [x for x in droppers if clamps and (x < clamps[0] or x > clamps[1])]
    mirrored = [span.length - x for x in near if x > 0.5 * span.length]
    return {
        "contact_wire": [*ends, *lower, *bridled],
        "messenger_wire": [*ends, *droppers, *clamps],
        "auxiliary_wire": [*ends, *lower, *droppers],
        "stitch_wire": [0.0, *(x for x in near if x < 0.5 * span.length), *mirrored, *clamps[:1]],
        "bridle": [0.0, *bridled[:1]],
    }


def _on_wires(line: Line) -> list[tuple[str, float]]:
    masses = [(mass.wire, mass.position) for mass in line.point_masses]
    inserts = [(insert.wire, x) for insert in line.inserts for x in insert.ends]
    return [*masses, *inserts]


def _gaps(places: Sequence[float]) -> list[float]:
    ordered = sorted(places)
    gaps = [right - left for left, right in pairwise(ordered)]
    return [round(gap, 6) for gap in gaps if gap > SAME_PLACE]
