"""A pantograph: a chain of masses from base to head, given by matrices, or an FMU."""

from pathlib import PurePath
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from arcless.display import cards
from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.document import Document
from arcless.model.fields.part import Unit
from arcless.model.fields.rule_errors import both_given, missing
from arcless.model.fmu.mapping import PantographFmu
from arcless.model.pantograph.force_tables import LiftTable
from arcless.model.pantograph.head import CollectorHead
from arcless.model.pantograph.joint import Joint
from arcless.model.pantograph.matrices import MAX_COORDINATES, PantographMatrices

MAX_MASSES = MAX_COORDINATES


class PantographMass(Joint):
    """A mass of the chain, with what joins it to the mass below."""

    mass: Annotated[float, Unit("kg", above=0, maximum=extremes.MASS)] = Field(description="Mass.")
    stiffness: Annotated[float, Unit("N/m", minimum=0, maximum=extremes.STIFFNESS)] | None = Field(
        default=None, description="Spring to the mass below, or to the base frame."
    )
    damping: Annotated[float, Unit("N s/m", minimum=0, maximum=extremes.DAMPING)] | None = Field(
        default=None, description="Damper to the mass below, or to the base frame."
    )
    aerodynamic: Annotated[
        float, Unit("N/(m/s)2", minimum=-extremes.AERODYNAMIC, maximum=extremes.AERODYNAMIC)
    ] = Field(
        default=0.0,
        description="Upward aerodynamic force on this mass over speed squared.",
    )
    lift: LiftTable | None = Field(
        default=None, description="Upward force on this mass over speed; excludes aerodynamic."
    )

    @model_validator(mode="after")
    def _check_given_once(self) -> "PantographMass":
        if self.lift is not None and self.aerodynamic != 0.0:
            raise both_given("aerodynamic", "lift")
        for name in ("stiffness", "damping"):
            number, table = getattr(self, name), getattr(self, f"{name}_table")
            if number is not None and table is not None:
                raise both_given(name, f"{name}_table")
            if number is None and table is None:
                expected = f"{self._expected(name)}, or {name}_table"
                raise missing(name, expected=expected)
        return self


# Lateral position allowed by the width of the head over its horns, both in m: S11 of the shipped
# models (course notes on UNE-EN 50367), mark A.
LATERAL_LIMITS = {1.6: 0.4, 1.95: 0.55}


def lateral_limit(given: float | None, head_width: float | None) -> float | None:
    """Return a lateral range in m: the one given, or what the width of the head in m allows."""
    return given if given is not None else LATERAL_LIMITS.get(round(head_width or 0.0, 3))


