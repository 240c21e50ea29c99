"""Hints about units that a field does not take, and about those that mean several things."""

import re
from difflib import get_close_matches
from functools import lru_cache

from arcless.units.kinds import KIND_OF_UNIT, KINDS, spell

# Units that mean several things, or none that a field could take.
_DIFFERENCE = "a difference is in K: from 10 °C to 30 °C it is 20 K, from 50 °F to 59 °F it is 5 K"
_TON = "a ton is 1000 kg, 907.2 kg or 1016 kg: write t, tf, kg or lb"
_UNCLEAR = {"ton": _TON, "tons": _TON, "°C": _DIFFERENCE, "°F": _DIFFERENCE}
# Units of mass and of the weight of that mass, which drawings mix up.
_WEIGHT = {"kg": "kgf", "t": "tf", "lb": "lbf"}
_OTHER = _WEIGHT | {weight: mass for mass, weight in _WEIGHT.items()}
_MASS_OR_WEIGHT = re.compile(rf"(?<![^\W\d_])(?:{'|'.join(_OTHER)})(?![^\W\d_])")
# A second number: 4 ft 8.5 in, 17 1/2 in, 5'6".
_SECOND_NUMBER = re.compile(r"""[\s·]\d|^\d+\s*/\s*\d|['"′″]""")
ONE_NUMBER = "write one number with one unit, such as 4.5 ft or 54 in"
# Of an unknown unit so many characters are repeated.
_SHOWN = 20


def about_number(written: str) -> str | None:
    """Return the hint about what stands behind a number where that is a second number."""
    if not _SECOND_NUMBER.search(written):
        return None
    return ONE_NUMBER


@lru_cache(100)  # a long list may have the same mistake in every item
def about_unit(written: str, name: str, unit: str) -> str:
    """Return the hint about a unit that a field does not take.

    Parameters
    ----------
    written, name
        The unit as written and as `KINDS` spells it.
    unit
        SI unit of the field, a key of `KINDS`.
    """
    units = KINDS[unit].units
    swapped = _MASS_OR_WEIGHT.sub(lambda found: _OTHER[found[0]], name)
    instead = f": did you mean {spell(swapped)}?" if swapped in units else ""
    other = KIND_OF_UNIT.get(name)
    if other is not None:
        return f"{written} is the unit of {other.name}{instead}"
    if instead:
        return instead.removeprefix(": ")
    if name in _UNCLEAR:
        return _UNCLEAR[name]
    by_case = [known for known in units if known.lower() == name.lower()]
    close = by_case or get_close_matches(name, filter(None, units), n=1)
    return f"did you mean {spell(close[0])}?" if close else f'unknown unit "{written[:_SHOWN]}"'
