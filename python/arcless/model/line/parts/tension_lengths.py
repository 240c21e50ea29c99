"""Several tension lengths along a line, and the overlaps where one wire hands over to the next."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from arcless.model.fields.part import Part, Unit

SpanNumber = Annotated[int, Field(ge=1, strict=True)]
SEPARATION = {"uninsulated": 0.2, "insulated": 0.45}

Sides = Annotated[
    tuple[Annotated[float, Unit("m", minimum=-5, maximum=5)], ...],
    Field(min_length=4, max_length=6),
]


class TensionLength(Part):
    """The spans that one set of wires runs over, from anchor to anchor."""

    from_span: SpanNumber = Field(description="Number of its first span, from 1.")
    to_span: SpanNumber = Field(description="Number of its last span.")


class Overlap(Part):
    """Overlap of two tension lengths that hang side by side; one geometry for all overlaps."""

    raise_: Annotated[
        tuple[Annotated[float, Unit("m", minimum=0, maximum=3)], ...],
        Field(min_length=1, max_length=3),
    ] = Field(
        alias="raise",
        description="Of a wire above its height, at successive supports from its anchor inwards.",
    )
    kind: Literal["uninsulated", "insulated"] = Field(
        default="uninsulated",
        description="Mechanical overlap, or one that also parts the circuits; sets the separation.",
    )
    separation: Annotated[float, Unit("m", minimum=0, maximum=3)] | None = Field(
        default=None,
        description="Distance of the two contact wires across the track, half of it to each side of"
        " the staggers; without it 0.2 m uninsulated, 0.45 m insulated (assumed).",
    )
    stagger_in: Sides | None = Field(
        default=None,
        description="Stagger of the wire that begins, at each support of the overlap in order.",
    )
    stagger_out: Sides | None = Field(
        default=None,
        description="Stagger of the wire that ends, at each support of the overlap in order.",
    )

    @property
    def apart(self) -> float:
        """Separation in m, given or that of the kind."""
        return SEPARATION[self.kind] if self.separation is None else self.separation


@dataclass(frozen=True)
class Meeting:
    """An overlap: the tension lengths before and behind it (from 0), its spans (from 1)."""

    before: int
    first: int
    last: int

    @property
    def supports(self) -> range:
        """Places of its supports in the list of all, the anchor of the new wire first."""
        return range(self.first - 1, self.last + 1)


def meetings(lengths: Sequence[TensionLength]) -> list[Meeting]:
    """Return the overlaps of successive tension lengths; empty ones have last before first."""
    return [
        Meeting(index, lengths[index + 1].from_span, lengths[index].to_span)
        for index in range(len(lengths) - 1)
    ]
