"""Heights of the contact wire along a line: gradients, and what the standard says of them."""

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from arcless.errors import ModelError
from arcless.model.fields.part import Part, Unit

if TYPE_CHECKING:
    from arcless.model.line.line import Line

KMH = 3.6
PLACE = "line.geometry.height_changes"
# EN 50119, as read in the source S11 of the design data (mark A): up to a speed in km/h, the
# greatest gradient and the greatest change of gradient in ‰. Between 200 and 250 km/h the table
# is silent; the last row is taken there, the strict side.
GRADIENTS = ((60, 20, 10), (100, 6, 3), (120, 4, 2), (160, 2, 1), (200, 1, 0.5))
FASTEST = (0.4, 0.2)
# Gradients are differences of heights over lengths; this lies far below any drawing. In ‰.
ROUNDING = 1e-6

SupportNumber = Annotated[int, Field(ge=1, strict=True)]


class HeightChange(Part):
    """A stretch on which the height changes."""

    from_support: SupportNumber = Field(description="Number of the support where it begins.")
    to_support: SupportNumber = Field(description="Number of the support where it ends.")
    height: Annotated[float, Unit("m", above=0, maximum=20)] = Field(
        description="Height of the contact wire from there on."
    )


def heights_at(
    start: float, changes: Sequence[HeightChange], supports: Sequence[float]
) -> list[float]:
    """Return the height in m at each support: linear on every stretch, level between them."""
    height, found = start, [start] * len(supports)
    for change in changes:
        first, last = change.from_support - 1, change.to_support - 1
        left, right = supports[first], supports[last]
        for index in range(first, len(supports)):
            share = min((supports[index] - left) / (right - left), 1.0)
            found[index] = height + share * (change.height - height)
        height = change.height
    return found


def check_heights(line: "Line") -> None:
    """Raise `ModelError` for the first change of height that does not fit the line."""
    count, end = len(line.support_positions()), 1
    for index, change in enumerate(line.geometry.height_changes):
        field = ("geometry", "height_changes", index)
        if change.to_support <= change.from_support:
            raise ModelError(
                "empty stretch",
                got=f"support {change.from_support} to support {change.to_support}",
                expected="an end behind its start",
                field=(*field, "to_support"),
            )
        if change.from_support < end:
            raise ModelError(
                "stretches overlap or are out of order",
                got=f"a start at support {change.from_support} before the end of the last one,"
                f" support {end}",
                expected="stretches along the track, one behind the other",
                field=(*field, "from_support"),
            )
        if change.to_support > count:
            raise ModelError(
                "change of height outside the line",
                got=f"support {change.to_support}",
                expected=f"a support from 1 to {count}",
                field=(*field, "to_support"),
            )
        end = change.to_support


def allowed_gradient(speed: float) -> tuple[float, float]:
    """Return the greatest gradient and change of gradient in ‰ at a speed in m/s."""
    for fastest, gradient, change in GRADIENTS:
        if speed * KMH <= fastest * (1 + ROUNDING):
            return gradient, change
    return FASTEST


def gradient_warnings(line: "Line", speed: float) -> list[str]:
    """Return a sentence for the steepest gradient and the sharpest change that go too far."""
    supports, heights = line.support_positions(), line.contact_wire_heights()
    found = []
    slopes = [
        1e3 * (behind - before) / (right - left)
        for (before, behind), (left, right) in zip(
            pairwise(heights), pairwise(supports), strict=True
        )
    ]
    steepest, sharpest = allowed_gradient(speed)
    at_speed = f"at {speed * KMH:.0f} km/h"
    worst = max(range(len(slopes)), key=lambda span: abs(slopes[span]))
    if abs(slopes[worst]) > steepest + ROUNDING:
        found.append(
            f"{PLACE}: a gradient of {slopes[worst]:.3g} ‰ in span {worst + 1};"
            f" EN 50119 allows {steepest:g} ‰ {at_speed}"
        )
    turns = [behind - before for before, behind in pairwise(slopes)]
    worst = max(range(len(turns)), key=lambda place: abs(turns[place]), default=0)
    if turns and abs(turns[worst]) > sharpest + ROUNDING:
        found.append(
            f"{PLACE}: the gradient changes by {abs(turns[worst]):.3g} ‰ at support {worst + 2};"
            f" EN 50119 allows {sharpest:g} ‰ {at_speed}: put a span of half the gradient between"
        )
    return found
