"""Components of a line: wires, droppers, messenger supports, steady arms."""

from math import pi
from typing import Annotated, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.part import Part, Unit
from arcless.model.fields.rule_errors import missing
from arcless.model.line.parts.wire_ends import GRAVITY, USUAL_RATIO, Ends


class Rayleigh(Part):
    """Proportional damping C = alpha M + beta K."""

    alpha: Annotated[float, Unit("1/s", minimum=0, maximum=extremes.MASS_SHARE)] = Field(
        default=0.0, description="Mass share."
    )
    beta: Annotated[float, Unit("s", minimum=0, maximum=extremes.STIFFNESS_SHARE)] = Field(
        default=0.0, description="Stiffness share."
    )


# Copper and its alloys, 16.6e-6 to 17.7e-6 1/K.
COPPER_EXPANSION = 17e-6


class TensionedWire(Part):
    """Fields that all wires of a line have."""

    catalogue: str | None = Field(
        default=None, description="Wire of the shipped catalogue; it gives what is not given here."
    )
    mass: Annotated[
        float,
        Unit("kg/m", minimum=extremes.LEAST_MASS_PER_METRE, maximum=extremes.MASS_PER_METRE),
    ] = Field(description="Mass per metre.")
    axial_stiffness: Annotated[
        float,
        Unit("N", minimum=extremes.LEAST_AXIAL_STIFFNESS, maximum=extremes.AXIAL_STIFFNESS),
    ] = Field(description="Axial stiffness EA.")
    bending_stiffness: Annotated[
        float, Unit("N m2", minimum=0, maximum=extremes.BENDING_STIFFNESS)
    ] = Field(description="Bending stiffness EI.")
    tension: Annotated[
        float, Unit("N", minimum=extremes.LEAST_TENSION, maximum=extremes.TENSION)
    ] = Field(description="Tension.")
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

    ends: Ends | None = Field(
        default=None,
        description="Ends anchored (fixed), or held by weights, a device of constant force or a"
        " spring; without it, fixed, and a notice says what temperature then does.",
    )
    end_stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] | None = (
        Field(default=None, description="Stiffness of a tensioning spring; only with ends: spring.")
    )
    end_ratio: Annotated[float, Unit("1", minimum=1, maximum=20)] | None = Field(
        default=None,
        description="Way of the weights over that of the end of the wire; only with ends:"
        " weights; 3 without it, assumed (a usual tensioning wheel).",
    )
    end_efficiency: Annotated[float, Unit("1", above=0.5, maximum=1)] | None = Field(
        default=None,
        description="Efficiency of weights or of a device of constant force: they pull with this"
        " share of the tension where the wire grows longer, and yield only to the tension over it"
        " where the wire grows shorter; 1 without it.",
    )

    @model_validator(mode="after")
    def _check_ends(self) -> "Wire":
        if self.ends == "spring" and self.end_stiffness is None:
            raise missing("end_stiffness", expected=self._expected("end_stiffness"))
        said = f"with ends: {self.ends}" if self.ends else "without ends"
        for name, kinds, what in (
            ("end_stiffness", ("spring",), "stiffness of a spring that is not there"),
            ("end_ratio", ("weights",), "ratio of a pulley that is not there"),
            ("end_efficiency", ("weights", "constant_force"), "friction of a device that has none"),
        ):
            if getattr(self, name) is not None and self.ends not in kinds:
                raise ModelError(
                    what,
                    got=f"{name} {said}",
                    expected=f"ends: {' or '.join(kinds)}, or no {name}",
                    field=(name,),
                )
        # A contact wire without tension that is no rail is told so itself, `ContactWire`.
        if self.ends == "weights" and self.tension == 0 and getattr(self, "kind", "") != "wire":
            raise ModelError(
                "weights at a rail without tension",
                got="ends: weights",
                expected="ends: constant_force, its ends then slide",
                field=("ends",),
            )
        return self

    @property
    def is_anchored(self) -> bool:
        """True when the ends are fixed, also for want of anything said of them."""
        return self.ends in {None, "fixed"}

    @property
    def end_mass(self) -> float:
        """Mass in kg of the weights, as the end of the wire feels it along the track: n T/g."""
        if self.ends != "weights":
            return 0.0
        return (self.end_ratio or USUAL_RATIO) * self.tension / GRAVITY

    @property
    def has_friction(self) -> bool:
        """True when the device holds still in a band of tension."""
        return self.end_efficiency is not None and self.end_efficiency < 1

    @property
    def end_band(self) -> tuple[float, float]:
        """Lowest and highest tension in N at which the device holds still."""
        efficiency = self.end_efficiency or 1.0
        return self.tension * efficiency, self.tension / efficiency


