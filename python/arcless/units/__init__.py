"""Numbers with units: ``"22 kN"`` → 22000.0, and how amounts are told in messages."""

from arcless.units.amounts import (
    DECIMAL_POINT,
    MAX_TEXT,
    WRONG_VALUE,
    plain,
    show,
    to_si,
    written_in,
)
from arcless.units.kinds import KINDS, Kind, accepted, spell
from arcless.units.patterns import pattern

__all__ = [
    "DECIMAL_POINT",
    "KINDS",
    "MAX_TEXT",
    "WRONG_VALUE",
    "Kind",
    "accepted",
    "pattern",
    "plain",
    "show",
    "spell",
    "to_si",
    "written_in",
]
