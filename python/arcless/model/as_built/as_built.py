"""Differences of a line from its design: as built, and in the weather."""

from math import cos, pi, sin, sqrt
from typing import Annotated

from pydantic import BeforeValidator, Field, WithJsonSchema, model_validator

from arcless.errors import ModelError
from arcless.model.as_built.gusts import Gusts
from arcless.model.as_built.measured_heights import MAX_HEIGHTS, MeasuredHeight
from arcless.model.fields.list_checks import check_behind
from arcless.model.fields.part import Part, Unit
from arcless.model.line.parts.spans import MAX_SPANS
from arcless.model.line.places.dropper_names import DropperName, parse_name
from arcless.model.line.places.support_names import SupportName
from arcless.units import WRONG_VALUE

MAX_DROPPERS = 100_000
Number = Annotated[int, Field(ge=1, strict=True)]


def _as_name(value: object) -> str:
    """Return the name of a dropper given by its name, or as {span: 3, dropper: 2}."""
    return str(parse_name(value))


class DropperLengthError(Part):
    """A dropper that is longer or shorter than designed."""

    span: Number = Field(description="Number of the span, from 1.")
    dropper: Number = Field(description="Number of the dropper in its span, from 1.")
    length_error: Annotated[float, Unit("m", minimum=-2, maximum=2)] = Field(
        description="Length as built minus designed length."
    )
    tension_length: Number | None = Field(
        default=None, description="Number of its tension length, needed in an overlap."
    )
    wire: Annotated[int, Field(ge=1, le=2, strict=True)] | None = Field(
        default=None, description="Of paired droppers, number of the contact wire, 1 or 2."
    )

    @property
    def name(self) -> DropperName:
        """Name of the dropper."""
        return DropperName(self.span, self.dropper, self.tension_length, self.wire)


class SupportHeightError(Part):
    """A support that stands higher or lower than drawn, and with it all that it holds."""

    support: Number = Field(description="Number of the support, from 1.")
    height_error: Annotated[float, Unit("m", minimum=-2, maximum=2)] = Field(
        description="Height as built minus height as drawn."
    )
    tension_length: Number | None = Field(
        default=None, description="Number of its tension length, needed in an overlap."
    )

    @property
    def name(self) -> SupportName:
        """Name of the support."""
        return SupportName(self.support, self.tension_length)


NamedDropper = Annotated[
    str,
    BeforeValidator(_as_name),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "string", "pattern": r"\bspan\s+\d+\s+dropper\s+\d+"},
                {
                    "type": "object",
                    "properties": {name: {"type": "integer"} for name in DropperName._fields},
                    "required": ["span", "dropper"],
                    "additionalProperties": False,
                },
            ]
        }
    ),
]


class Ice(Part):
    """Ice on the wires: weight and inertia along their whole length."""

    contact_wire: Annotated[float, Unit("kg/m", minimum=0, maximum=50)] = Field(
        default=0.0, description="Ice on the contact wire."
    )
    messenger_wire: Annotated[float, Unit("kg/m", minimum=0, maximum=50)] = Field(
        default=0.0, description="Ice on the messenger wire."
    )
    stitch_wire: Annotated[float, Unit("kg/m", minimum=0, maximum=50)] = Field(
        default=0.0, description="Ice on the stitch wires."
    )
    auxiliary_wire: Annotated[float, Unit("kg/m", minimum=0, maximum=50)] = Field(
        default=0.0, description="Ice on the auxiliary wire."
    )
    bridle: Annotated[float, Unit("kg/m", minimum=0, maximum=50)] = Field(
        default=0.0, description="Ice on the bridles."
    )
    density: Annotated[float, Unit("kg/m3", minimum=50, maximum=1000)] = Field(
        default=900.0, description="Density of the ice: how thick it is in the wind."
    )

    def diameter(self, bare: float, mass: float) -> float:
        """Return the diameter in m of a round coat of ice with a mass in kg/m on a wire."""
        return sqrt(bare * bare + 4.0 * mass / (pi * self.density))


