"""Stress of the contact wire as tables."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from arcless.cli.terminal.tables import number, table

if TYPE_CHECKING:
    from rich.console import RenderableType

    from arcless.assess.wire_stress import WireStress

# Rows of the table; all places are in the JSON.
MOST = 20


def stress_tables(found: "WireStress") -> "Iterator[RenderableType]":
    """Yield the wire, then the places with the largest ranges."""
    from arcless.assess.wire_stress.tables import by_range, equivalent_range, order

    told = found.to_dict()
    made = table("Contact wire", "quantity", "unit", "value", numbers=("value",))
    made.add_row("tension", "N", number(told["tension_N"], 0))
    made.add_row(f"area, {told['area_from']}", "mm²", number(told["area_mm2"], 1))
    made.add_row("distance of the outer fibre", "mm", number(told["half_height_mm"], 2))
    made.add_row("Young's modulus", "GPa", number(told["modulus_GPa"], 1))
    made.add_row("axial stress T/A", "MPa", number(told["axial_stress_MPa"], 1))
    yield made
    shown = by_range(told)[:MOST]
    columns = ("at rest", "min.", "max.", "range", "cycles")  # a row fits 80 characters
    more = () if found.exponent is None else ("S_eq",)
    title = f"Stress in MPa, {len(shown)} of {len(found.places)} fibres, {order(told)}"
    places = table(title, "place and fibre", *columns, *more, numbers=(*columns, *more))
    keys = ["at_rest_MPa", "min_MPa", "max_MPa", "largest_range_MPa", "cycles"]
    if found.exponent is not None:
        keys.append("equivalent_range_MPa")
    for one in shown:
        places.add_row(f"{one['name']}, {one['fibre']}", *(number(one[key], 1) for key in keys))
    yield places
    if found.exponent is not None:
        yield equivalent_range(told) + "\n"
