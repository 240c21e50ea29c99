"""Tables of a pantograph: force over elongation, over velocity, over speed."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Annotated, Any

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields.list_checks import check_count, check_increasing
from arcless.model.fields.part import Part, Path, Unit
from arcless.model.files.csv_tables import Table, read_table
from arcless.model.files.yaml_reader import Origin
from arcless.model.settings.run_settings import MAX_SPEED

MAX_TABLE = 1000
LEAST_POINTS = 2
# Tables of a joint, and the columns of a CSV file with one.
COLUMNS = {
    "stiffness_table": Table({"elongation": "m", "force": "N"}),
    "damping_table": Table({"velocity": "m/s", "force": "N"}),
}
Forces = tuple[Annotated[float, Unit("N", minimum=-1e6, maximum=1e6)], ...]
File = Annotated[
    str | None,
    Field(description="CSV file with the points, relative to this file; read when it is loaded."),
]


class StiffnessTable(Part):
    """A table of a spring: force over elongation, linear between its points."""

    file: File = None
    elongation: tuple[Annotated[float, Unit("m", minimum=-10, maximum=10)], ...] = Field(
        default=(),
        description="Elongations from where the spring is unstrained, increasing.",
        max_length=MAX_TABLE,
    )
    force: Forces = Field(
        default=(), description="Force at each elongation, positive when it pulls; not falling."
    )

    @model_validator(mode="after")
    def _check(self) -> "StiffnessTable":
        _check_points(self.elongation, self.force, "elongation", "m")
        return self

    @property
    def points(self) -> list[tuple[float, float]]:
        """Elongations in m and forces in N."""
        return list(zip(self.elongation, self.force, strict=True))


class DampingTable(Part):
    """A table of a damper: force over velocity, linear between its points."""

    file: File = None
    velocity: tuple[Annotated[float, Unit("m/s", minimum=-100, maximum=100)], ...] = Field(
        default=(),
        description="Velocities of elongation, increasing, with 0 between the first and last.",
        max_length=MAX_TABLE,
    )
    force: Forces = Field(
        default=(), description="Force at each velocity, not falling; 0 at velocity 0."
    )

    @model_validator(mode="after")
    def _check(self) -> "DampingTable":
        _check_points(self.velocity, self.force, "velocity", "m/s")
        for (v, f), (faster, stronger) in pairwise(self.points):
            if v <= 0 <= faster:
                at_rest = f + (stronger - f) * (0 - v) / (faster - v)
                if abs(at_rest) <= 1e-9 * (abs(f) + abs(stronger)):
                    return self
                got = f"{at_rest:g} N"
                break
        else:
            got = f"{self.velocity[0]:g} to {self.velocity[-1]:g} m/s"
        raise ModelError(
            "no force of zero at velocity 0",
            got=got,
            expected="a damper that is without force at rest",
            hint="give the table the point 0 m/s with 0 N; what holds at rest is friction",
            field=("force",),
        )

    @property
    def points(self) -> list[tuple[float, float]]:
        """Velocities in m/s and forces in N."""
        return list(zip(self.velocity, self.force, strict=True))


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
        check_count(self.force, len(self.speed), "speed", ("force",))
        check_increasing(self.speed, "m/s", "speed", "speeds")
        return self

    def at(self, speed: float) -> float:
        """Return the force in N at a speed in m/s that the table covers."""
        last = len(self.speed) - 2
        k = min(last, max(0, sum(known <= speed for known in self.speed) - 1))
        left, right = self.speed[k : k + 2]
        share = (speed - left) / (right - left)
        return (1.0 - share) * self.force[k] + share * self.force[k + 1]


def _check_points(
    places: tuple[float, ...], forces: tuple[float, ...], name: str, unit: str
) -> None:
    if len(places) < LEAST_POINTS:
        raise ModelError(
            "too few points",
            got=f"{len(places)}",
            expected=f"at least {LEAST_POINTS} of {name} and force, or a file",
            field=(name,),
        )
    check_count(forces, len(places), name, ("force",))
    check_increasing(places, unit, name, "points", f"{name} that increases")
    for index, (before, after) in enumerate(pairwise(forces), start=1):
        if after < before:
            raise ModelError(
                "falling force",
                got=f"{after:g} N after {before:g} N",
                expected=f"a force that does not fall while {name} grows",
                hint="with a falling force the motion would not be unique",
                field=("force", index),
            )


def with_force_tables(data: Mapping[str, Any], origin: Origin, prefix: Path) -> dict[str, Any]:
    """Return the data of a pantograph with the CSV files of its tables read."""
    found = dict(data)
    if isinstance(data.get("masses"), (list, tuple)):
        found["masses"] = _joints(data["masses"], origin, (*prefix, "masses"))
    matrices = data.get("matrices")
    if isinstance(matrices, Mapping) and isinstance(matrices.get("joints"), (list, tuple)):
        path = (*prefix, "matrices", "joints")
        found["matrices"] = {**matrices, "joints": _joints(matrices["joints"], origin, path)}
    return found


def _joints(items: Any, origin: Origin, path: Path) -> list[Any]:
    return [
        _joint(item, origin, (*path, index)) if isinstance(item, Mapping) else item
        for index, item in enumerate(items)
    ]


def _joint(item: Mapping[str, Any], origin: Origin, path: Path) -> dict[str, Any]:
    """Read the files of one joint; points that are there come from an earlier load."""
    found = dict(item)
    for field, table in COLUMNS.items():
        data = item.get(field)
        if not isinstance(data, Mapping):
            continue
        name = data.get("file")
        name = name.get("value") if isinstance(name, Mapping) else name
        if isinstance(name, str) and not any(data.get(column) for column in table.columns):
            with origin.referring((*path, field, "file")):
                found[field] = {**data, **read_table(origin.file(name), table)}
    return found
