"""Parts of lines without a messenger wire: contact supports, bridles, conductor rails."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.part import Part, Unit
from arcless.model.line.parts.components import TensionedWire, Wire
from arcless.units import WRONG_VALUE, accepted


class Joints(Part):
    """Joints of a conductor rail, each a point mass."""

    mass: Annotated[float, Unit("kg", above=0, maximum=extremes.MASS)] = Field(
        description="Mass of each joint."
    )
    spacing: Annotated[float, Unit("m", minimum=1, maximum=500)] = Field(
        description="Distance from joint to joint."
    )
    first: Annotated[float, Unit("m", minimum=0)] | None = Field(
        default=None, description="Place of the first one; without it, one spacing from the start."
    )

    def places(self, length: float) -> list[float]:
        """Return the places in m on a rail of a length in m, from its start."""
        first = self.spacing if self.first is None else self.first
        count = max(0, int((length - first) // self.spacing) + 1)
        # Beyond the last support there is no rail, and on it a joint has nothing to move.
        return [x for x in (first + i * self.spacing for i in range(count)) if 0 < x < length]


class ContactWire(Wire):
    """A contact wire under tension, or a conductor rail."""

    kind: Literal["wire", "conductor_rail"] = Field(
        default="wire", description="A wire, or a rail that may be without tension."
    )
    tension: Annotated[float, Unit("N", minimum=0, maximum=extremes.TENSION)] = Field(
        description="Tension; 0 only in a rail."
    )
    joints: Joints | None = Field(default=None, description="Joints of a conductor rail.")

    @model_validator(mode="after")
    def _check_kind(self) -> "ContactWire":
        least = extremes.LEAST_TENSION
        if self.tension < least and (self.kind == "wire" or self.tension > 0):
            raise ModelError(
                WRONG_VALUE,
                got=f"{self.tension:g} N",
                expected=f"{accepted('N')}, at least {least:g} N",
                hint="only a conductor rail (kind: conductor_rail) is without tension",
                field=("tension",),
            )
        if self.tension == 0 and self.bending_stiffness == 0:
            raise ModelError(
                "nothing holds the rail up between its supports",
                got="neither tension nor bending stiffness",
                expected="a bending stiffness above 0 N m²",
                field=("bending_stiffness",),
            )
        if self.joints is not None and self.kind == "wire":
            raise ModelError(
                "joints of a wire",
                expected="kind: conductor_rail, or no joints",
                hint="single masses on a wire are point_masses",
                field=("joints",),
            )
        return self


class ContactSupport(Part):
    """Support of a contact wire without a messenger wire at each mast, or of its bridle."""

    vertical_stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] = Field(
        description="Vertical stiffness."
    )
    lateral_stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] | None = (
        Field(default=None, description="Stiffness across the track; without it, the vertical one.")
    )
    vertical_damping: Annotated[float, Unit("N s/m", minimum=0, maximum=extremes.DAMPING)] = Field(
        default=0.0, description="Vertical damping."
    )
    mass: Annotated[float, Unit("kg", minimum=0, maximum=extremes.MASS)] = Field(
        default=0.0, description="Moving mass."
    )


class Bridle(TensionedWire):
    """A bridle: hung in its middle at each inner support, its ends on the contact wire."""

    length: Annotated[float, Unit("m", minimum=extremes.LEAST_CLAMP_DISTANCE, maximum=100)] = Field(
        description="Distance between its clamps, half of it on each side of the support."
    )
    clamp_mass: Annotated[float, Unit("kg", minimum=0, maximum=extremes.MASS)] = Field(
        default=0.0, description="Mass of each clamp on the contact wire."
    )
