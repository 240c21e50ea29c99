"""Sheets that a line is written to and read from, and their columns.

A table holds what changes from place to place along a line. Wires, tensions, supports and arms,
which are the same everywhere, stay in the model file that the table is laid over.
"""

from dataclasses import dataclass
from typing import Literal

from arcless.units import spell

Holds = Literal["number", "whole", "text"]


@dataclass(frozen=True)
class ColumnOf:
    """A column of a sheet.

    Attributes
    ----------
    name
        As in the header, which is the name of the field in model files where there is one.
    holds
        Numbers with a unit, whole numbers from 1, or texts.
    unit
        SI unit of numbers.
    is_needed
        Whether the column must be there, every cell of it filled.
    """

    name: str
    holds: Holds = "number"
    unit: str = ""
    is_needed: bool = True

    @property
    def spelt(self) -> str:
        """The header: name and unit; in brackets where the column may be missing."""
        text = f"{self.name} [{spell(self.unit)}]" if self.unit else self.name
        return text if self.is_needed else f"({text})"


@dataclass(frozen=True)
class Sheet:
    """A sheet of a workbook, or a file of a folder: its name and its columns."""

    name: str
    columns: tuple[ColumnOf, ...]

    @property
    def expected(self) -> str:
        """The columns in words."""
        return f"the columns {', '.join(column.spelt for column in self.columns)}"

    @property
    def by_name(self) -> dict[str, ColumnOf]:
        """Columns by name."""
        return {column.name: column for column in self.columns}


def _whole(name: str, *, is_needed: bool = True) -> ColumnOf:
    return ColumnOf(name, "whole", is_needed=is_needed)


def _text(name: str, *, is_needed: bool = True) -> ColumnOf:
    return ColumnOf(name, "text", is_needed=is_needed)


def _length(name: str, *, is_needed: bool = True) -> ColumnOf:
    return ColumnOf(name, "number", "m", is_needed)


def _hung(sheet: str, number: str) -> Sheet:
    """Return the sheet of what hangs in spans: pre-sag as designed, or lengths as built."""
    either = (_length("presag", is_needed=False), _length("length", is_needed=False))
    own = _whole(number, is_needed=False)
    return Sheet(sheet, (_whole("span"), own, _length("position"), *either))


_MASS = ColumnOf("mass", "number", "kg")
_PLACE = (
    _text("name", is_needed=False),
    _text("wire", is_needed=False),
    _length("position"),
    _whole("tension_length", is_needed=False),
)

SPANS = Sheet("spans", (_whole("span"), _text("type", is_needed=False), _length("length")))
DROPPERS = _hung("droppers", "dropper")
HANGERS = _hung("hangers", "hanger")
SUPPORTS = Sheet(
    "supports",
    (
        _whole("support"),
        _length("contact_wire_height"),
        _length("stagger_contact_wire"),
        _length("stagger_messenger_wire", is_needed=False),
        _length("stagger_auxiliary_wire", is_needed=False),
    ),
)
TENSION_LENGTHS = Sheet("tension_lengths", (_whole("from_span"), _whole("to_span")))
CURVES = Sheet(
    "curves",
    (
        _length("from"),
        _length("to"),
        _length("radius"),
        _text("side"),
        _length("transition", is_needed=False),
        _length("cant", is_needed=False),
    ),
)
POINT_MASSES = Sheet("point_masses", (*_PLACE, _MASS))
INSERTS = Sheet(
    "inserts",
    (
        *_PLACE,
        _length("length"),
        _MASS,
        ColumnOf("axial_stiffness", "number", "N"),
        ColumnOf("bending_stiffness", "number", "N m2"),
    ),
)
# Sheets whose rows are the items of a list of the line, by the path of that list.
LISTS = {
    "tension_lengths": TENSION_LENGTHS,
    "track.curves": CURVES,
    "point_masses": POINT_MASSES,
    "inserts": INSERTS,
}
SHEETS = {sheet.name: sheet for sheet in (SPANS, SUPPORTS, DROPPERS, HANGERS, *LISTS.values())}
