"""Tables of the page of a line at rest about its wires: sag by span, tension and stress."""

from collections.abc import Mapping, Sequence
from typing import Any

from arcless.display.numbers import number
from arcless.equilibrium.initial_configuration import InitialConfiguration

# Key of a row, title of its column with the unit, decimals.
_SPAN_COLUMNS = (
    ("messenger_wire_sag_below_chord_m", "sag of messenger wire below its chord, m", 4),
    ("messenger_wire_lowest_m", "messenger wire, lowest, m", 4),
    ("contact_wire_sag_below_chord_m", "sag of contact wire below its chord, m", 4),
    ("contact_wire_lowest_m", "contact wire, lowest, m", 4),
    ("contact_wire_highest_m", "contact wire, highest, m", 4),
)
_WIRE_COLUMNS = (
    ("tension_mean_N", "tension, mean, N", 0),
    ("tension_min_N", "minimum, N", 0),
    ("tension_max_N", "maximum, N", 0),
    ("area_mm2", "area, mm²", 1),
    ("stress_mean_MPa", "stress T/A, mean, MPa", 1),
    ("stress_max_MPa", "maximum, MPa", 1),
)


def span_table(found: InitialConfiguration) -> dict[str, Any]:
    """Return titles and rows of the spans, without columns that no span has a value for."""
    rows = found.spans
    several = any(one["tension_length"] for one in rows)
    texts = ["span", *(["tension length"] if several else []), "from, m", "to, m"]
    cells = [
        [
            str(one["span"]), *([one["tension_length"]] if several else []),
            number(one["from_m"], 2), number(one["to_m"], 2),
        ]
        for one in rows
    ]  # fmt: skip
    return _table(texts, cells, rows, _SPAN_COLUMNS, 2 if several else 1)


def wire_table(found: InitialConfiguration) -> dict[str, Any]:
    """Return titles and rows of the wires: tension, area, stress."""
    rows = found.wires
    return _table(["wire"], [[one["wire"].replace("_", " ")] for one in rows], rows, _WIRE_COLUMNS)


def _table(
    texts: Sequence[str],
    cells: Sequence[Sequence[str]],
    rows: Sequence[Mapping[str, Any]],
    columns: Sequence[tuple[str, str, int]],
    left: int = 1,
) -> dict[str, Any]:
    """Return a table; `left` columns are texts, the others numbers."""
    shown = [one for one in columns if any(row[one[0]] is not None for row in rows)]
    filled = [
        [*beginning, *(number(row[key], digits) for key, _, digits in shown)]
        for beginning, row in zip(cells, rows, strict=True)
    ]
    return {"titles": [*texts, *(title for _, title, _ in shown)], "rows": filled, "texts": left}
