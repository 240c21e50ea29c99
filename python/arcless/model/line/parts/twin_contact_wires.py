"""Two contact wires side by side below one messenger wire."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from arcless.model.fields.part import Part, Unit
from arcless.model.fields.rule_errors import both_given, missing
from arcless.model.line.parts.geometry import MAX_PATTERN

Separations = Annotated[
    tuple[Annotated[float, Unit("m", minimum=-2, maximum=2)], ...],
    Field(min_length=2, max_length=MAX_PATTERN),
]


class TwinContactWires(Part):
    """A second contact wire like the first, and how the droppers hold the two."""

    separation: Annotated[float, Unit("m", above=0, maximum=0.5)] | None = Field(
        default=None,
        description="Distance of the two wires across the track, half to each side of the stagger.",
    )
    separations: Separations | None = Field(
        default=None,
        description="In place of separation, of wires that part and meet in plan: distance at"
        " successive supports, negative where the wires have crossed; the pattern repeats.",
    )
    droppers: Literal["paired", "alternating"] = Field(
        default="paired",
        description="At each position one on either wire, or one on the first and the next on the"
        " second.",
    )

    @model_validator(mode="after")
    def _check_one(self) -> "TwinContactWires":
        if self.separation is not None and self.separations is not None:
            raise both_given("separation", "separations")
        if self.separation is None and self.separations is None:
            expected = "a separation, or separations at successive supports"
            raise missing("separation", expected=expected)
        return self

    def apart(self, support: int) -> float:
        """Return y of wire 1 less that of wire 2 in m at a support of the line, from 0."""
        pattern = self.separations or (self.separation or 0.0,)
        return pattern[support % len(pattern)]

    @property
    def widest(self) -> float:
        """Largest distance of the two wires in m."""
        return max(abs(apart) for apart in self.separations or (self.separation or 0.0,))
