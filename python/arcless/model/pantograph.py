"""A pantograph: a chain of masses, springs and dampers from base to head, or given by matrices."""

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.documents import Document
from arcless.model.fields import Unit
from arcless.model.force_tables import LiftTable
from arcless.model.joint import Joint
from arcless.model.matrices import MAX_COORDINATES, PantographMatrices

MAX_MASSES = MAX_COORDINATES


class PantographMass(Joint):
    """A mass of the chain, with what joins it to the mass below."""

    mass: Annotated[float, Unit("kg", above=0)] = Field(description="Mass.")
    stiffness: Annotated[float, Unit("N/m", minimum=0)] | None = Field(
        default=None, description="Spring to the mass below, or to the base frame."
    )
    damping: Annotated[float, Unit("N s/m", minimum=0)] | None = Field(
        default=None, description="Damper to the mass below, or to the base frame."
    )
    aerodynamic: Annotated[float, Unit("N/(m/s)2")] = Field(
        default=0.0,
        description="Upward aerodynamic force on this mass over speed squared.",
    )
    lift: LiftTable | None = Field(
        default=None, description="Upward force on this mass over speed; excludes aerodynamic."
    )

    @model_validator(mode="after")
    def _check_given_once(self) -> "PantographMass":
        if self.lift is not None and self.aerodynamic != 0.0:
            raise ModelError(
                "both aerodynamic and lift given", expected="aerodynamic or lift", field=("lift",)
            )
        for name in ("stiffness", "damping"):
            number, table = getattr(self, name), getattr(self, f"{name}_table")
            if number is not None and table is not None:
                raise ModelError(
                    f"both {name} and {name}_table given",
                    expected=f"{name} or {name}_table",
                    field=(f"{name}_table",),
                )
            if number is None and table is None:
                expected = f"{self._expected(name)}, or {name}_table"
                raise ModelError("missing field", expected=expected, field=(name,))
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
            tables = sum(
                table.raising(self.matrices.rigid, speed) for table in self.matrices.lift_tables
            )
            return self.matrices.lift_over_squared_speed * speed**2 + tables
        tables = sum(part.lift.at(speed) for part in self.masses if part.lift is not None)
        return sum(part.aerodynamic for part in self.masses) * speed**2 + tables
