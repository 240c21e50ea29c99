"""Settings of a run: speed profile, contact law, solver, output."""

from typing import Annotated, Any, Final, Literal, TypeAlias

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.list_checks import check_count, check_increasing
from arcless.model.fields.part import Lengths, Part, Unit
from arcless.model.settings.schemes import AUTOMATIC, EXPLICIT, Auto, Scheme
from arcless.units import WRONG_VALUE

# 1080 km/h: above any train, and a speed in km/h written without its unit is often above it.
MAX_SPEED = 300.0
# In m/s, 576 km/h. No train on rails was faster (574.8 km/h, France, 2007).
FASTEST_TRAIN = 160.0
MAX_PROFILE = 50_000
# The time step in which the collector moves by one element of the contact wire.
ONE_ELEMENT: Final = "one element"
# Recorded parts of the line: all of it, or all where that is not too much.
WHOLE_LINE: Final = "whole line"
# Settings that follow from other ones.
AUTO: Final = "auto"
WireModel: TypeAlias = Literal["hermite", "lumped"]
# Elements in m of a line that is divided without a scenario, whose speed they follow from.
LONGEST: Final = 0.725
ElementLength: TypeAlias = Annotated[
    float | Literal["auto"], Unit("m", minimum=0.05, maximum=20, words=(AUTO,))
]


