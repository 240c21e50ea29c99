"""Vertical motion of the vehicle's roof, over time or along the line, from a list or a CSV file."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Annotated, Any

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.list_checks import check_count
from arcless.model.fields.part import Part, Path, Unit
from arcless.model.fields.rule_errors import both_given, missing
from arcless.model.files.csv_tables import Table, read_table
from arcless.model.files.yaml_reader import Origin

MAX_POINTS = 50_000
# In s or m; closer points are a step, and a curve through them has slopes beyond all reason.
CLOSEST = 1e-6
# Fields that hold points, and columns of a file.
POINTS = Table({"time": "s", "position": "m", "displacement": "m"}, either=("time", "position"))


class RoofMotion(Part):
    """The vertical motion of the roof that a pantograph stands on."""

    file: str | None = Field(
        default=None,
        description="CSV file with the points, relative to this file; read when it is loaded.",
    )
    time: (
        tuple[Annotated[float, Unit("s", minimum=-extremes.TIME, maximum=extremes.TIME)], ...]
        | None
    ) = Field(default=None, description="Times since the start of the run.", max_length=MAX_POINTS)
    position: (
        tuple[Annotated[float, Unit("m", minimum=-extremes.PLACE, maximum=extremes.PLACE)], ...]
        | None
    ) = Field(
        default=None,
        description="Positions of the pantograph along the line; excludes time.",
        max_length=MAX_POINTS,
    )
    displacement: tuple[Annotated[float, Unit("m", minimum=-1, maximum=1)], ...] = Field(
        default=(), description="Height of the roof at each point, upwards, from any level."
    )

    @model_validator(mode="after")
    def _check_lists(self) -> "RoofMotion":
        if self.time is not None and self.position is not None:
            raise both_given("time", "position")
        if self.time is None and self.position is None:
            raise missing("time", expected="time or position, or a file")
        name = self.over
        if not self.points[1:]:
            raise ModelError(
                "too few points", got=f"{len(self.points)}", expected="at least 2", field=(name,)
            )
        check_count(self.displacement, len(self.points), name, ("displacement",))
        unit = POINTS.columns[name]
        for index, (earlier, later) in enumerate(pairwise(self.points), start=1):
            if later - earlier < CLOSEST:
                raise ModelError(
                    "points out of order" if later <= earlier else "points too close together",
                    got=f"{later:.12g} {unit} after {earlier:.12g} {unit}",
                    expected=f"a {name} that increases, by at least {CLOSEST:g} {unit}",
                    field=(name, index),
                )
        return self

    @property
    def over(self) -> str:
        """Axis that the points stand over: time or position."""
        return "position" if self.time is None else "time"

    @property
    def points(self) -> tuple[float, ...]:
        """Times in s or positions in m."""
        return self.time or self.position or ()


def with_points(data: dict[str, Any], origin: Origin, path: Path) -> dict[str, Any]:
    """Return the data of a roof motion with the points of its file, if it names one.

    Points that are there already come from that file, by an earlier load.
    """
    name = data.get("file")
    name = name.get("value") if isinstance(name, Mapping) else name
    if not isinstance(name, str) or any(data.get(column) for column in POINTS.columns):
        return data
    with origin.referring((*path, "file")):
        columns = read_table(origin.file(name), POINTS)
    return {**data, **dict.fromkeys(POINTS.columns), **columns}
