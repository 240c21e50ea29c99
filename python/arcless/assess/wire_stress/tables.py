"""Stress of a wire, given as plain data: a line of words, a card for notebooks, a data frame."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from arcless.display import cards
from arcless.display.frames import frame
from arcless.display.numbers import number
from arcless.storage.csv_files import Column

if TYPE_CHECKING:
    import pandas

T = TypeVar("T")
# Rows of the card; all places are in the data frame.
MOST = 20
_EQUIVALENT = "equivalent_range_MPa"
# Key of a place → title and unit of its column in the data frame.
_COLUMNS = {
    "name": ("place", ""),
    "x_m": ("position", "m"),
    "fibre": ("fibre", ""),
    "at_rest_MPa": ("stress at rest", "MPa"),
    "min_MPa": ("smallest stress", "MPa"),
    "max_MPa": ("largest stress", "MPa"),
    "largest_range_MPa": ("largest range", "MPa"),
    "cycles": ("cycles", ""),
    _EQUIVALENT: ("equivalent range S_eq", "MPa"),
}
# Key of a place → title of its column in the card; stresses are in MPa.
_SHORT = {
    "at_rest_MPa": "at rest",
    "min_MPa": "min.",
    "max_MPa": "max.",
    "largest_range_MPa": "range",
    "cycles": "cycles",
    _EQUIVALENT: "S_eq",
}


def range_key(exponent: float | None) -> str:
    """Return the key of the range by which places are compared."""
    return "largest_range_MPa" if exponent is None else _EQUIVALENT


def by_range(told: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the places, the largest equivalent range first; without an exponent the largest."""
    key = range_key(told["exponent"])
    return sorted(told["places"], key=lambda one: float(one[key]), reverse=True)


def order(told: Mapping[str, Any]) -> str:
    """Return words on the order of `by_range`."""
    return "largest range first" if told["exponent"] is None else "largest S_eq first"


def equivalent_range(told: Mapping[str, Any]) -> str:
    """Return a sentence on S_eq, the equivalent range, in two lines; empty without an exponent."""
    if told["exponent"] is None:
        return ""
    return (
        "S_eq is the range of one cycle per passage that does the damage of all cycles\n"
        f"(m = {told['exponent']:g}); with several cycles it may exceed the largest range."
    )


def in_words(told: Mapping[str, Any]) -> str:
    """Return the number of fibres, the section and the worst place, on one line."""
    begin, end = told["section_m"]
    worst, exponent = by_range(told)[0], told["exponent"]
    value = f"{number(worst[range_key(exponent)])} MPa"
    most = f"range {value}" if exponent is None else f"S_eq {value} (m = {exponent:g})"
    return (
        f"{len(told['places'])} fibres in {number(begin)} to {number(end)} m: "
        f"largest {most} at {worst['name']}, {worst['fibre']}"
    )


def data_frame(told: Mapping[str, Any]) -> "pandas.DataFrame":
    """Return the places along the track; see `WireStress.to_dataframe`."""
    columns = [
        Column(title, unit, [one[key] for one in told["places"]])
        for key, (title, unit) in _known(_COLUMNS, told).items()
    ]
    return frame({"fibres": lambda: columns}, "fibres")


def card(told: Mapping[str, Any]) -> str:
    """Return the wire and the places with the largest ranges as HTML."""
    shown, titles = by_range(told)[:MOST], _known(_SHORT, told)
    rows = [
        [f"{one['name']}, {one['fibre']}", *(number(one[key]) for key in titles)] for one in shown
    ]
    wire = cards.facts(
        [
            ("tension", f"{number(told['tension_N'], 0)} N"),
            (f"area, {told['area_from']}", f"{number(told['area_mm2'])} mm²"),
            ("Young's modulus", f"{number(told['modulus_GPa'])} GPa"),
            ("axial stress T/A", f"{number(told['axial_stress_MPa'])} MPa"),
        ]
    )
    words = [
        f"Stress in MPa, {len(shown)} of {len(told['places'])} fibres, {order(told)}",
        equivalent_range(told),
        *told["notes"],
    ]
    numbers = list(titles.values())
    return cards.card(
        f"Stress of the contact wire: {in_words(told)}",
        wire,
        cards.listed([text for text in words if text]),
        cards.table(["place and fibre", *numbers], rows, numbers=numbers),
    )


def _known(titles: Mapping[str, T], told: Mapping[str, Any]) -> dict[str, T]:
    """Return titles without that of the equivalent range where there is none."""
    return {
        key: title
        for key, title in titles.items()
        if key != _EQUIVALENT or told["exponent"] is not None
    }
