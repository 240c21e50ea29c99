"""A pantograph that is an FMU: the file, and which of its variables is which."""

from collections.abc import Iterator
from typing import Annotated, Any, NamedTuple

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.part import Name, Part, Unit

MAX_STRIPS = 8
_DIGITS = 64
Variable = Annotated[Name, Field(min_length=1)]
Variables = Annotated[tuple[Variable, ...], Field(min_length=1, max_length=MAX_STRIPS)]


class Role(NamedTuple):
    """Role of a variable of an FMU for a pantograph."""

    unit: str
    """SI unit."""
    causalities: tuple[str, ...]
    """Causalities that a variable in this role may have."""


INPUT, OUTPUT, START = ("input",), ("output",), ("parameter", "input")
ROLES = {
    "contact_force": Role("N", INPUT),
    "strip_height": Role("m", OUTPUT),
    "static_force": Role("N", START),
    "start_height": Role("m", START),
    "base_height": Role("m", INPUT),
    "base_velocity": Role("m/s", INPUT),
    "speed": Role("m/s", INPUT),
    "track_position": Role("m", INPUT),
    "control_force": Role("N", INPUT),
}


class PantographFmu(Part):
    """A pantograph of another program, as an FMU for co-simulation (FMI 2.0 or 3.0)."""

    file: str = Field(description="The FMU, relative to this file.", min_length=1)
    sha256: str | None = Field(
        default=None,
        description="SHA-256 of the file in hexadecimal digits: another file is refused. It is"
        " found when the file is loaded, and results keep it.",
        pattern=f"^[0-9a-f]{{{_DIGITS}}}$",
    )
    contact_force: Variables = Field(
        default=("contact_force",),
        description="Input of the contact force, positive when it pushes the strip down; a list,"
        " one for each strip, where there are several.",
    )
    strip_height: Variables = Field(
        default=("strip_height",),
        description="Output of the height of the strip; a list, one for each strip, where there"
        " are several.",
    )
    strip_offset: tuple[Annotated[float, Unit("m", minimum=-5, maximum=5)], ...] = Field(
        default=(),
        description="How far each strip stands behind the reference point of the pantograph; only"
        " of several.",
        max_length=MAX_STRIPS,
    )
    static_force: Variable | None = Field(
        default=None,
        description="Parameter or input that is given the static force; needed for mean_force.",
    )
    start_height: Variable | None = Field(
        default=None,
        description="Parameter or input that is given the height of the wire above the rails at"
        " the start; without it heights count from where the FMU starts.",
    )
    base_height: Variable | None = Field(
        default=None, description="Input of the height of the roof; needed for roof_motion."
    )
    base_velocity: Variable | None = Field(
        default=None, description="Input of the vertical velocity of the roof."
    )
    speed: Variable | None = Field(default=None, description="Input of the speed of the train.")
    track_position: Variable | None = Field(
        default=None, description="Input of the position of the pantograph along the line."
    )
    control_force: Variable | None = Field(
        default=None, description="Input of a controlled force; needed for controller."
    )
    parameters: dict[str, float] = Field(
        default_factory=dict,
        description="Values of further parameters by their names, each in the unit that the FMU"
        " gives it.",
    )
    assume_units: bool = Field(
        default=False,
        description="Whether variables to which the FMU gives no unit are taken as SI; they are"
        " refused without.",
    )
    strip_mass: Annotated[float, Unit("kg", above=0, maximum=extremes.MASS)] | None = Field(
        default=None,
        description="Mass of a strip that the contact force accelerates; only of an FMU whose"
        " state cannot be saved, and needed there.",
    )
    time_limit: Annotated[float, Unit("s", above=0, maximum=86_400)] = Field(
        default=30.0,
        description="Time that the FMU may take for its start and for each step; a longer one"
        " counts as hanging.",
    )

    @model_validator(mode="before")
    @classmethod
    def _take_single_names(cls, data: Any) -> Any:
        """Take one name as a list of one."""
        if not isinstance(data, dict):
            return data
        lists = ("contact_force", "strip_height")
        return {k: (v,) if k in lists and isinstance(v, str) else v for k, v in data.items()}

    @model_validator(mode="after")
    def _check_lists(self) -> "PantographFmu":
        strips = len(self.strip_height)
        if len(self.contact_force) != strips:
            raise ModelError(
                "wrong number of names",
                got=f"{len(self.contact_force)}",
                expected=f"{strips}, one for each strip_height",
                field=("contact_force",),
            )
        wanted = strips if strips > 1 else 0
        if len(self.strip_offset) not in (wanted, strips):
            raise ModelError(
                "wrong number of values",
                got=f"{len(self.strip_offset)}",
                expected=f"{strips}, one for each strip",
                hint="two strips at one place would touch the wire at one point",
                field=("strip_offset",),
            )
        if len(set(self.strip_offset)) < len(self.strip_offset):
            raise ModelError(
                "two strips at one place",
                got=", ".join(f"{x:g} m" for x in self.strip_offset),
                expected="a different offset for each strip",
                field=("strip_offset",),
            )
        self._check_roles()
        return self

    def _check_roles(self) -> None:
        """Refuse a variable in two roles."""
        seen: dict[str, str] = {}
        for field, _, name in self.used():
            if name in seen:
                raise ModelError(
                    "a variable in two roles",
                    got=f"{name} as {seen[name]} and {field}",
                    expected="a variable for each",
                    field=(field,),
                )
            seen[name] = field
        for name in self.parameters:
            if name in seen:
                raise ModelError(
                    "a variable in two roles",
                    got=f"{name} as {seen[name]} and in parameters",
                    expected="a variable for each",
                    field=("parameters", name),
                )

    @property
    def strips(self) -> int:
        """Number of strips."""
        return len(self.strip_height)

    @property
    def offsets(self) -> tuple[float, ...]:
        """Distance of each strip behind the reference point, m."""
        return self.strip_offset or (0.0,)

    def used(self) -> Iterator[tuple[str, Role, str]]:
        """Yield field, role and name of each variable that is mapped."""
        for field, role in ROLES.items():
            given = getattr(self, field)
            names = given if isinstance(given, tuple) else () if given is None else (given,)
            for name in names:
                yield field, role, name
