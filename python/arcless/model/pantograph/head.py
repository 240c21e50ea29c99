"""A collector head: its strips, each on a suspension of its own, that roll and bend."""

from typing import Annotated

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.list_checks import check_count, check_increasing
from arcless.model.fields.part import Part, Unit

MAX_STRIPS = 4
MAX_MODES = 8
MAX_SHAPE = 200
# A spline needs this many points to be cubic.
FEWEST_SHAPE_POINTS = 4


class StripRoll(Part):
    """Roll of a strip about the direction of travel, against the last mass of the chain."""

    inertia: Annotated[float, Unit("kg m2", above=0, maximum=1e4)] = Field(
        description="Moment of inertia of a strip about its middle."
    )
    stiffness: Annotated[float, Unit("N m/rad", above=0, maximum=extremes.ANGULAR_STIFFNESS)] = (
        Field(description="Roll stiffness of its suspension; two springs k/2 at ±b give k b².")
    )
    damping: Annotated[float, Unit("N m s/rad", minimum=0, maximum=extremes.ANGULAR_DAMPING)] = (
        Field(default=0.0, description="Roll damping of its suspension.")
    )


class StripMode(Part):
    """A bending mode of a strip."""

    frequency: Annotated[float, Unit("Hz", above=0, maximum=1e4)] = Field(
        description="Natural frequency."
    )
    modal_mass: Annotated[float, Unit("kg", above=0, maximum=extremes.MASS)] = Field(
        description="Modal mass that belongs to the shape as written."
    )
    damping_ratio: Annotated[float, Unit("1", minimum=0, below=1)] = Field(
        default=0.0, description="Share of critical damping."
    )
    shape: tuple[Annotated[float, Unit("1", minimum=-1e3, maximum=1e3)], ...] = Field(
        description="Upward displacement at each of shape_positions.", max_length=MAX_SHAPE
    )


class CollectorHead(Part):
    """A collector head: equal strips one behind the other, each suspended from the last mass."""

    strips: int = Field(
        default=2, ge=1, le=MAX_STRIPS, strict=True, description="Number of equal strips."
    )
    strip_spacing: Annotated[float, Unit("m", above=0, maximum=5)] | None = Field(
        default=None, description="Distance between one strip and the next; none for one strip."
    )
    half_length: Annotated[float, Unit("m", above=0, maximum=2)] = Field(
        description="Half of the length over which a strip can touch a wire."
    )
    mass: Annotated[float, Unit("kg", above=0, maximum=extremes.MASS)] = Field(
        description="Mass of each strip."
    )
    stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] = Field(
        description="Suspension of each strip from the last mass."
    )
    damping: Annotated[float, Unit("N s/m", minimum=0, maximum=extremes.DAMPING)] = Field(
        description="Damping of the suspension of each strip."
    )
    aerodynamic: Annotated[
        float, Unit("N/(m/s)2", minimum=-extremes.AERODYNAMIC, maximum=extremes.AERODYNAMIC)
    ] = Field(default=0.0, description="Upward aerodynamic force on each strip over speed squared.")
    roll: StripRoll | None = Field(
        default=None, description="Roll of each strip; without it, strips stay level."
    )
    shape_positions: tuple[Annotated[float, Unit("m", minimum=-2, maximum=2)], ...] | None = Field(
        default=None,
        description="Places across the track, from the middle, at which mode shapes are given.",
        max_length=MAX_SHAPE,
    )
    modes: tuple[StripMode, ...] = Field(
        default=(), description="Bending modes of each strip.", max_length=MAX_MODES
    )

    @model_validator(mode="after")
    def _check(self) -> "CollectorHead":
        if (self.strips > 1) != (self.strip_spacing is not None):
            raise ModelError(
                "strip spacing",
                got="none" if self.strip_spacing is None else f"{self.strip_spacing:g} m",
                expected="a distance" if self.strips > 1 else "none for a single strip",
                field=("strip_spacing",),
            )
        if bool(self.modes) != (self.shape_positions is not None):
            raise ModelError(
                "modes and shape_positions belong together",
                got="modes alone" if self.modes else "shape_positions alone",
                expected="both, or neither",
                field=("shape_positions",),
            )
        if self.shape_positions is not None:
            self._check_shapes(self.shape_positions)
        return self

    def _check_shapes(self, places: tuple[float, ...]) -> None:
        if len(places) < FEWEST_SHAPE_POINTS:
            raise ModelError(
                "too few points of a mode shape",
                got=str(len(places)),
                expected=f"at least {FEWEST_SHAPE_POINTS}",
                field=("shape_positions",),
            )
        check_increasing(places, "m", "shape_positions", "positions")
        if places[0] > -self.half_length or places[-1] < self.half_length:
            raise ModelError(
                "the mode shapes do not reach over the strip",
                got=f"{places[0]:g} m to {places[-1]:g} m",
                expected=f"at least {-self.half_length:g} m to {self.half_length:g} m",
                field=("shape_positions",),
            )
        for index, mode in enumerate(self.modes):
            field = ("modes", index, "shape")
            check_count(mode.shape, len(places), "shape_positions", field)
            if not any(mode.shape):
                raise ModelError(
                    "a mode without a shape",
                    got="zeros",
                    expected="a value",
                    field=field,
                )

    @property
    def size(self) -> int:
        """Number of coordinates of all strips: height, roll angle, and one for each mode."""
        return self.strips * self.strip_size

    @property
    def strip_size(self) -> int:
        """Number of coordinates of one strip."""
        return 1 + (self.roll is not None) + len(self.modes)

    @property
    def raised(self) -> tuple[float, ...]:
        """Coordinates of all strips raised by 1 m: heights, not angles and modes."""
        return (1.0, *(0.0,) * (self.strip_size - 1)) * self.strips

    def offsets(self) -> tuple[float, ...]:
        """Return how far each strip runs behind the middle of the pantograph, m; first in front."""
        spacing = self.strip_spacing or 0.0
        return tuple((k - 0.5 * (self.strips - 1)) * spacing for k in range(self.strips))
