"""The schemes that step in time, and their parameters."""

from typing import Annotated, Final, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields.part import Part, Unit

# The scheme that steps without a matrix.
EXPLICIT: Final = "central-difference"
# The one that suits the line: arcless.model.scenario.stepping.
AUTOMATIC: Final = "auto"


class Auto(Part):
    """Explicit steps where the line allows them, otherwise generalised-alpha."""

    name: Literal["auto"] = Field(description="Name of the scheme.")


class GeneralisedAlpha(Part):
    """Generalised-alpha scheme (Chung and Hulbert)."""

    name: Literal["generalised-alpha"] = Field(description="Name of the scheme.")
    spectral_radius: Annotated[float, Unit("1", minimum=0, maximum=1)] = Field(
        default=0.9, description="Spectral radius at infinite frequency; 1 damps nothing."
    )


class HilberHughesTaylor(Part):
    """Hilber-Hughes-Taylor scheme."""

    name: Literal["hht"] = Field(description="Name of the scheme.")
    alpha: Annotated[float, Unit("1", minimum=-1 / 3, maximum=0)] = Field(
        default=-0.05, description="Damping parameter, from -1/3 to 0 (none)."
    )


class Newmark(Part):
    """Newmark scheme, unconditionally stable members only."""

    name: Literal["newmark"] = Field(description="Name of the scheme.")
    beta: Annotated[float, Unit("1", minimum=0.25, maximum=1)] = Field(
        default=0.25, description="Newmark's beta."
    )
    gamma: Annotated[float, Unit("1", minimum=0.5, maximum=1)] = Field(
        default=0.5, description="Newmark's gamma; above 0.5 damps and is of first order."
    )

    @model_validator(mode="after")
    def _check_stable(self) -> "Newmark":
        lowest = (self.gamma + 0.5) ** 2 / 4
        if self.beta < lowest - 1e-12:
            raise ModelError(
                "not unconditionally stable",
                got=f"{self.beta:g}",
                expected=f"at least (gamma + 1/2)²/4 = {lowest:g}",
                field=("beta",),
            )
        return self


class Trapezoidal(Part):
    """Trapezoidal rule: conserves energy."""

    name: Literal["trapezoidal"] = Field(description="Name of the scheme.")


class BackwardDifference(Part):
    """Backward differences for velocity and acceleration: first order, dissipative."""

    name: Literal["backward-difference"] = Field(description="Name of the scheme.")


class CentralDifference(Part):
    """Central differences: explicit, for wires of point masses with linearised kinematics."""

    name: Literal["central-difference"] = Field(description="Name of the scheme.")


Scheme = Annotated[
    Auto
    | GeneralisedAlpha
    | HilberHughesTaylor
    | Newmark
    | Trapezoidal
    | BackwardDifference
    | CentralDifference,
    Field(discriminator="name"),
]
