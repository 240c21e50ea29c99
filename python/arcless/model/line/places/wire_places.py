"""Places on the wires of a line at which something is attached, before any mesh is made."""

from collections.abc import Sequence
from itertools import pairwise

from arcless.model.line.line import Line
from arcless.model.line.parts.spans import SpanType

# Nearer to one another two places are one, in m.
SAME_PLACE = 1e-3

# Anchors of a wire at the left and at the right end of a span.
Ends = tuple[bool, bool]


def shortest_distances(line: Line) -> dict[str, list[float]]:
    """Return distances in m between neighbouring places by wire, for those where they are short.

    Places of droppers, hangers, supports and clamps in each type of span. Masses and inserts on
    wires cut spans where they stand: distances to their neighbours are among them.
    """
    own: dict[str, set[float]] = {name: set() for name, _ in line.wires()}
    extra = _on_wires(line)
    starts, spans = line.support_positions(), line.span_list()
    anchored = _anchored(line)
    # Equal spans have equal places: a long line is made of few types.
    kinds = {(id(span), ends): span for index, span in enumerate(spans) for ends in anchored[index]}
    for (_, ends), span in kinds.items():
        for name, places in _along_span(line, span, ends).items():
            own[name] |= _gaps(places)
    for index, span in enumerate(spans if extra else []):
        left, right = starts[index], starts[index + 1]
        inside = [(wire, x - left) for wire, x in extra if left - 1 < x < right + 1]
        for ends in anchored[index] if inside else ():
            for name, places in _along_span(line, span, ends).items():
                more = [x for wire, x in inside if wire == name]
                own[name] |= _gaps([*places, *more])
    pairs = {(id(one), id(other)): (one, other) for one, other in pairwise(spans)}
    for one, other in pairs.values():
        for name, places in _across_support(line, one, other).items():
            own[name] |= _gaps(places)
    return {name: sorted(gaps) for name, gaps in own.items()}


def _anchored(line: Line) -> list[set[Ends]]:
    """Return by span at which of its ends wires are anchored; several where wires overlap."""
    found: list[set[Ends]] = [set() for _ in line.span_list()]
    for one in line.tension_length_list():
        for number in range(one.from_span, one.to_span + 1):
            found[number - 1].add((number == one.from_span, number == one.to_span))
    return found


def _along_span(line: Line, span: SpanType, anchored: Ends) -> dict[str, list[float]]:
    """Return the places in a span, from its left support, on wires from support to support.

    At an anchor there is neither stitch wire nor bridle.
    """
    ends = [0.0, span.length]
    droppers, lower = span.droppers.positions, span.holders.positions
    places = {"contact_wire": [*ends, *lower]}
    if line.messenger_wire is not None:
        places["messenger_wire"] = [*ends, *droppers]
    if line.auxiliary_wire is not None:
        places["auxiliary_wire"] = [*ends, *lower, *droppers]
    if line.stitch_wire is not None:
        clamps = _clamps(line.stitch_wire.length, span, anchored)
        between = [x for x in droppers if clamps[0] <= x <= clamps[1]]
        places["messenger_wire"] = [*ends, *clamps, *between]
    if line.bridle is not None:
        places["contact_wire"] += _clamps(line.bridle.length, span, anchored)
    return places


def _clamps(length: float, span: SpanType, anchored: Ends) -> tuple[float, float]:
    """Return the ends in a span of stitch wires or bridles of a length; an anchor is its own."""
    left, right = (0.0 if anchor else 0.5 * length for anchor in anchored)
    return left, span.length - right


def _across_support(line: Line, before: SpanType, behind: SpanType) -> dict[str, list[float]]:
    """Return the places on a stitch wire and on a bridle, from the support between two spans."""
    places = {}
    if line.stitch_wire is not None:
        half = 0.5 * line.stitch_wire.length
        hung = [x - before.length for x in before.droppers.positions]
        hung = [x for x in (*hung, *behind.droppers.positions) if abs(x) < half]
        places["stitch_wire"] = [-half, *hung, half]
    if line.bridle is not None:
        half = 0.5 * line.bridle.length
        places["bridle"] = [-half, 0.0, half]
    return places


def _on_wires(line: Line) -> list[tuple[str, float]]:
    masses = [(mass.wire, mass.position) for mass in line.point_masses]
    inserts = [(insert.wire, x) for insert in line.inserts for x in insert.ends]
    return [*masses, *inserts]


def _gaps(places: Sequence[float]) -> set[float]:
    """Return the distances in m between neighbouring places."""
    gaps = [right - left for left, right in pairwise(sorted(places))]
    return {round(gap, 6) for gap in gaps if gap > SAME_PLACE}
