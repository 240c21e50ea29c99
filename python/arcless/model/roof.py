"""Vertical motion of the vehicle's roof, over time or along the line, from a list or a CSV file."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Annotated, Any

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import Part, Path, Unit, nearest
from arcless.model.reader import Origin, read_text
from arcless.units import KINDS, accepted, show, spell, to_si

MAX_POINTS = 50_000
# Fields that hold points, and the SI unit of each.
COLUMNS = {"time": "s", "position": "m", "displacement": "m"}


class RoofMotion(Part):
    """The vertical motion of the roof that a pantograph stands on."""

    file: str | None = Field(
        default=None,
        description="CSV file with the points, relative to this file; read when it is loaded.",
    )
    time: tuple[Annotated[float, Unit("s")], ...] | None = Field(
        default=None, description="Times since the start of the run.", max_length=MAX_POINTS
    )
    position: tuple[Annotated[float, Unit("m")], ...] | None = Field(
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
            raise ModelError(
                "both time and position given", expected="time or position", field=("position",)
            )
        if self.time is None and self.position is None:
            raise ModelError(
                "missing field", expected="time or position, or a file", field=("time",)
            )
        name = self.over
        if not self.points[1:]:
            raise ModelError(
                "too few points", got=f"{len(self.points)}", expected="at least 2", field=(name,)
            )
        if len(self.displacement) != len(self.points):
            raise ModelError(
                "wrong number of values",
                got=f"{len(self.displacement)} values",
                expected=f"{len(self.points)}, one for each of {name}",
                field=("displacement",),
            )
        unit = COLUMNS[name]
        for index, (earlier, later) in enumerate(pairwise(self.points), start=1):
            if later <= earlier:
                raise ModelError(
                    "points out of order",
                    got=f"{later:g} {unit} after {earlier:g} {unit}",
                    expected=f"a {name} that increases",
                    field=(name, index),
                )
        return self

    @property
    def over(self) -> str:
        """What the points stand over: time or position."""
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
    if not isinstance(name, str) or any(data.get(column) for column in COLUMNS):
        return data
    file = origin.folder / name
    with origin.referring((*path, "file")):
        columns = read_columns(read_text(file, str(file)), str(file))
    empty = dict.fromkeys(COLUMNS)
    return {**data, **{key: value for key, value in {**empty, **columns}.items() if value}}


def read_columns(text: str, label: str) -> dict[str, list[float]]:
    """Return the columns of a CSV text in SI.

    The first line names the columns with their units, ``time [s], displacement [mm]``; empty lines
    and lines that begin with # are left out.
    """
    lines = [
        (number, [cell.strip() for cell in line.split(",")])
        for number, line in enumerate(text.splitlines(), start=1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if not lines:
        expected = "a first line such as: time [s], displacement [mm]"
        raise ModelError("empty file", where=label, expected=expected)
    (first, titles), *rows = lines
    heads = [_column(title, f"{label}:{first}") for title in titles]
    names = [name for name, _ in heads]
    _check_names(names, f"{label}:{first}")
    if len(rows) > MAX_POINTS:
        expected = f"at most {MAX_POINTS}"
        raise ModelError("too many points", where=label, got=str(len(rows)), expected=expected)
    out: dict[str, list[float]] = {name: [] for name in names}
    for number, cells in rows:
        where = f"{label}:{number}"
        if len(cells) != len(heads):
            hint = "a decimal point, not a comma" if len(cells) > len(heads) else "a gap?"
            raise ModelError(
                "wrong number of values",
                where=where,
                got=str(len(cells)),
                expected=f"{len(heads)}, one for each column",
                hint=hint,
            )
        for (name, unit), cell in zip(heads, cells, strict=True):
            out[name].append(_number(cell, name, unit, where))
    return out


def _column(title: str, where: str) -> tuple[str, str]:
    """Return name and unit of a column from its title."""
    name, bracket, rest = (part.strip() for part in title.partition("["))
    unit = rest.removesuffix("]").strip()
    if name not in COLUMNS:
        raise ModelError(
            "unknown column",
            where=where,
            got=show(title),
            expected="time or position, and displacement, each with its unit",
            hint=nearest(name, list(COLUMNS)),
        )
    if not bracket or not rest.endswith("]") or not unit:
        raise ModelError(
            f"column {name} without unit",
            where=where,
            got=show(title),
            expected=f"{accepted(COLUMNS[name])} in brackets",
            hint=f"for example {name} [{spell(next(iter(KINDS[COLUMNS[name]].units)))}]",
        )
    _number("1", name, unit, where)
    return name, unit


def _check_names(names: list[str], where: str) -> None:
    for name in names:
        if names.count(name) > 1:
            raise ModelError(
                "column given twice", where=where, got=show(name), expected="each column once"
            )
    if "displacement" not in names or ("time" in names) == ("position" in names):
        raise ModelError(
            "wrong columns",
            where=where,
            got=", ".join(names),
            expected="time or position, and displacement",
        )


def _number(cell: str, name: str, unit: str, where: str) -> float:
    try:
        if not cell or not cell.lstrip("+-.")[:1].isdigit():
            raise ModelError("", got=show(cell), expected="a number")
        return to_si(f"{cell} {unit}", COLUMNS[name])
    except ModelError as error:
        raise ModelError(
            f"column {name}",
            where=where,
            got=show(cell) if error.got is None else error.got,
            expected=error.expected,
            hint=error.hint,
        ) from None
