"""Whether curves and staggers of a line go together."""

from itertools import pairwise
from math import sqrt
from typing import TYPE_CHECKING, NamedTuple

from arcless.errors import ModelError
from arcless.model.pantograph.pantograph import LATERAL_LIMITS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from arcless.model.line.line import Line
    from arcless.model.pantograph.placement import PantographPlacement

# Spans that are equal but for rounding: the first one is named. In m.
ROUNDING = 1e-9
# No collector in service is wider than 1.95 m, with 0.975 m to either side. In m.
WIDEST = 1.0
# Lateral deviation allowed for a head of 1.60 m and for one of 1.95 m. In m.
ALLOWED = tuple(LATERAL_LIMITS.values())
# Offsets of a straight wire from the line between its supports: at both ends. In m.
STRAIGHT = (0.0, 0.0)


class Aside(NamedTuple):
    """Where the contact wire of a line is farthest from the pantograph's axis."""

    distance: float
    span: int
    x: float
    curve_part: float


def farthest(line: "Line") -> Aside:
    """Return where the contact wire at rest lies farthest aside."""
    supports, pattern = line.support_positions(), line.geometry.stagger_contact_wire
    height, worst = line.geometry.contact_wire_height, None
    for index, (left, right) in enumerate(pairwise(supports)):
        bends = line.track.bends(left, right)
        offsets = line.track.offsets(left, right, height) if bends else STRAIGHT
        first, last = (pattern[k % len(pattern)] for k in (index, index + 1))
        for place, offset in enumerate(offsets):
            share = place / (len(offsets) - 1)
            y = first + share * (last - first) + offset
            if worst is None or abs(y) > abs(worst.distance) + ROUNDING:
                worst = Aside(y, index + 1, left + share * (right - left), offset)
    assert worst is not None  # a line has spans
    return worst


def check_track(line: "Line") -> None:
    """Raise `ModelError` for a curve in which the wire cannot be held over the track."""
    if not line.track.curves:
        return
    if not line.holds_stagger:
        raise ModelError(
            "nothing holds the contact wire in a curve",
            got="a steady arm of kind none",
            expected="a steady arm of kind spring or arm, or a straight track",
            hint="for instance steady_arm: {kind: spring, vertical_stiffness: 250 N/m}",
            field=("track", "curves"),
        )
    worst = farthest(line)
    if abs(worst.distance) > WIDEST:
        raise ModelError(
            "a curve tighter than the stagger allows",
            got=f"the contact wire {abs(worst.distance):.3g} m aside at {worst.x:.4g} m, in span"
            f" {worst.span}, {abs(worst.curve_part):.3g} m of it by the curve",
            expected=f"at most {WIDEST:g} m: no collector reaches farther",
            hint=_shorter(line, worst),
            field=("track", "curves"),
        )


def _shorter(line: "Line", worst: Aside) -> str:
    """Say how long spans may be: the part of the curve goes with the square of their length."""
    by_stagger = abs(worst.distance) - abs(worst.curve_part)
    room, length = WIDEST - by_stagger, line.span_list()[worst.span - 1].length
    spans = "shorter spans"
    if 0 < room < abs(worst.curve_part):
        spans += f" there, of at most {int(length * sqrt(room / abs(worst.curve_part)))} m"
    return f"{spans}, or more stagger to the outside of the curve; is the radius as meant?"


def deviation_warnings(line: "Line", placements: "Sequence[PantographPlacement]" = ()) -> list[str]:
    """Return a sentence when the wire at rest lies farther aside than heads allow.

    Parameters
    ----------
    line
        The line; wind and uplift are not in this, the assessment of a run has them.
    placements
        Pantographs that run below it; those that say how wide their heads are count, each with its
        sway. Without any such, narrow heads count.
    """
    worst = farthest(line)
    twin = line.twin_contact_wires
    aside = abs(worst.distance) + (0.0 if twin is None else 0.5 * twin.separation)
    place = f"at {worst.x:.4g} m, in span {worst.span}"
    where = f"the contact wire at rest lies {aside:.3g} m aside {place}"
    field = "line.track.curves" if worst.curve_part else "line.geometry.stagger_contact_wire"
    known = [(each, each.model.lateral_limit) for each in placements]
    told = []
    for placement, limit in known:
        if limit is None or aside + placement.sway <= limit + ROUNDING:
            continue
        sway = f" and the head sways by {placement.sway:.3g} m" if placement.sway else ""
        name = placement.name or placement.model.name
        told.append(f"{field}: {where}{sway}; the head of pantograph {name} allows {limit:.3g} m")
    if any(limit is not None for _, limit in known) or aside <= ALLOWED[0] + ROUNDING:
        return told
    heads = "0.40 m are allowed for a head of 1.60 m"
    if aside > ALLOWED[1] + ROUNDING:
        heads += ", 0.55 m for one of 1.95 m"
    return [f"{field}: {where}; {heads}"]
