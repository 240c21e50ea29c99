"""Regular expressions of amounts, for editors: JSON Schema has them as `pattern`."""

import re
from functools import cache

from arcless.units.kinds import ALIASES, KINDS

_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
# Parts of a spelling in `KINDS`, and the ways to write each; the rest stands for itself.
_WRITTEN = {
    "·": r"[\s·⋅*]+",
    "/": r"[\s·⋅*]*/[\s·⋅*]*",
    "2": r"(?:(?:\^|\*\*)?2|²)",
    "3": r"(?:(?:\^|\*\*)?3|³)",
    "-1": r"(?:(?:\^|\*\*)?[\u2212-]1|⁻¹)",
    "(": r"\(",
    ")": r"\)",
}
_PART = re.compile("|".join(map(re.escape, _WRITTEN)))


@cache
def pattern(unit: str) -> str:
    """Return the pattern of a text that is a number, and a unit of one kind or none.

    It is one in the dialects of Python and of ECMA-262, which JSON Schema asks for. What `to_si`
    takes matches; of what it refuses, only numbers that are too large or have digits in groups do.

    Parameters
    ----------
    unit
        SI unit of the kind, a key of `KINDS`.
    """
    names = [name for name in KINDS[unit].units if name]
    names += [alias for alias, name in ALIASES.items() if name in KINDS[unit].units]
    choices = "|".join(_PART.sub(lambda part: _WRITTEN[part[0]], name) for name in names)
    return rf"^\s*{_NUMBER}\s*(?:{choices})?\s*$"
