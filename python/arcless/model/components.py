"""What a line is made of: wires, droppers, messenger supports, steady arms."""

from math import pi
from typing import Annotated, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import Part, Unit


class Rayleigh(Part):
    """Proportional damping C = alpha M + beta K."""

    alpha: Annotated[float, Unit("1/s", minimum=0)] = Field(default=0.0, description="Mass share.")
    beta: Annotated[float, Unit("s", minimum=0)] = Field(
        default=0.0, description="Stiffness share."
    )


# Copper and its alloys, 16.6e-6 to 17.7e-6 1/K.
COPPER_EXPANSION = 17e-6


class TensionedWire(Part):
    """What all wires of a line have in common."""

    catalogue: str | None = Field(
        default=None, description="Wire of the shipped catalogue; it gives what is not given here."
    )
    mass: Annotated[float, Unit("kg/m", above=0)] = Field(description="Mass per metre.")
    axial_stiffness: Annotated[float, Unit("N", above=0)] = Field(description="Axial stiffness EA.")
    bending_stiffness: Annotated[float, Unit("N m2", minimum=0)] = Field(
        description="Bending stiffness EI."
    )
    tension: Annotated[float, Unit("N", above=0)] = Field(description="Tension.")
    damping: Rayleigh = Field(default_factory=Rayleigh, description="Rayleigh damping of the wire.")
    thermal_expansion: Annotated[float, Unit("1/K", minimum=0, maximum=1e-3)] = Field(
        default=COPPER_EXPANSION,
        description="Linear thermal expansion; default assumed (copper).",
    )
    diameter: Annotated[float, Unit("m", above=0, maximum=0.2)] | None = Field(
        default=None, description="Diameter of the bare wire; wind acts on it."
    )


class Wire(TensionedWire):
    """A contact or messenger wire under tension."""

    ends: Literal["fixed", "constant_force", "spring"] = Field(
        default="fixed",
        description="Far end anchored, or held by a device of constant force or a spring; with a"
        " midpoint anchor both ends.",
    )
    end_stiffness: Annotated[float, Unit("N/m", above=0)] | None = Field(
        default=None, description="Stiffness of a tensioning spring; only with ends: spring."
    )

    @model_validator(mode="after")
    def _check_ends(self) -> "Wire":
        if self.ends == "spring" and self.end_stiffness is None:
            raise ModelError(
                "missing field",
                expected=self._expected("end_stiffness"),
                field=("end_stiffness",),
            )
        if self.ends != "spring" and self.end_stiffness is not None:
            raise ModelError(
                "stiffness of a spring that is not there",
                got=f"end_stiffness with ends: {self.ends}",
                expected="ends: spring, or no end_stiffness",
                field=("end_stiffness",),
            )
        return self


class StitchWire(TensionedWire):
    """A stitch wire, between two clamps on the messenger wire at each inner support."""

    length: Annotated[float, Unit("m", above=0, maximum=500)] = Field(
        description="Distance between its clamps, half of it on each side of the support."
    )
    clamp_mass: Annotated[float, Unit("kg", minimum=0)] = Field(
        default=0.0, description="Mass of each clamp on the messenger wire."
    )


class AuxiliaryWire(Wire):
    """An auxiliary messenger wire: it hangs on droppers, and the contact wire on it by hangers."""

    height: Annotated[float, Unit("m", above=0, maximum=10)] = Field(
        description="Nominal height above that of the contact wire."
    )


class DropperType(Part):
    """The droppers of a line: tension only when slackens is true."""

    stiffness: Annotated[float, Unit("N/m", above=0)] = Field(description="Stiffness when taut.")
    mass: Annotated[float, Unit("kg/m", minimum=0)] = Field(
        default=0.0, description="Mass per metre."
    )
    damping: Annotated[float, Unit("N s/m", minimum=0)] = Field(
        default=0.0, description="Viscous damping along the dropper."
    )
    rayleigh: Rayleigh = Field(default_factory=Rayleigh, description="Rayleigh damping.")
    clamp_mass_contact_wire: Annotated[float, Unit("kg", minimum=0)] = Field(
        default=0.0, description="Mass of the clamp on the contact wire."
    )
    clamp_mass_messenger_wire: Annotated[float, Unit("kg", minimum=0)] = Field(
        default=0.0, description="Mass of the clamp on the messenger wire."
    )
    slackens: bool = Field(default=True, strict=True, description="False: can be compressed.")
    thermal_expansion: Annotated[float, Unit("1/K", minimum=0, maximum=1e-3)] = Field(
        default=COPPER_EXPANSION,
        description="Linear thermal expansion; default assumed (copper).",
    )


class MessengerSupport(Part):
    """The support of the messenger wire at each mast."""

    vertical_stiffness: Annotated[float, Unit("N/m", above=0)] = Field(
        description="Vertical stiffness."
    )
    lateral_stiffness: Annotated[float, Unit("N/m", above=0)] | None = Field(
        default=None, description="Stiffness across the track; without it, the vertical one."
    )
    longitudinal_stiffness: Annotated[float, Unit("N/m", minimum=0)] = Field(
        default=0.0, description="Stiffness along the track."
    )
    vertical_damping: Annotated[float, Unit("N s/m", minimum=0)] = Field(
        default=0.0, description="Vertical damping."
    )
    mass: Annotated[float, Unit("kg", minimum=0)] = Field(default=0.0, description="Moving mass.")


class SteadyArmSpring(Part):
    """A steady arm reduced to a vertical spring."""

    kind: Literal["spring"] = Field(default="spring", description="Kind of steady arm.")
    vertical_stiffness: Annotated[float, Unit("N/m", minimum=0)] = Field(
        description="Vertical stiffness at the contact wire."
    )
    vertical_damping: Annotated[float, Unit("N s/m", minimum=0)] = Field(
        default=0.0, description="Vertical damping at the contact wire."
    )
    mass: Annotated[float, Unit("kg", minimum=0)] = Field(
        default=0.0, description="Moving mass at the contact wire."
    )


class SteadyArmBar(Part):
    """A steady arm as a hinged bar that carries the radial load of the contact wire."""

    kind: Literal["arm"] = Field(description="Kind of steady arm.")
    length: Annotated[float, Unit("m", above=0, maximum=10)] = Field(
        description="Length from hinge to clamp."
    )
    slope: Annotated[float, Unit("rad", above=-pi / 3, below=pi / 3)] = Field(
        default=0.0, description="Angle to the horizontal, positive with the hinge end higher."
    )
    mass: Annotated[float, Unit("kg/m", minimum=0)] = Field(
        default=0.0, description="Mass per metre."
    )
    axial_stiffness: Annotated[float, Unit("N", above=0)] = Field(
        default=17e6,
        description="Axial stiffness EA; default assumed (aluminium, 250 mm²).",
    )


class NoSteadyArm(Part):
    """No steady arm: at the supports nothing holds the contact wire, it hangs on its droppers."""

    kind: Literal["none"] = Field(description="Kind of steady arm.")


SteadyArm = Annotated[SteadyArmSpring | SteadyArmBar | NoSteadyArm, Field(discriminator="kind")]
