"""The midpoint anchor of a tension length whose two ends are tensioned."""

from typing import Annotated

from pydantic import Field

from arcless.model.fields import extremes
from arcless.model.fields.part import Part, Unit


class MidpointAnchor(Part):
    """Midpoint anchor: keeps the wires in place along the track when both ends are tensioned."""

    stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] = Field(
        description="Along the track, of what holds each wire there."
    )
    support: Annotated[int, Field(ge=1, strict=True)] | None = Field(
        default=None,
        description="Number of its support; without it, the middle one of each tension length.",
    )
