"""Schedules of a line at rest: droppers for the workshop, loads and heights of supports."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.errors import ModelError, OutputError
from arcless.mesh import SPATIAL
from arcless.storage.csv_files import Column
from arcless.units import show, to_si

if TYPE_CHECKING:
    from arcless.equilibrium.initial_configuration import InitialConfiguration

# Digits after the point, by unit: a tenth of what a workshop cuts and a fitter measures.
DECIMALS = {"m": 4, "N": 1}
# Largest allowance in m. Loops and clamps of both ends take centimetres to decimetres; with more,
# 30 mm given as 30 m would pass, with less some fittings would not.
MOST_ALLOWANCE = 1.0


def allowance(given: float | str, where: str = "allowance") -> float:
    """Return the allowance of droppers in m, of a number in m or a text with its unit.

    Parameters
    ----------
    given
        As given; a text without a unit could be mm as well as m.
    where
        Name of it, for the message.

    Raises
    ------
    ModelError
        It is no length with a unit, is negative, or longer than fittings are.
    """
    try:
        length = to_si(given, "m")
    except ModelError as error:
        error.where = where
        raise
    said = show(given) if isinstance(given, str) else f"{given:g} m"
    expected = f'a length from 0 to {MOST_ALLOWANCE:g} m with its unit, such as "30 mm"'
    if isinstance(given, str) and not _has_unit(given):
        raise ModelError("length without a unit", where=where, got=said, expected=expected)
    if length < 0.0:
        raise ModelError("negative length", where=where, got=said, expected=expected)
    if length > MOST_ALLOWANCE:
        hint = "loops, thimbles and clamps of one dropper take centimetres to decimetres"
        raise ModelError(
            "longer than the fittings of a dropper",
            where=where, got=said, expected=expected, hint=hint,
        )  # fmt: skip
    return length


def _has_unit(text: str) -> bool:
    """Tell whether a text that is an amount has a unit; `e` may be of an exponent."""
    return any(letter.isalpha() for letter in text.replace("e", "").replace("E", ""))


def check_ending(path: str | Path) -> None:
    """Refuse a name of a schedule that does not end in .csv.

    Raises
    ------
    OutputError
        It has another ending, or none.
    """
    ending = Path(path).suffix
    if ending.lower() != ".csv":
        got = show(ending) if ending else "a name without an ending"
        raise OutputError(
            "not a .csv file", where=str(path), got=got, expected="a name that ends in .csv"
        )


def dropper_schedule(
    line: "InitialConfiguration", allowance_m: float | None = None
) -> list[Column]:
    """Return the droppers of a line at rest, one in a row; with an allowance the lengths to cut.

    Parameters
    ----------
    line
        The line at rest, of `arcless.statics`.
    allowance_m
        Length in m that the fittings of one dropper take beyond the distance of its clamps; the
        cut length is the unstretched length and this. Without it there is no cut length.

    Raises
    ------
    ModelError
        The line has no droppers.
    """
    droppers = line.droppers
    if not droppers:
        name = line.scenario.line.name
        raise ModelError(
            "no dropper schedule", got=f"line `{name}`", expected="a line with droppers"
        )
    columns = [
        *_columns(droppers, {"span": ("span", ""), "name": ("dropper", "")}),
        *_columns(droppers, {"from": ("hangs from", ""), "to": ("holds", "")}),
        *_columns(
            droppers,
            {
                "x_m": ("position", "m"),
                "length_m": ("length between clamps", "m"),
                "unstretched_length_m": ("unstretched length", "m"),
            },
        ),
    ]
    if allowance_m is not None:
        cut = [dropper["unstretched_length_m"] + allowance_m for dropper in droppers]
        columns.append(_column("cut length", "m", cut))
    columns += _columns(droppers, {"force_N": ("force at rest", "N")})
    # The support before a span has the number of the span: both are counted along the track.
    supports = line.equilibrium.support_places()
    along = [dropper["x_m"] - supports[dropper["span"] - 1] for dropper in droppers]
    return [*columns, _column("distance from support", "m", along)]


def support_schedule(line: "InitialConfiguration") -> list[Column]:
    """Return the supports of a line at rest, one in a row: heights, stagger, loads, arm forces.

    Without a messenger wire the load is that of the contact wire or its bridle, and there is no
    height of a messenger wire. Where wires are anchored nothing is held, and the cells of forces
    are empty. Lateral forces, of lines in space, are those of the wires, positive to the left.
    """
    supports, mesh = line.supports, line.equilibrium.mesh
    points, is_spatial = line.equilibrium.positions, mesh.dimension == SPATIAL
    alone = line.scenario.line.messenger_wire is None
    held = "contact_support_force_N" if alone else "messenger_force_N"
    columns = _columns(
        supports,
        {
            "name": ("support", ""),
            "x_m": ("position", "m"),
            "contact_wire_height_m": ("height of contact wire", "m"),
        },
    )
    if is_spatial:
        stagger = [float(points[place.contact_node, 1]) for place in mesh.supports]
        columns.append(_column("stagger", "m", stagger))
    if not alone:
        columns += _columns(
            supports, {"messenger_wire_height_m": ("height of messenger wire", "m")}
        )
    load = "vertical load of contact wire" if alone else "vertical load of messenger wire"
    titles = {held: (load, "N")}
    if is_spatial:
        titles["contact_wire_lateral_force_N"] = ("lateral force of contact wire", "N")
    if is_spatial and not alone:
        titles["messenger_wire_lateral_force_N"] = ("lateral force of messenger wire", "N")
    titles["steady_arm_force_N"] = ("steady-arm force", "N")
    return [*columns, *_columns(supports, titles)]


def _columns(
    rows: Sequence[Mapping[str, Any]], titles: Mapping[str, tuple[str, str]]
) -> list[Column]:
    """Return entries of rows as columns of these names and units."""
    return [_column(name, unit, [row[key] for row in rows]) for key, (name, unit) in titles.items()]


def _column(name: str, unit: str, values: Sequence[Any]) -> Column:
    return Column(name, unit, values, DECIMALS.get(unit))
