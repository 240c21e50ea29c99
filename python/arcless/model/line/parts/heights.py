"""Heights of the contact wire along a line: level, with gradients between."""

from collections.abc import Sequence
from typing import Annotated

from pydantic import Field

from arcless.model.fields.part import Part, Unit

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
