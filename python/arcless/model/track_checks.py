"""Whether curves and staggers of a line go together."""

from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from arcless.errors import ModelError

if TYPE_CHECKING:
    from arcless.model.line import Line

# Spans that are equal but for rounding: the first one is named. In m.
ROUNDING = 1e-9
# No collector in service is wider than 1.95 m, with 0.975 m to either side. In m.
WIDEST = 1.0
# Lateral deviation allowed for a head of 1.60 m and for one of 1.95 m: the source S11 of the design
# data, mark A. In m.
ALLOWED = (0.40, 0.55)


class Aside(NamedTuple):
    """Where the contact wire of a line is farthest from the pantograph's axis."""

    distance: float
    span: int
    x: float
    curve_part: float


def farthest(line: "Line") -> Aside | None:
    """Return where the contact wire at rest lies farthest aside in a span with a curve."""
    supports, pattern = line.support_positions(), line.geometry.stagger_contact_wire
    height, worst = line.geometry.contact_wire_height, None
    for index, (left, right) in enumerate(pairwise(supports)):
        if not line.track.bends(left, right):
            continue
        offsets = line.track.offsets(left, right, height)
        first, last = (pattern[k % len(pattern)] for k in (index, index + 1))
        for place, offset in enumerate(offsets):
            share = place / (len(offsets) - 1)
            y = first + share * (last - first) + offset
            if worst is None or abs(y) > abs(worst.distance) + ROUNDING:
                worst = Aside(y, index + 1, left + share * (right - left), offset)
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
            field=("track", "curves"),
        )
    worst = farthest(line)
    if worst is not None and abs(worst.distance) > WIDEST:
        raise ModelError(
            "a curve tighter than the stagger allows",
            got=f"the contact wire {abs(worst.distance):.3g} m aside at {worst.x:.4g} m, in span"
            f" {worst.span}, {abs(worst.curve_part):.3g} m of it by the curve",
            expected=f"at most {WIDEST:g} m: no collector reaches farther",
            hint="shorter spans, or more stagger to the outside of the curve",
            field=("track", "curves"),
        )


def deviation_warnings(line: "Line") -> list[str]:
    """Return a sentence when the wire lies farther aside than narrow heads allow."""
    worst = farthest(line)
    if worst is None or abs(worst.distance) <= ALLOWED[0]:
        return []
    heads = "0.40 m are allowed for a head of 1.60 m"
    if abs(worst.distance) > ALLOWED[1]:
        heads += ", 0.55 m for one of 1.95 m"
    return [
        f"line.track.curves: the contact wire at rest lies {abs(worst.distance):.3g} m aside at"
        f" {worst.x:.4g} m, in span {worst.span}; {heads}"
    ]
