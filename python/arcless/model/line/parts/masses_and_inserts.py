"""Parts at one place on a wire: point masses, and inserts such as section insulators."""

from typing import Annotated, Literal

from pydantic import Field

from arcless.model.fields import extremes
from arcless.model.fields.part import Part, Unit

OnWire = Literal["contact_wire", "messenger_wire", "auxiliary_wire"]
MAX_PARTS = 10_000


class _OnWire(Part):
    """Part with a name and a place on a wire."""

    name: str = Field(default="", description="What it is; for readers.")
    wire: OnWire = Field(default="contact_wire", description="Wire that it sits on.")
    position: Annotated[float, Unit("m", minimum=0)] = Field(
        description="Place along the track; of an insert, its middle."
    )
    tension_length: Annotated[int, Field(ge=1, strict=True)] | None = Field(
        default=None, description="Whose wire, from 1; needed in an overlap only."
    )


class LumpedMass(_OnWire):
    """A mass on a wire."""

    mass: Annotated[float, Unit("kg", above=0, maximum=extremes.MASS)] = Field(description="Mass.")


class Insert(_OnWire):
    """A piece of a wire that is made of something else, such as a section insulator."""

    length: Annotated[float, Unit("m", above=0, maximum=50)] = Field(description="Length.")
    mass: Annotated[float, Unit("kg", above=0, maximum=extremes.MASS)] = Field(
        description="Mass of all of it."
    )
    axial_stiffness: Annotated[float, Unit("N", above=0, maximum=extremes.AXIAL_STIFFNESS)] = Field(
        description="Axial stiffness EA."
    )
    bending_stiffness: Annotated[
        float, Unit("N m2", minimum=0, maximum=extremes.BENDING_STIFFNESS)
    ] = Field(description="Bending stiffness EI.")

    @property
    def ends(self) -> tuple[float, float]:
        """Where it begins and ends along the track, in m."""
        return self.position - 0.5 * self.length, self.position + 0.5 * self.length
