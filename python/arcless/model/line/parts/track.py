"""Curves of the track, and how the wires of a line see them.

Positions across the track count from the pantograph's axis: the centre line of the track, at the
height of the contact wire, tilted with the cant. Positive is left, seen in the direction of travel.
Seen from that axis, a wire that is straight in space bends: with the direction θ of the axis,

    θ = ∫ ds/R + dδ/ds,    δ = h c / e

(R the radius, positive to the left; h the height of the contact wire, c the cant, e the distance
of the rails, δ towards the inside), and with the tension T, the load q across and y small,

    T (y″ + θ′) + q = 0

so the curve is a load T θ′ per metre towards its inside: T/R where it is circular. The core gets
the turn ∫ dθ along each element and finds the load from the tension. Left out are y/R and y′²
against 1, some 10⁻³ together, and the small change of θ with the height.
Source: equilibrium of a string in plane polar coordinates; Kießling, Puschmann, Schmieder: Contact
Lines for Electric Railways, gives T/R and L²/8R (mark C, the book was not read for this).
"""

from bisect import bisect_right
from functools import cached_property
from itertools import accumulate
from typing import Annotated, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields.list_checks import check_behind
from arcless.model.fields.part import Part, Unit

MAX_CURVES = 1000
# Points at which directions are averaged over a span: to 10⁻⁴ of the angle it turns by.
POINTS = 64


class Curve(Part):
    """A curve of the track, with its transitions."""

    from_: Annotated[float, Unit("m", minimum=-1e6, maximum=1e6)] = Field(
        alias="from", description="Where the track begins to bend."
    )
    to: Annotated[float, Unit("m", minimum=-1e6, maximum=1e6)] = Field(
        description="Where it is straight again."
    )
    radius: Annotated[float, Unit("m", minimum=20, maximum=1e6)] = Field(
        description="Radius between the transitions."
    )
    side: Literal["left", "right"] = Field(
        description="Where the centre is; left is the side of positive stagger."
    )
    transition: Annotated[float, Unit("m", minimum=0, maximum=2000)] = Field(
        default=0.0, description="Length at either end on which curvature and cant grow or shrink."
    )
    cant: Annotated[float, Unit("m", minimum=0, maximum=0.3)] = Field(
        default=0.0, description="Height of the outer rail above the inner one."
    )

    @model_validator(mode="after")
    def _check(self) -> "Curve":
        if self.to <= self.from_:
            raise ModelError(
                "empty curve",
                got=f"{self.from_:g} m to {self.to:g} m",
                expected="an end behind its start",
                field=("to",),
            )
        if 2.0 * self.transition > self.to - self.from_:
            raise ModelError(
                "transitions longer than the curve",
                got=f"two of {self.transition:g} m in {self.to - self.from_:g} m",
                expected=f"at most {0.5 * (self.to - self.from_):g} m each",
                hint="from and to enclose the transitions",
                field=("transition",),
            )
        if self.cant and not self.transition:
            raise ModelError(
                "cant without transition",
                got=f"{self.cant:g} m",
                expected="a transition above 0 m, on which it grows",
                hint="a pantograph cannot jump to the side",
                field=("transition",),
            )
        return self

    @property
    def sign(self) -> float:
        """1 to the left, −1 to the right."""
        return 1.0 if self.side == "left" else -1.0

    def turned(self, x: float) -> float:
        """Return the angle in rad that the track has turned by at x in m, positive for any side."""
        along, length, ramp = x - self.from_, self.to - self.from_, self.transition
        along = min(max(along, 0.0), length)
        whole = (length - ramp) / self.radius
        if along < ramp:
            return 0.5 * along * along / (ramp * self.radius)
        if along > length - ramp:
            return whole - 0.5 * (length - along) ** 2 / (ramp * self.radius)
        return (along - 0.5 * ramp) / self.radius

    def twist(self, x: float) -> float:
        """Return the change of the cant per metre of track at a position in m."""
        if self.from_ <= x < self.from_ + self.transition:
            return self.cant / self.transition
        if self.to - self.transition <= x < self.to:
            return -self.cant / self.transition
        return 0.0


class Track(Part):
    """The track below a line; straight and level without curves."""

    curves: tuple[Curve, ...] = Field(
        default=(), description="Curves along the track.", max_length=MAX_CURVES
    )
    rail_distance: Annotated[float, Unit("m", minimum=0.3, maximum=3)] = Field(
        default=1.5, description="Between the centres of the rail heads, over which cant counts."
    )

    @model_validator(mode="after")
    def _check_order(self) -> "Track":
        check_behind(self.curves, "curves", ("curves",))
        return self

    def direction(self, x: float, height: float) -> float:
        """Return the direction θ in rad of the axis at a height in m, positive to the left."""
        passed = bisect_right(self.curves, x, key=lambda curve: curve.from_)
        if not passed:
            return 0.0
        curve = self.curves[passed - 1]
        swing = height * curve.twist(x) / self.rail_distance
        return self.turned_before[passed - 1] + curve.sign * (curve.turned(x) + swing)

    @cached_property
    def turned_before(self) -> list[float]:
        """Angle in rad, positive to the left, by which the track has turned before each curve."""
        turns = (curve.sign * curve.turned(curve.to) for curve in self.curves)
        return list(accumulate(turns, initial=0.0))

    def bends(self, left: float, right: float) -> bool:
        """Return whether there is a curve somewhere between two positions in m."""
        return any(curve.from_ < right and curve.to > left for curve in self.curves)

    def mean_direction(self, left: float, right: float, height: float) -> float:
        """Return the mean of θ in rad between two positions in m."""
        step = (right - left) / POINTS
        angles = (self.direction(left + (i + 0.5) * step, height) for i in range(POINTS))
        return sum(angles) / POINTS

    def offsets(self, left: float, right: float, height: float) -> list[float]:
        """Return the lateral distance in m of a wire from the straight line between two supports.

        y″ = −θ′ with y = 0 at both ends: y = θ̄ s − ∫ θ ds, s from the left one.
        """
        step = (right - left) / POINTS
        angles = [self.direction(left + (i + 0.5) * step, height) for i in range(POINTS)]
        mean, found, integral = sum(angles) / POINTS, [0.0], 0.0
        for number, angle in enumerate(angles, start=1):
            integral += angle * step
            found.append(mean * number * step - integral)
        return found
