"""Numbers with units: ``"22 kN"`` → 22000.0.

A bare number is SI, and a unit of the wrong kind is an error instead of a conversion.
"""

import math
import numbers
import re
from fractions import Fraction

from arcless.errors import ModelError
from arcless.units.hints import about_number, about_unit
from arcless.units.kinds import KINDS, accepted, canonical, spell

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_GROUPED = re.compile(r"[+-]?\d{1,3}([ ,'_\u00a0\u202f]\d{3})+(?!\d)")
_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+")
_NOT_FINITE = re.compile(r"[+-]?\.?(nan|inf|infinity)\b", re.IGNORECASE)
MAX_TEXT = 80
# Text of an error whose got and expected say it all; messages then leave it out.
WRONG_VALUE = "wrong value"
NUMBER_AND_UNIT = "write a number, then its unit, such as 1.5 m"
DECIMAL_POINT = "write the decimal point as a point"


def to_si(value: object, unit: str) -> float:
    """Return a number, or a text of number and unit, in SI.

    Parameters
    ----------
    value : float or str
        A number in SI, or a text such as ``"22 kN"``.
    unit : str
        The SI unit of the kind asked for, a key of `KINDS`, e.g. ``"N"``.

    Returns
    -------
    float
        The value in `unit`; always finite.

    Raises
    ------
    ModelError
        Not a number, not finite, an unknown unit, or a unit of another kind.

    Examples
    --------
    >>> to_si("22 kN", "N")
    22000.0
    """
    if isinstance(value, str):
        number = _parse(value, unit)
    elif isinstance(value, numbers.Real) and not isinstance(value, bool):
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
    else:
        raise ModelError(WRONG_VALUE, got=show(value), expected=accepted(unit))
    if not math.isfinite(number):
        raise ModelError(WRONG_VALUE, got=show(value), expected=f"{accepted(unit)}, finite")
    return number


def written_in(value: object, unit: str) -> tuple[str, float] | None:
    """Return the unit that an amount is written in, as printed, and its size in SI.

    None for a bare number, and for what is no amount of this kind.

    Examples
    --------
    >>> written_in("275 km/h", "m/s")
    ('km/h', 0.2777777777777778)
    """
    if not isinstance(value, str) or (number := _NUMBER.match(value.strip())) is None:
        return None
    name = canonical(value.strip()[number.end() :].strip())
    factor = KINDS[unit].units.get(name)
    return None if factor is None or not name else (spell(name), float(factor))


def show(value: object) -> str:
    """Return a given value for a message: quoted when it is text, and never long."""
    if isinstance(value, (dict, list, tuple)):
        name = "a mapping" if isinstance(value, dict) else "a list"
        return f"{name} of {len(value)}"
    if value is None:
        return "nothing"
    text = str(value).lower() if isinstance(value, bool) else str(value)
    text = plain(text)
    return f'"{text}"' if isinstance(value, str) else text


def plain(text: str) -> str:
    """Return a text from a file for a message: without what does not print, and never long."""
    text = text if len(text) <= MAX_TEXT else f"{text[:MAX_TEXT]}…"
    return text if text.isprintable() else "".join(c if c.isprintable() else "?" for c in text)


def _parse(text: str, unit: str) -> float:
    stripped = text.strip()
    number = _NUMBER.match(stripped)
    grouped = _GROUPED.match(stripped)
    if grouped:
        digits = plain(re.sub(r"[ ,'_\u00a0\u202f]", "", grouped.group()))
        hint = f"write digits without separators ({digits}) and the decimal point as a point"
        raise _refused(text, unit, hint)
    if _DECIMAL_COMMA.match(stripped):
        raise _refused(text, unit, DECIMAL_POINT)
    if number is None:
        not_finite = _NOT_FINITE.match(stripped)
        raise _refused(text, unit, "the value must be finite" if not_finite else NUMBER_AND_UNIT)
    factor = _factor(stripped[number.end() :].strip(), unit, text)
    return _scaled(number.group(), factor)


def _scaled(number: str, factor: int | float | Fraction) -> float:
    """Return number times factor, rounded once: ``300 km/h`` is the float nearest to 300/3.6."""
    value = float(number)
    if not math.isfinite(value) or value == 0 or len(number) > MAX_TEXT:
        return value * float(factor)
    try:
        return float(Fraction(number) * Fraction(factor))
    except OverflowError:
        return math.inf


def _factor(written: str, unit: str, text: str) -> int | float | Fraction:
    if not written:
        return 1
    kind = KINDS[unit]
    name = canonical(written)
    if name in kind.units:
        return kind.units[name]
    raise _refused(
        text, unit, about_number(plain(written)) or about_unit(plain(written), plain(name), unit)
    )


def _refused(text: str, unit: str, hint: str) -> ModelError:
    return ModelError(WRONG_VALUE, got=show(text), expected=accepted(unit), hint=hint)
