"""Schedules of a line at rest: droppers for the workshop, loads and heights of supports."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from arcless.errors import ModelError
from arcless.mesh import SPATIAL
from arcless.storage.csv_files import Column

if TYPE_CHECKING:
    from arcless.equilibrium.initial_configuration import InitialConfiguration

# Digits after the point, by unit: a tenth of what a workshop cuts and a fitter measures.
DECIMALS = {"m": 4, "N": 1}


def dropper_schedule(line: "InitialConfiguration", allowance_m: float = 0.0) -> list[Column]:
    """Return the droppers of a line at rest, one in a row, with the lengths to cut.

    Parameters
    ----------
    line
        The line at rest, of `arcless.statics`.
    allowance_m
        Length in m that the fittings of one dropper take beyond the distance of its clamps; the
        cut length is the unstretched length and this.

    Raises
    ------
    ModelError
        The line has no droppers, or the allowance is negative.
    """
    if allowance_m < 0.0:
        raise ModelError("allowance", got=f"{allowance_m:g} m", expected="0 m or more")
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
    cut = [dropper["unstretched_length_m"] + allowance_m for dropper in droppers]
    force = _columns(droppers, {"force_N": ("force at rest", "N")})
    return [*columns, _column("cut length", "m", cut), *force]


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