class Pantograph(Document):
    """A pantograph: a chain of masses from base to head, a linear system, or an FMU."""

    format: Literal["arcless-pantograph/1"] = Field(
        default="arcless-pantograph/1", description="Format and version."
    )
    masses: tuple[PantographMass, ...] = Field(
        default=(), description="Masses from base to head.", max_length=MAX_MASSES
    )
    matrices: PantographMatrices | None = Field(
        default=None, description="General linear pantograph; excludes masses."
    )
    fmu: PantographFmu | None = Field(
        default=None,
        description="Pantograph of another program; excludes masses and matrices.",
        json_schema_extra={"or_file": True},
    )
    head: CollectorHead | None = Field(
        default=None, description="Strips on the last mass; without it, the last mass is the strip."
    )
    half_length: Annotated[float, Unit("m", above=0, maximum=2)] | None = Field(
        default=None,
        description="Half of the length over which the strip can touch a wire; none: no limit.",
    )
    head_width: Annotated[float, Unit("m", minimum=0.5, maximum=3)] | None = Field(
        default=None, description="Width of the collector head over its horns, across the track."
    )
    lateral_range: Annotated[float, Unit("m", above=0, maximum=1.5)] | None = Field(
        default=None,
        description="How far from the middle of the head the contact wire may run; 0.40 m for a"
        " head_width of 1.60 m and 0.55 m for one of 1.95 m if not given.",
    )
    static_force: Annotated[float, Unit("N", above=0, maximum=2000)] | None = Field(
        default=None, description="Static force, used when a scenario gives no force."
    )

    def in_words(self) -> list[str]:
        """Return of how many masses or coordinates it is, in words."""
        if self.fmu is not None:
            return [f"FMU {PurePath(self.fmu.file).name}"]
        if self.matrices is not None:
            return [f"matrices, {self.size} coordinates"]
        count = len(self.masses)
        return [f"{count} {'mass' if count == 1 else 'masses'}"]

    def _repr_html_(self) -> str:
        force, width = self.static_force, self.head_width
        kind = f"{self.in_words()[0]}{'' if self.head is None else ', collector head with strips'}"
        lateral = "" if self.lateral_limit is None else f"{self.lateral_limit:g} m"
        rows = [
            ("Model", kind),
            ("Static force", "" if force is None else f"{force:g} N"),
            ("Width of the collector head", "" if width is None else f"{width:g} m"),
            ("Lateral range of the contact wire", lateral),
        ]
        titles = ("mass", "mass, kg", "stiffness below, N/m", "damping below, N s/m")
        masses = [
            (str(place), f"{one.mass:g}", _number(one.stiffness), _number(one.damping))
            for place, one in enumerate(self.masses, start=1)
        ]
        shown = [cards.table(titles, masses, numbers=titles)] if masses else []
        title = f"Pantograph {self.name}"
        return cards.card(title, cards.facts(rows), *shown, about=self.description)

    @property
    def lateral_limit(self) -> float | None:
        """Lateral range of the contact wire from the middle of the head, m; None if not known."""
        return lateral_limit(self.lateral_range, self.head_width)

    @classmethod
    def prepare(cls, data: dict[str, Any]) -> dict[str, Any]:
        """Take masses that are nothing as masses left out, and a text as the file of an FMU."""
        found = {key: value for key, value in data.items() if key != "masses" or value is not None}
        if isinstance(found.get("fmu"), str):
            found["fmu"] = {"file": found["fmu"]}
        return found

    @model_validator(mode="after")
    def _check_kind(self) -> "Pantograph":
        kinds = ("masses", "matrices", "fmu")
        given = [name for name in kinds if getattr(self, name)]
        if len(given) > 1:
            raise both_given(given[0], given[1])
        if not given:
            raise missing("masses", expected="masses, from base to head, or matrices, or fmu")
        if self.head is not None and not self.masses:
            raise ModelError(
                f"a head on {'matrices' if self.fmu is None else 'an FMU'}",
                expected=f"masses below the head, or {given[0]} that contain it",
                field=("head",),
            )
        if self.head is not None and self.half_length is not None:
            raise ModelError(
                "half_length given twice",
                expected="that of the head alone",
                field=("half_length",),
            )
        return self

    @property
    def size(self) -> int:
        """Number of coordinates: masses and those of the strips, or what the matrices have.

        Of an FMU the heights of its strips.
        """
        if self.fmu is not None:
            return self.fmu.strips
        if self.matrices is not None:
            return len(self.matrices.strip)
        return len(self.masses) + (0 if self.head is None else self.head.size)

    @property
    def raised(self) -> tuple[float, ...]:
        """Coordinates of the whole pantograph raised by 1 m."""
        if self.fmu is not None:
            return (1.0,) * self.fmu.strips
        if self.matrices is not None:
            return self.matrices.rigid
        strips = () if self.head is None else self.head.raised
        return (1.0,) * len(self.masses) + strips

    @property
    def heights(self) -> list[int]:
        """Coordinates that are displacements of a mass: not roll angles, not modes of strips."""
        if self.matrices is not None:
            return list(range(self.size))
        return [i for i, value in enumerate(self.raised) if value]

    @property
    def rolls(self) -> list[int]:
        """Coordinates that are the roll angles of strips."""
        if self.head is None or self.head.roll is None:
            return []
        first = len(self.masses) + 1
        return [first + number * self.head.strip_size for number in range(self.head.strips)]

    def lift_at(self, speed: float) -> float:
        """Return the share of the contact force in N that the air carries at a speed in m/s.

        Of an FMU it is not known, and taken as a part of the static force.
        """
        if self.matrices is not None:
            tables = sum(
                table.raising(self.matrices.rigid, speed) for table in self.matrices.lift_tables
            )
            return self.matrices.lift_over_squared_speed * speed**2 + tables
        tables = sum(part.lift.at(speed) for part in self.masses if part.lift is not None)
        squared = sum(part.aerodynamic for part in self.masses)
        if self.head is not None:
            squared += self.head.strips * self.head.aerodynamic
        return squared * speed**2 + tables


def _number(value: float | None) -> str:
    """Return a spring or a damper as text, where it is a number."""
    return "table" if value is None else f"{value:g}"
