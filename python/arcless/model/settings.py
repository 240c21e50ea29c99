"""How a run moves, computes and records: speed profile, contact law, solver, output."""

from itertools import pairwise
from typing import Annotated, Any, Final, Literal, NamedTuple, TypeAlias

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import Lengths, Part, Unit
from arcless.model.lists import check_count
from arcless.model.schemes import EXPLICIT, GeneralisedAlpha, Scheme
from arcless.units import WRONG_VALUE

# 1080 km/h: above any train, and a speed in km/h written without its unit is often above it.
MAX_SPEED = 300.0
MAX_PROFILE = 50_000
# The time step in which the collector moves by one element of the contact wire.
ONE_ELEMENT: Final = "one element"
# What is recorded of the line: all of it, or all where that is not too much.
WHOLE_LINE: Final = "whole line"
# What follows from other settings.
AUTO: Final = "auto"
WireModel: TypeAlias = Literal["hermite", "lumped"]
ElementLength: TypeAlias = Annotated[
    float | Literal["auto"], Unit("m", minimum=0.05, maximum=20, words=(AUTO,))
]


class Division(NamedTuple):
    """How wires are divided: wire model, longest elements of contact and messenger wire in m."""

    wires: WireModel
    contact_wire: float
    messenger_wire: float


# What `auto` stands for. Explicit steps are those of point masses, and need so many of them to be
# as right as cubic elements.
BY_MATRIX = Division("hermite", 1.45, 2.9)
BY_STEPS = Division("lumped", 0.45, 0.6)


class SpeedProfile(Part):
    """Speed over time, linear between the given points."""

    time: tuple[Annotated[float, Unit("s", minimum=0)], ...] = Field(
        description="Times, the first one 0.", min_length=2, max_length=MAX_PROFILE
    )
    speed: tuple[Annotated[float, Unit("m/s", minimum=0, maximum=MAX_SPEED)], ...] = Field(
        description="Speed at each time."
    )

    @model_validator(mode="after")
    def _check_lists(self) -> "SpeedProfile":
        check_count(self.speed, len(self.time), "time", ("speed",))
        if self.time[0] != 0:
            raise ModelError(
                WRONG_VALUE,
                got=f"{self.time[0]:g} s",
                expected="0 s as the first time",
                field=("time", 0),
            )
        for index, (earlier, later) in enumerate(pairwise(self.time), start=1):
            if later <= earlier:
                raise ModelError(
                    "times out of order",
                    got=f"{later:g} s after {earlier:g} s",
                    expected="times that increase",
                    field=("time", index),
                )
        return self


class Contact(Part):
    """The contact between collector strip and contact wire."""

    law: Literal["compliant", "rigid"] = Field(default="compliant", description="Contact law.")
    stiffness: Annotated[float, Unit("N/m", above=0)] = Field(
        default=50e3, description="Stiffness of the compliant law."
    )
    friction_coefficient: Annotated[float, Unit("1", minimum=0, maximum=2)] = Field(
        default=0.0, description="Friction along the wire."
    )


