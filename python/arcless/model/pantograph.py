"""A pantograph as a chain of masses, springs and dampers, from base to head."""

from typing import Annotated, Literal

from pydantic import Field

from arcless.model.documents import Document
from arcless.model.fields import Part, Unit

MAX_MASSES = 20


class PantographMass(Part):
    """A mass of the chain, with the spring and damper below it."""

    mass: Annotated[float, Unit("kg", above=0)] = Field(description="Mass.")
    stiffness: Annotated[float, Unit("N/m", minimum=0)] = Field(
        description="Spring to the mass below, or to the base frame."
    )
    damping: Annotated[float, Unit("N s/m", minimum=0)] = Field(
        description="Damper to the mass below, or to the base frame."
    )
    aerodynamic: Annotated[float, Unit("N/(m/s)2")] = Field(
        default=0.0,
        description="Upward aerodynamic force on this mass over speed squared.",
    )


class Pantograph(Document):
    """A pantograph: a chain of masses from base to head."""

    format: Literal["arcless-pantograph/1"] = Field(
        default="arcless-pantograph/1", description="Format and version."
    )
    masses: tuple[PantographMass, ...] = Field(
        description="Masses from base to head.", min_length=1, max_length=MAX_MASSES
    )
    static_force: Annotated[float, Unit("N", above=0, maximum=2000)] | None = Field(
        default=None, description="Static force, used when a scenario gives no force."
    )
