"""Numbers with units: ``"22 kN"`` → 22000.0, and how amounts are told in messages."""

from arcless.units.amounts import (
    DECIMAL_POINT,
    MAX_TEXT,
    NUMBER_AND_UNIT,
    WRONG_VALUE,
    plain,
    show,
    to_si,
    written_in,
)
from arcless.units.hints import ONE_NUMBER
from arcless.units.kinds import KINDS, Kind, accepted, spell
from arcless.units.patterns import pattern

__all__ = [
    "DECIMAL_POINT",
    "KINDS",
    "MAX_TEXT",
    "NUMBER_AND_UNIT",
    "ONE_NUMBER",
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
