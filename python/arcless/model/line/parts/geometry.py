"""Positions of the wires of a line at its supports, and the space the line was designed for."""

from typing import Annotated, Literal

from pydantic import Field

from arcless.model.fields.part import Part, Unit
from arcless.model.line.parts.heights import HeightChange
from arcless.model.line.parts.spans import MAX_SPANS

# One for each support.
MAX_PATTERN = MAX_SPANS + 1


Staggers = Annotated[
    tuple[Annotated[float, Unit("m", minimum=-1, maximum=1)], ...],
    Field(min_length=1, max_length=MAX_PATTERN),
]


class Geometry(Part):
    """Heights and staggers at the supports."""

    contact_wire_height: Annotated[float, Unit("m", above=0, maximum=20)] = Field(
        description="Height of the contact wire above rail at the supports, from the first one on."
    )
    height_changes: tuple[HeightChange, ...] = Field(
        default=(),
        description="Stretches on which that height changes, and all wires with it.",
        max_length=MAX_PATTERN,
    )
    encumbrance: Annotated[float, Unit("m", above=0, maximum=10)] | None = Field(
        default=None,
        description="Messenger wire above contact wire at the supports (system height).",
    )
    stagger_contact_wire: Staggers = Field(
        default=(0.0,), description="Stagger at successive supports; the pattern repeats."
    )
    stagger_messenger_wire: Staggers = Field(
        default=(0.0,), description="Lateral position of the messenger wire; the pattern repeats."
    )
    stagger_auxiliary_wire: Staggers | None = Field(
        default=None, description="Of the auxiliary wire; without it, as the contact wire."
    )


# Whose limits are shown for a line that names no supply; they decide nothing.
ASSUMED_SUPPLY = "AC 25 kV"


class DesignSpace(Part):
    """Uplift space and supply that the line was designed for; used by the assessment only."""

    uplift_space: Annotated[float, Unit("m", above=0, maximum=2)] | None = Field(
        default=None, description="Free space above the steady arm at rest."
    )
    uplift_limited: bool = Field(
        default=False,
        strict=True,
        description="True when a stop limits the steady arm's uplift.",
    )
    supply: Literal["AC 25 kV", "AC 15 kV", "DC 3 kV", "DC 1.5 kV"] | None = Field(
        default=None,
        description="Electrical supply; selects the force limits. Without it those of AC 25 kV are"
        " shown, and decide nothing.",
    )