class Wind(Part):
    """A steady wind across the track."""

    speed: Annotated[float, Unit("m/s", minimum=-100, maximum=100)] = Field(
        default=0.0, description="Wind speed, positive towards positive stagger."
    )
    angle: Annotated[float, Unit("rad", minimum=-pi / 2, maximum=pi / 2)] = Field(
        default=0.0, description="Angle of the wind to the horizontal, positive upwards."
    )
    air_density: Annotated[float, Unit("kg/m3", above=0, maximum=2)] = Field(
        default=1.225, description="Density of the air."
    )
    drag_coefficient: Annotated[float, Unit("1", above=0, maximum=5)] = Field(
        default=1.0, description="Drag coefficient of the wires."
    )

    def force(self, diameter: float) -> tuple[float, float]:
        """Return the force in N/m on a wire of a diameter in m: across the track, and upwards."""
        pressure = 0.5 * self.air_density * self.speed**2 * self.drag_coefficient * diameter
        across = pressure * cos(self.angle)
        return (across if self.speed > 0.0 else -across), pressure * sin(self.angle)


class Wear(Part):
    """A stretch of worn contact wire."""

    from_: Annotated[float, Unit("m", minimum=0)] = Field(
        alias="from", description="Start of the stretch."
    )
    to: Annotated[float, Unit("m", minimum=0)] = Field(description="End of the stretch.")
    fraction: Annotated[float, Unit("1", above=0, maximum=0.8)] = Field(
        description="Share of the section that is lost."
    )


class AsBuilt(Part):
    """Changes of a designed line after its design; none by default."""

    temperature_difference: Annotated[float, Unit("K", minimum=-150, maximum=150)] = Field(
        default=0.0, description="Temperature above that of the installation."
    )
    dropper_length_errors: tuple[DropperLengthError, ...] = Field(
        default=(),
        description="Dropper lengths that differ: a list, or a CSV file relative to this one.",
        max_length=MAX_DROPPERS,
        json_schema_extra={"table": True},
    )
    support_height_errors: tuple[SupportHeightError, ...] = Field(
        default=(),
        description="Supports at another height: a list, or a CSV file relative to this one.",
        max_length=2 * MAX_SPANS,
        json_schema_extra={"table": True},
    )
    measured_heights: tuple[MeasuredHeight, ...] = Field(
        default=(),
        description="Of the contact wire at every dropper and support, in place of those drawn: a"
        " list, or a CSV file relative to this one.",
        max_length=MAX_HEIGHTS,
        json_schema_extra={"table": True},
    )
    missing_droppers: tuple[NamedDropper, ...] = Field(
        default=(), description="Droppers that are missing or broken.", max_length=MAX_DROPPERS
    )
    ice: Ice = Field(default_factory=Ice, description="Ice on the wires.")
    wind: Wind = Field(default_factory=Wind, description="Steady wind across the track.")
    gusts: Gusts | None = Field(
        default=None,
        description="Wind over time during the run: lists, or a CSV file relative to this one.",
        json_schema_extra={"table": True},
    )
    contact_wire_wear: tuple[Wear, ...] = Field(
        default=(), description="Worn stretches of the contact wire.", max_length=10_000
    )

    @property
    def is_empty(self) -> bool:
        """True when nothing differs from the design at rest; gusts come with the run.

        Measured heights are no change after the design: they take the place of the drawn ones.
        """
        return not (
            self.temperature_difference
            or self.dropper_length_errors
            or self.support_height_errors
            or self.missing_droppers
            or self.ice.contact_wire
            or self.ice.messenger_wire
            or self.ice.stitch_wire
            or self.ice.bridle
            or self.ice.auxiliary_wire
            or self.wind.speed
            or self.contact_wire_wear
        )

    @model_validator(mode="after")
    def _check_once(self) -> "AsBuilt":
        names = [str(error.name) for error in self.dropper_length_errors]
        for field, given in (
            ("dropper_length_errors", names),
            ("missing_droppers", list(self.missing_droppers)),
        ):
            known: set[str] = set()
            for index, name in enumerate(given):
                if name in known:
                    raise ModelError(
                        "dropper given twice",
                        got=name,
                        expected="each dropper once",
                        field=(field, index),
                    )
                known.add(name)
        gone = set(self.missing_droppers)
        for index, name in enumerate(names):
            if name in gone:
                raise ModelError(
                    "length error of a missing dropper",
                    got=name,
                    expected="a dropper that is not in missing_droppers",
                    field=("dropper_length_errors", index),
                )
        return self

    @model_validator(mode="after")
    def _check_wear(self) -> "AsBuilt":
        for index, worn in enumerate(self.contact_wire_wear):
            if worn.to <= worn.from_:
                raise ModelError(
                    WRONG_VALUE,
                    got=f"{worn.to:g} m",
                    expected=f"a position behind from, {worn.from_:g} m",
                    field=("contact_wire_wear", index, "to"),
                )
        check_behind(self.contact_wire_wear, "stretches", ("contact_wire_wear",))
        return self
