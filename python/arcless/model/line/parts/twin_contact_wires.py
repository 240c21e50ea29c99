"""Two contact wires side by side below one messenger wire."""

from typing import Annotated, Literal

from pydantic import Field

from arcless.model.fields.part import Part, Unit


class TwinContactWires(Part):
    """A second contact wire like the first, and how the droppers hold the two."""

    separation: Annotated[float, Unit("m", above=0, maximum=0.5)] = Field(
        description="Distance of the two wires across the track, half to each side of the stagger."
    )
    droppers: Literal["paired", "alternating"] = Field(
        default="paired",
        description="At each position one on either wire, or one on the first and the next on the"
        " second.",
    )
