"""Rules for curves and staggers of a line."""

from itertools import pairwise
from math import sqrt
from typing import NamedTuple

from arcless.errors import ModelError
from arcless.model.line.line_data import LineData

# Spans that are equal apart from rounding: the first one is named. In m.
ROUNDING = 1e-9
# No collector in service is wider than 1.95 m, with 0.975 m to either side. In m.
WIDEST = 1.0
# Offsets of a straight wire from the line between its supports: at both ends. In m.
STRAIGHT = (0.0, 0.0)


class LateralExtreme(NamedTuple):
    """Where the contact wire of a line is farthest from the pantograph's axis."""

    distance: float
    span: int
    x: float
    curve_part: float


def farthest(line: LineData) -> LateralExtreme:
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
                worst = LateralExtreme(y, index + 1, left + share * (right - left), offset)
    assert worst is not None  # a line has spans
    return worst


def check_track(line: LineData) -> None:
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


def _shorter(line: LineData, worst: LateralExtreme) -> str:
    """Say how long spans may be: the part of the curve goes with the square of their length."""
    by_stagger = abs(worst.distance) - abs(worst.curve_part)
    room, length = WIDEST - by_stagger, line.span_list()[worst.span - 1].length
    spans = "shorter spans"
    if 0 < room < abs(worst.curve_part):
        spans += f" there, of at most {int(length * sqrt(room / abs(worst.curve_part)))} m"
    return f"{spans}, or more stagger to the outside of the curve; is the radius as meant?"