class StitchWire(TensionedWire):
    """A stitch wire, between two clamps on the messenger wire at each inner support."""

    length: Annotated[float, Unit("m", minimum=extremes.LEAST_CLAMP_DISTANCE, maximum=500)] = Field(
        description="Distance between its clamps, half of it on each side of the support."
    )
    clamp_mass: Annotated[float, Unit("kg", minimum=0, maximum=extremes.MASS)] = Field(
        default=0.0, description="Mass of each clamp on the messenger wire."
    )


class AuxiliaryWire(Wire):
    """An auxiliary messenger wire: it hangs on droppers, and the contact wire on it by hangers."""

    height: Annotated[float, Unit("m", above=0, maximum=10)] = Field(
        description="Nominal height above that of the contact wire."
    )


class DropperType(Part):
    """The droppers of a line: tension only when slackens is true."""

    stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] = Field(
        description="Stiffness when taut."
    )
    mass: Annotated[float, Unit("kg/m", minimum=0, maximum=extremes.MASS_PER_METRE)] = Field(
        default=0.0, description="Mass per metre."
    )
    damping: Annotated[float, Unit("N s/m", minimum=0, maximum=extremes.DAMPING)] = Field(
        default=0.0, description="Viscous damping along the dropper."
    )
    rayleigh: Rayleigh = Field(default_factory=Rayleigh, description="Rayleigh damping.")
    clamp_mass_contact_wire: Annotated[float, Unit("kg", minimum=0, maximum=extremes.MASS)] = Field(
        default=0.0, description="Mass of the clamp on the contact wire."
    )
    clamp_mass_messenger_wire: Annotated[float, Unit("kg", minimum=0, maximum=extremes.MASS)] = (
        Field(default=0.0, description="Mass of the clamp on the messenger wire.")
    )
    slackens: bool = Field(default=True, strict=True, description="False: can be compressed.")
    thermal_expansion: Annotated[float, Unit("1/K", minimum=0, maximum=1e-3)] = Field(
        default=COPPER_EXPANSION,
        description="Linear thermal expansion; default assumed (copper).",
    )


class MessengerSupport(Part):
    """The support of the messenger wire at each mast."""

    vertical_stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] = Field(
        description="Vertical stiffness."
    )
    lateral_stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] | None = (
        Field(default=None, description="Stiffness across the track; without it, the vertical one.")
    )
    longitudinal_stiffness: Annotated[float, Unit("N/m", minimum=0, maximum=extremes.STIFFNESS)] = (
        Field(default=0.0, description="Stiffness along the track.")
    )
    vertical_damping: Annotated[float, Unit("N s/m", minimum=0, maximum=extremes.DAMPING)] = Field(
        default=0.0, description="Vertical damping."
    )
    mass: Annotated[float, Unit("kg", minimum=0, maximum=extremes.MASS)] = Field(
        default=0.0, description="Moving mass."
    )


class SteadyArmSpring(Part):
    """A steady arm reduced to a vertical spring."""

    kind: Literal["spring"] = Field(default="spring", description="Kind of steady arm.")
    vertical_stiffness: Annotated[float, Unit("N/m", minimum=0, maximum=extremes.STIFFNESS)] = (
        Field(description="Vertical stiffness at the contact wire.")
    )
    vertical_damping: Annotated[float, Unit("N s/m", minimum=0, maximum=extremes.DAMPING)] = Field(
        default=0.0, description="Vertical damping at the contact wire."
    )
    mass: Annotated[float, Unit("kg", minimum=0, maximum=extremes.MASS)] = Field(
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
    mass: Annotated[float, Unit("kg/m", minimum=0, maximum=extremes.MASS_PER_METRE)] = Field(
        default=0.0, description="Mass per metre."
    )
    axial_stiffness: Annotated[float, Unit("N", above=0, maximum=extremes.AXIAL_STIFFNESS)] = Field(
        default=17e6,
        description="Axial stiffness EA; default assumed (aluminium, 250 mm²).",
    )


class NoSteadyArm(Part):
    """No steady arm: at the supports nothing holds the contact wire, it hangs on its droppers."""

    kind: Literal["none"] = Field(description="Kind of steady arm.")


SteadyArm = Annotated[SteadyArmSpring | SteadyArmBar | NoSteadyArm, Field(discriminator="kind")]