class SpeedProfile(Part):
    """Speed over time, linear between the given points."""

    time: tuple[Annotated[float, Unit("s", minimum=0, maximum=extremes.TIME)], ...] = Field(
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
        check_increasing(self.time, "s", "time", "times")
        return self


class Contact(Part):
    """The contact between collector strip and contact wire."""

    law: Literal["compliant", "rigid"] = Field(default="compliant", description="Contact law.")
    stiffness: Annotated[float, Unit("N/m", above=0, maximum=extremes.STIFFNESS)] = Field(
        default=50e3, description="Stiffness of the compliant law."
    )
    friction_coefficient: Annotated[float, Unit("1", minimum=0, maximum=2)] = Field(
        default=0.0, description="Friction along the wire."
    )


class Solver(Part):
    """Solver settings: scheme, wire model, elements and time step."""

    time_step: Annotated[
        float | Literal["auto", "one element"],
        Unit("s", minimum=1e-5, maximum=0.05, words=(AUTO, ONE_ELEMENT)),
    ] = Field(
        default="auto",
        description="Time step; auto: 1 ms, less where explicit steps or the speed need it; one"
        " element: that in which the first pantograph moves by contact_wire_element.",
    )
    scheme: Scheme = Field(
        default_factory=lambda: Auto(name=AUTOMATIC),
        description="Time-stepping scheme: its name, or its name and parameters; auto:"
        f" {EXPLICIT} where the line allows it, otherwise generalised-alpha.",
    )
    period_correction: bool = Field(
        default=True,
        strict=True,
        description="Take the period error of the scheme from the mass of wires of cubic elements;"
        " no effect with schemes of first order and point masses.",
    )
    residual_flexibility: Annotated[bool, Field(strict=True)] | Literal["auto"] = Field(
        default="auto",
        description="Add what wires yield under droppers, supports and contacts beyond their"
        " elements: with linearised kinematics and cubic elements; explicit steps always have it."
        " auto: wherever it can be.",
    )
    kinematics: Literal["linearised", "updated"] = Field(
        default="linearised",
        description="Motion about the static equilibrium, or node coordinates and stiffness"
        " updated in each step.",
    )
    motion: Literal["full", "across"] = Field(
        default="full",
        description="What of the line moves: all, or across the track only (up, and to the side"
        " in space), with the tensions of the line at rest, as in programs that know no motion"
        " along the wires; the statics are the same.",
    )
    wire_model: Literal["auto", "hermite", "lumped"] = Field(
        default="auto",
        description="Wire elements: cubic with slopes, or point masses on a chain; auto: hermite,"
        f" but lumped with the scheme {EXPLICIT}.",
    )
    dimension: Literal["auto", "planar", "spatial"] = Field(
        default="auto", description="Planar or spatial; auto decides by stagger and steady arms."
    )
    contact_wire_element: ElementLength = Field(
        default="auto",
        description="Longest element of the contact wire; auto: from the shortest wave that counts,"
        " at most 0.45 m of point masses, 0.725 m of cubic elements.",
    )
    messenger_wire_element: ElementLength = Field(
        default="auto",
        description="Longest element of all other wires; auto: likewise.",
    )
    gravity: Annotated[float, Unit("m/s2", minimum=0, maximum=100)] = Field(
        default=9.81, description="Acceleration of gravity."
    )

    @model_validator(mode="after")
    def _check_explicit(self) -> "Solver":
        if self.scheme.name != EXPLICIT:
            return self
        if isinstance(self.residual_flexibility, bool) and not self.residual_flexibility:
            raise ModelError(
                f"not together with the scheme {EXPLICIT}",
                got="false",
                expected="auto or true, or another scheme",
                hint="explicit steps always have it",
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
    def _check_motion(self) -> "Solver":
        if self.motion == "across" and self.kinematics != "linearised":
            raise ModelError(
                "not together with motion: across",
                got=self.kinematics,
                expected="linearised, or motion: full",
                hint="tensions then stay those at rest; updated ones follow what moves",
                field=("kinematics",),
            )
        return self

    @model_validator(mode="after")
    def _check_flexibility(self) -> "Solver":
        wanted = isinstance(self.residual_flexibility, bool) and self.residual_flexibility
        if not wanted or self.scheme.name == EXPLICIT:
            return self
        for key, value, needed in (
            ("wire_model", self.wires, "hermite"),
            ("kinematics", self.kinematics, "linearised"),
        ):
            if value != needed:
                raise ModelError(
                    "not together with residual_flexibility",
                    got=value,
                    expected=f"{needed}, or residual_flexibility: auto",
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
        """Wire model, also where it follows from a scheme that is given."""
        if self.wire_model != AUTO:
            return self.wire_model
        return "lumped" if self.scheme.name == EXPLICIT else "hermite"

    @property
    def contact_wire_element_m(self) -> float:
        """Longest element of the contact wire in m; where it is left to auto, see `LONGEST`."""
        given = self.contact_wire_element
        return LONGEST if isinstance(given, str) else given

    @property
    def messenger_wire_element_m(self) -> float:
        """Longest element of all other wires in m; where it is left to auto, see `LONGEST`."""
        given = self.messenger_wire_element
        return LONGEST if isinstance(given, str) else given


class RecordedMotion(Part):
    """Recorded motion of the wires near the pantographs: how often, and how far around them."""

    interval: Annotated[
        float | Literal["auto"], Unit("s", minimum=1e-4, maximum=1, words=(AUTO,))
    ] = Field(
        default="auto",
        description="Time between two records, in whole steps; auto: 10 ms, five in a period of"
        " 20 Hz, the cut-off of the contact force, but 20 ms in runs of 100 000 steps and more.",
    )
    around: Annotated[
        float | Literal["whole line"], Unit("m", above=0, maximum=1e6, words=(WHOLE_LINE,))
    ] = Field(
        default=200.0,
        description="How far before the first and behind the last pantograph; at most what"
        " output.around leaves of a long line.",
    )


class Output(Part):
    """Output settings: quantities that are recorded, and their rate."""

    contact_every: int = Field(
        default=1, ge=1, le=10_000, strict=True, description="Steps between records of the contact."
    )
    line_every: int = Field(
        default=5, ge=1, le=10_000, strict=True, description="Steps between records of the line."
    )
    droppers: bool = Field(default=True, strict=True, description="Record dropper forces.")
    supports: bool = Field(
        default=True,
        strict=True,
        description="Record at supports uplift, forces, force and angle of steady arms.",
    )
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
        description="Energy ledger; auto: for explicit steps, of which one in 500 is measured, and"
        " for the trapezoidal scheme, which conserves energy; always: of every step; none with"
        " updated kinematics.",
    )
    points: Annotated[Lengths, Field(max_length=1000)] = Field(
        default=(), description="Points of the contact wire whose uplift is recorded."
    )
    motion: RecordedMotion | None = Field(
        default=None,
        description="Record the motion of all wires near the pantographs, for pictures of it: true,"
        " or interval and around; none without.",
    )

    @model_validator(mode="before")
    @classmethod
    def _motion_by_word(cls, data: Any) -> Any:
        if isinstance(data, dict) and isinstance(data.get("motion"), bool):
            return {**data, "motion": {} if data["motion"] else None}
        return data
