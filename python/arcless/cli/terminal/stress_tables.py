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
    told = found.to_dict()
    made = table("Contact wire", "quantity", "unit", "value", numbers=("value",))
    made.add_row("tension", "N", number(told["tension_N"], 0))
    made.add_row(f"area, {told['area_from']}", "mm²", number(told["area_mm2"], 1))
    made.add_row("distance of the outer fibre", "mm", number(told["half_height_mm"], 2))
    made.add_row("Young's modulus", "GPa", number(told["modulus_GPa"], 1))
    made.add_row("axial stress T/A", "MPa", number(told["axial_stress_MPa"], 1))
    yield made
    by_range = sorted(
        found.places, key=lambda one: one.equivalent_range_MPa or one.largest_range_MPa
    )
    shown = by_range[::-1][:MOST]
    columns = ("x / m", "at rest / MPa", "minimum", "maximum", "largest range", "cycles")
    more = () if found.exponent is None else (f"equivalent range, m = {found.exponent:g}",)
    title = f"Largest ranges of stress, {len(shown)} of {len(found.places)} fibres"
    places = table(title, "place", "fibre", *columns, *more, numbers=(*columns, *more))
    for one in shown:
        places.add_row(
            one.name, one.fibre, number(one.x_m, 2), number(one.at_rest_MPa, 1),
            number(one.min_MPa, 1), number(one.max_MPa, 1), number(one.largest_range_MPa, 1),
            number(one.cycles, 1),
            *(() if found.exponent is None else (number(one.equivalent_range_MPa, 1),)),
        )  # fmt: skip
    yield places
