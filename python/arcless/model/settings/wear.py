"""The wear of contact wire or collector strip: coefficients of a heuristic model of three parts."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from arcless.model.fields.list_checks import check_count, check_increasing
from arcless.model.fields.part import Part, Unit

Force = Annotated[float, Unit("N", above=0, maximum=2000)]
Factor = Annotated[float, Unit("1", minimum=0)]


class MechanicalWear(Part):
    """The part of friction: k₁ (½(1 + I/I₀))^(−α) (F_m/F₀)^β F_m/H."""

    factor: Factor = Field(description="k₁.")
    reference_current: Annotated[float, Unit("A", above=0)] = Field(description="I₀.")
    reference_force: Force = Field(description="F₀.")
    current_exponent: Annotated[float, Unit("1", minimum=-10, maximum=10)] = Field(
        description="α; above 0 a current makes the surface slide better."
    )
    force_exponent: Annotated[float, Unit("1", above=-1, maximum=10)] = Field(
        description="β, beyond the proportion to the force."
    )


class PowerLaw(Part):
    """The contact resistance as a power of the force: R = R_r (F_m/F_r)^(−n)."""

    kind: Literal["power"] = Field(description="Power law.")
    reference_resistance: Annotated[float, Unit("Ohm", minimum=0)] = Field(
        description="R_r, the resistance at the reference force."
    )
    reference_force: Force = Field(description="F_r.")
    exponent: Annotated[float, Unit("1", minimum=0, maximum=10)] = Field(
        description="n; 0 for a constant resistance."
    )


class ResistanceTable(Part):
    """The contact resistance over the force, linear between points; no value beyond them."""

    kind: Literal["table"] = Field(description="Table.")
    force: tuple[Annotated[float, Unit("N", minimum=0, maximum=2000)], ...] = Field(
        description="Mean contact forces, rising.", min_length=2, max_length=1000
    )
    resistance: tuple[Annotated[float, Unit("Ohm", minimum=0)], ...] = Field(
        description="Contact resistance at each."
    )

    @model_validator(mode="after")
    def _check_lists(self) -> "ResistanceTable":
        check_count(self.resistance, len(self.force), "force", ("resistance",))
        check_increasing(self.force, "N", "force", "forces")
        return self


class JouleWear(Part):
    """The part of the current through the contact: k₂ R(F_m) I²/(H V)."""

    factor: Factor = Field(description="k₂.")
    resistance: Annotated[PowerLaw | ResistanceTable, Field(discriminator="kind")] = Field(
        description="Contact resistance R over the mean contact force."
    )


class ArcWear(Part):
    """The part of arcs: k₃ u V_a I/(V H_m ρ), u the share of time without contact."""

    factor: Factor = Field(description="k₃.")
    voltage: Annotated[float, Unit("V", minimum=0)] = Field(description="V_a, of an arc.")
    melting_heat: Annotated[float, Unit("J/kg", above=0)] = Field(
        description="H_m, latent heat of fusion of what wears."
    )
    density: Annotated[float, Unit("kg/m3", above=0)] = Field(description="ρ of what wears.")


class WearModel(Part):
    """The wear of a contact wire or a collector strip."""

    body: Literal["contact wire", "collector strip"] = Field(
        description="What the coefficients are of."
    )
    illustrative: bool = Field(
        default=False,
        strict=True,
        description="Whether the coefficients only show how the model works; every assessment says"
        " so then.",
    )
    current: Annotated[float, Unit("A", minimum=0, maximum=1e5)] = Field(
        description="I, that each pantograph collects."
    )
    hardness: Annotated[float, Unit("Pa", above=0)] = Field(description="H of what wears.")
    mechanical: MechanicalWear = Field(description="The part of friction.")
    joule: JouleWear = Field(description="The part of the current through the contact.")
    arc: ArcWear = Field(description="The part of arcs.")
