"""Joints between two masses of a pantograph, beyond a linear spring and damper."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.part import Part, Unit
from arcless.model.pantograph.force_tables import DampingTable, StiffnessTable

RIGID = "rigid"


class BumpStops(Part):
    """Bump stops: they end the motion of a mass against the mass below it."""

    below: Annotated[float, Unit("m", minimum=0, maximum=10)] | None = Field(
        default=None, description="Way down to the lower stop at the start of a run; none without."
    )
    above: Annotated[float, Unit("m", minimum=0, maximum=10)] | None = Field(
        default=None, description="Way up to the upper stop at the start of a run; none without."
    )
    stiffness: Annotated[
        float | Literal["rigid"],
        Unit("N/m", above=0, maximum=extremes.STIFFNESS, words=(RIGID,)),
    ] = Field(description="Stiffness of a stop, or rigid.")

    @model_validator(mode="after")
    def _check(self) -> "BumpStops":
        if self.below is None and self.above is None:
            raise ModelError("no stop", expected="below, above or both", field=("below",))
        if self.below is not None and self.above is not None and self.stiffness == RIGID:
            raise ModelError(
                "rigid stops on both sides",
                got="below and above",
                expected="one of them, or a stiffness",
                hint="the forces of two rigid stops that block one motion are not unique",
                field=("stiffness",),
            )
        return self


class Friction(Part):
    """Dry friction: a force against the motion, whatever its size."""

    force: Annotated[float, Unit("N", above=0, maximum=10_000)] = Field(
        description="Friction force of sliding."
    )
    sliding_speed: Annotated[float, Unit("m/s", minimum=1e-6, maximum=1)] = Field(
        default=1e-3, description="Speed from which on it slides; slower it creeps."
    )

    @property
    def points(self) -> list[tuple[float, float]]:
        """The law as the table of a damper: velocities in m/s and forces in N."""
        v, f = self.sliding_speed, self.force
        return [(-2.0 * v, -f), (-v, -f), (v, f), (2.0 * v, f)]


class Joint(Part):
    """Joint between a mass and the mass below it: stops, tables and friction."""

    stiffness_table: StiffnessTable | None = Field(
        default=None, description="Spring with a table: force over elongation."
    )
    damping_table: DampingTable | None = Field(
        default=None, description="Damper with a table: force over velocity."
    )
    friction: Friction | None = Field(default=None, description="Dry friction; none without.")
    stops: BumpStops | None = Field(
        default=None, description="Stops against the mass below, or against the base frame."
    )
