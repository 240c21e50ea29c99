"""A pantograph: a chain of masses, springs and dampers from base to head, or given by matrices."""

from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.documents import Document
from arcless.model.fields import Part, Unit
from arcless.model.matrices import MAX_COORDINATES, PantographMatrices
from arcless.model.settings import MAX_SPEED

MAX_MASSES = MAX_COORDINATES
MAX_TABLE = 1000
RIGID = "rigid"


class LiftTable(Part):
    """A table of the upward force over speed, linear between its points."""

    speed: tuple[Annotated[float, Unit("m/s", minimum=0, maximum=MAX_SPEED)], ...] = Field(
        description="Speeds, increasing.", min_length=2, max_length=MAX_TABLE
    )
    force: tuple[Annotated[float, Unit("N", minimum=-10_000, maximum=10_000)], ...] = Field(
        description="Upward force at each speed."
    )

    @model_validator(mode="after")
    def _check_lists(self) -> "LiftTable":
        if len(self.force) != len(self.speed):
            raise ModelError(
                "wrong number of values",
                got=f"{len(self.force)} values",
                expected=f"{len(self.speed)}, one for each of speed",
                field=("force",),
            )
        for index, (slower, faster) in enumerate(pairwise(self.speed), start=1):
            if faster <= slower:
                raise ModelError(
                    "speeds out of order",
                    got=f"{faster:g} m/s after {slower:g} m/s",
                    expected="speeds that increase",
                    field=("speed", index),
                )
        return self

    def at(self, speed: float) -> float:
        """Return the force in N at a speed in m/s that the table covers."""
        last = len(self.speed) - 2
        k = min(last, max(0, sum(known <= speed for known in self.speed) - 1))
        left, right = self.speed[k : k + 2]
        share = (speed - left) / (right - left)
        return (1.0 - share) * self.force[k] + share * self.force[k + 1]


class BumpStops(Part):
    """What ends the motion of a mass against what is below it."""

    below: Annotated[float, Unit("m", minimum=0, maximum=10)] | None = Field(
        default=None, description="Way down to the lower stop at the start of a run; none without."
    )
    above: Annotated[float, Unit("m", minimum=0, maximum=10)] | None = Field(
        default=None, description="Way up to the upper stop at the start of a run; none without."
    )
    stiffness: Annotated[float | Literal["rigid"], Unit("N/m", above=0, words=(RIGID,))] = Field(
        description="Stiffness of a stop, or rigid."
    )

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
    lift: LiftTable | None = Field(
        default=None, description="Upward force on this mass over speed; excludes aerodynamic."
    )
    stops: BumpStops | None = Field(
        default=None, description="Stops against the mass below, or against the base frame."
    )

    @model_validator(mode="after")
    def _check_lift(self) -> "PantographMass":
        if self.lift is not None and self.aerodynamic != 0.0:
            raise ModelError(
                "both aerodynamic and lift given", expected="aerodynamic or lift", field=("lift",)
            )
        return self


class Pantograph(Document):
    """A pantograph: a chain of masses from base to head, or a linear system given by matrices."""

    format: Literal["arcless-pantograph/1"] = Field(
        default="arcless-pantograph/1", description="Format and version."
    )
    masses: tuple[PantographMass, ...] = Field(
        default=(), description="Masses from base to head.", max_length=MAX_MASSES
    )
    matrices: PantographMatrices | None = Field(
        default=None, description="General linear pantograph; excludes masses."
    )
    static_force: Annotated[float, Unit("N", above=0, maximum=2000)] | None = Field(
        default=None, description="Static force, used when a scenario gives no force."
    )

    @classmethod
    def prepare(cls, data: dict[str, Any]) -> dict[str, Any]:
        """Take masses that are nothing as masses left out."""
        return {key: value for key, value in data.items() if key != "masses" or value is not None}

    @model_validator(mode="after")
    def _check_kind(self) -> "Pantograph":
        if self.masses and self.matrices is not None:
            raise ModelError(
                "both masses and matrices given", expected="masses or matrices", field=("matrices",)
            )
        if not self.masses and self.matrices is None:
            raise ModelError(
                "missing field",
                expected="masses, from base to head, or matrices",
                field=("masses",),
            )
        return self

    @property
    def size(self) -> int:
        """Number of masses, or of coordinates when it is given by matrices."""
        return len(self.masses) if self.matrices is None else len(self.matrices.strip)

    def lift_at(self, speed: float) -> float:
        """Return the share of the contact force in N that the air carries at a speed in m/s."""
        if self.matrices is not None:
            return self.matrices.lift_over_squared_speed * speed**2
        tables = sum(part.lift.at(speed) for part in self.masses if part.lift is not None)
        return sum(part.aerodynamic for part in self.masses) * speed**2 + tables