class Solver(Part):
    """How the motion is computed."""

    time_step: Annotated[
        float | Literal["one element"],
        Unit("s", minimum=1e-5, maximum=0.05, words=(ONE_ELEMENT,)),
    ] = Field(
        default=1e-3,
        description="Time step; one element: that in which the first pantograph moves by"
        " contact_wire_element.",
    )
    scheme: Scheme = Field(
        default_factory=lambda: GeneralisedAlpha(name="generalised-alpha"),
        description="Time-stepping scheme: its name, or its name and parameters.",
    )
    period_correction: bool = Field(
        default=True,
        strict=True,
        description="Take the period error of the scheme from the mass of wires of cubic elements;"
        " no effect with schemes of first order and point masses.",
    )
    residual_flexibility: bool = Field(
        default=False,
        strict=True,
        description="Add what cubic elements yield too little under droppers, supports and"
        " contacts: with linearised kinematics and wires of cubic elements.",
    )
    kinematics: Literal["linearised", "updated"] = Field(
        default="linearised",
        description="Motion about the static equilibrium, or node coordinates and stiffness"
        " updated in each step.",
    )
    wire_model: Literal["auto", "hermite", "lumped"] = Field(
        default="auto",
        description="Wire elements: cubic with slopes, or point masses on a chain; auto: hermite,"
        f" but lumped with the scheme {EXPLICIT}.",
    )
    dimension: Literal["auto", "planar", "spatial"] = Field(
        default="auto", description="Planar or spatial; auto looks at stagger and steady arms."
    )
    contact_wire_element: ElementLength = Field(
        default="auto",
        description=f"Longest element of the contact wire; auto: {BY_MATRIX.contact_wire:g} m, but"
        f" {BY_STEPS.contact_wire:g} m with the scheme {EXPLICIT}.",
    )
    messenger_wire_element: ElementLength = Field(
        default="auto",
        description=f"Longest element of the messenger wire; auto: {BY_MATRIX.messenger_wire:g} m,"
        f" but {BY_STEPS.messenger_wire:g} m with the scheme {EXPLICIT}.",
    )
    gravity: Annotated[float, Unit("m/s2", minimum=0, maximum=100)] = Field(
        default=9.81, description="Acceleration of gravity."
    )

    @model_validator(mode="after")
    def _check_explicit(self) -> "Solver":
        if self.scheme.name != EXPLICIT:
            return self
        if self.residual_flexibility:
            raise ModelError(
                f"not together with the scheme {EXPLICIT}",
                got="true",
                expected="false, or another scheme",
                hint="it adds what cubic elements miss; explicit steps are those of point masses",
                field=("residual_flexibility",),
            )
        for key, value, needed, hint in (
            ("wire_model", self.wires, "lumped", "leave it out: auto takes what the scheme needs"),
            ("kinematics", self.kinematics, "linearised", None),
        ):
            if value != needed:
                raise ModelError(
                    f"not together with the scheme {EXPLICIT}",
                    got=value,
                    expected=f"{needed}, or another scheme",
                    hint=hint,
                    field=(key,),
                )
        return self

    @model_validator(mode="after")
    def _check_flexibility(self) -> "Solver":
        if not self.residual_flexibility:
            return self
        for key, value, needed in (
            ("wire_model", self.wires, "hermite"),
            ("kinematics", self.kinematics, "linearised"),
        ):
            if value != needed:
                raise ModelError(
                    "not together with residual_flexibility",
                    got=value,
                    expected=f"{needed}, or residual_flexibility: false",
                    field=(key,),
                )
        return self

    @model_validator(mode="before")
    @classmethod
    def _scheme_by_name(cls, data: Any) -> Any:
        if isinstance(data, dict) and isinstance(data.get("scheme"), str):
            return {**data, "scheme": {"name": data["scheme"]}}
        return data

    @property
    def wires(self) -> WireModel:
        """Wire model, also where it follows from the scheme."""
        return self._division.wires if self.wire_model == AUTO else self.wire_model

    @property
    def contact_wire_element_m(self) -> float:
        """Longest element of the contact wire in m, also where it follows from the scheme."""
        given = self.contact_wire_element
        return self._division.contact_wire if isinstance(given, str) else given

    @property
    def messenger_wire_element_m(self) -> float:
        """Longest element of the messenger wire in m, also where it follows from the scheme."""
        given = self.messenger_wire_element
        return self._division.messenger_wire if isinstance(given, str) else given

    @property
    def resolved(self) -> "Solver":
        """The same with nothing left to the scheme: two that are equal then compute alike."""
        return self.model_copy(
            update={
                "wire_model": self.wires,
                "contact_wire_element": self.contact_wire_element_m,
                "messenger_wire_element": self.messenger_wire_element_m,
            }
        )

    @property
    def _division(self) -> Division:
        return BY_STEPS if self.scheme.name == EXPLICIT else BY_MATRIX


class Output(Part):
    """What is recorded, and how often."""

    contact_every: int = Field(
        default=1, ge=1, le=10_000, strict=True, description="Steps between records of the contact."
    )
    line_every: int = Field(
        default=5, ge=1, le=10_000, strict=True, description="Steps between records of the line."
    )
    droppers: bool = Field(default=True, strict=True, description="Record dropper forces.")
    supports: bool = Field(default=True, strict=True, description="Record uplift at supports.")
    around: Annotated[
        float | Literal["auto", "whole line"],
        Unit("m", above=0, maximum=1e6, words=(AUTO, WHOLE_LINE)),
    ] = Field(
        default="auto",
        description="How far before the first and behind the last pantograph droppers and supports"
        " are recorded; auto: the whole line, but 200 m where that is more than 20 million"
        " numbers.",
    )
    energy: Literal["auto", "always", "never"] = Field(
        default="auto",
        description="Energy ledger; auto: for explicit steps, of which one in 200 is measured, and"
        " for the trapezoidal scheme, which conserves energy; always: of every step; none with"
        " updated kinematics.",
    )
    points: Annotated[Lengths, Field(max_length=1000)] = Field(
        default=(), description="Points of the contact wire whose uplift is recorded."
    )
