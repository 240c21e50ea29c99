"""Numbers with units: ``"22 kN"`` → 22000.0.

A bare number is SI. The table is small on purpose: it holds the units that overhead-line
engineers write, and a unit of the wrong kind is an error instead of a conversion.
"""

import math
import numbers
import re
from difflib import get_close_matches
from fractions import Fraction
from functools import cache, lru_cache
from typing import NamedTuple

from arcless.errors import ModelError


class Kind(NamedTuple):
    """A physical kind: its name with article, and its units in SI, SI unit first."""

    name: str
    units: dict[str, int | float | Fraction]


_MILLI = Fraction(1, 1000)
_KMH = Fraction(5, 18)
_DEGREE = math.pi / 180

# Keyed by SI unit. Spellings: a product is "·", a power is a plain digit (see `_canonical`).
KINDS: dict[str, Kind] = {
    "N": Kind("a force", {"N": 1, "kN": 1000, "daN": 10, "MN": 1_000_000}),
    "m": Kind("a length", {"m": 1, "mm": _MILLI, "cm": Fraction(1, 100), "km": 1000}),
    "kg": Kind("a mass", {"kg": 1, "g": _MILLI, "t": 1000}),
    "kg/m": Kind("a mass per length", {"kg/m": 1, "g/m": _MILLI, "kg/km": _MILLI, "t/km": 1}),
    "N/m": Kind("a stiffness", {"N/m": 1, "kN/m": 1000, "N/mm": 1000, "MN/m": 1_000_000}),
    "N s/m": Kind("a damping", {"N·s/m": 1, "kN·s/m": 1000}),
    "N m2": Kind("a bending stiffness", {"N·m2": 1, "kN·m2": 1000}),
    "kg m2": Kind("a moment of inertia", {"kg·m2": 1}),
    "N m/rad": Kind("a rotational stiffness", {"N·m/rad": 1, "kN·m/rad": 1000}),
    "N m s/rad": Kind("a rotational damping", {"N·m·s/rad": 1}),
    "m/s": Kind("a speed", {"m/s": 1, "km/h": _KMH}),
    "s": Kind("a time", {"s": 1, "ms": _MILLI, "min": 60}),
    "rad": Kind("an angle", {"rad": 1, "mrad": _MILLI, "deg": _DEGREE, "°": _DEGREE}),
    "Hz": Kind("a frequency", {"Hz": 1, "kHz": 1000}),
    "m/s2": Kind("an acceleration", {"m/s2": 1}),
    "1/s": Kind("a rate", {"1/s": 1}),
    "1/K": Kind("a thermal expansion", {"1/K": 1}),
    "K": Kind("a temperature difference", {"K": 1}),
    "kg/m3": Kind("a density", {"kg/m3": 1}),
    "N/(m/s)2": Kind("an aerodynamic coefficient", {"N/(m/s)2": 1, "N/(km/h)2": 1 / _KMH**2}),
    "N/s": Kind("a rate of force", {"N/s": 1, "kN/s": 1000}),
    "A": Kind("an electric current", {"A": 1, "kA": 1000}),
    "V": Kind("a voltage", {"V": 1, "kV": 1000}),
    "Ohm": Kind("a resistance", {"Ohm": 1, "mOhm": _MILLI, "uOhm": Fraction(1, 1_000_000)}),
    "Pa": Kind("a hardness", {"Pa": 1, "MPa": 10**6, "GPa": 10**9, "N/mm2": 10**6}),
    "J/kg": Kind("a latent heat", {"J/kg": 1, "kJ/kg": 1000, "MJ/kg": 10**6}),
    "1": Kind("a number without unit", {"": 1}),
}

_ALIASES = {
    "Ns/m": "N·s/m",
    "kNs/m": "kN·s/m",
    "Nm2": "N·m2",
    "kNm2": "kN·m2",
    "kgm2": "kg·m2",
    "Nm/rad": "N·m/rad",
    "Nms/rad": "N·m·s/rad",
    "N·s2/m2": "N/(m/s)2",
    "Ns2/m2": "N/(m/s)2",
    "kmh": "km/h",
    "s-1": "1/s",
    "K-1": "1/K",
    "Ω": "Ohm",
    "mΩ": "mOhm",
    "µΩ": "uOhm",
    "μΩ": "uOhm",
}
_KIND_OF_UNIT = {unit: kind for kind in KINDS.values() for unit in kind.units if unit}

_POWER = re.compile(r"(?<=[ms)])([23])")
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_GROUPED = re.compile(r"[+-]?\d{1,3}([ ,'_\u00a0\u202f]\d{3})+(?!\d)")
_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+")
_NOT_FINITE = re.compile(r"[+-]?\.?(nan|inf|infinity)\b", re.IGNORECASE)
MAX_TEXT = 80
# Text of an error whose got and expected say it all; messages then leave it out.
WRONG_VALUE = "wrong value"
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
    name = _canonical(value.strip()[number.end() :].strip())
    factor = KINDS[unit].units.get(name)
    return None if factor is None or not name else (spell(name), float(factor))


@cache
def accepted(unit: str) -> str:
    """Say which kind and which units a field takes, e.g. ``a force (N, kN, daN, MN)``."""
    kind = KINDS[unit]
    units = [spell(name) for name in kind.units if name]
    return f"{kind.name} ({', '.join(units)})" if units else kind.name


def spell(unit: str) -> str:
    """Return a unit as engineers print it: ``N·m2`` → ``N m²``."""
    return _POWER.sub(lambda found: "²" if found[1] == "2" else "³", unit.replace("·", " "))


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
        form = "write a number, then its unit, such as 1.5 m"
        raise _refused(text, unit, "the value must be finite" if not_finite else form)
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
    name = _canonical(written)
    if name in kind.units:
        return kind.units[name]
    raise _refused(text, unit, _about_unit(plain(written), plain(name), unit))


@lru_cache(100)  # a long list may have the same mistake in every item
def _about_unit(written: str, name: str, unit: str) -> str:
    """Return the hint about a unit that a field does not take."""
    units = KINDS[unit].units
    other = _KIND_OF_UNIT.get(name)
    if other is not None:
        return f"{written} is the unit of {other.name}"
    by_case = [known for known in units if known.lower() == name.lower()]
    close = by_case or get_close_matches(name, units, n=1)
    return f"did you mean {spell(close[0])}?" if close else f'unknown unit "{written[:20]}"'


def _canonical(written: str) -> str:
    name = written.replace("²", "2").replace("³", "3").replace("**", "").replace("^", "")
    name = name.replace("⁻¹", "-1").replace("\u2212", "-")
    name = re.sub(r"\s*[·⋅*]\s*|\s+", "·", name)
    name = re.sub(r"·?/·?", "/", name)
    return _ALIASES.get(name, name)


def _refused(text: str, unit: str, hint: str) -> ModelError:
    return ModelError(WRONG_VALUE, got=show(text), expected=accepted(unit), hint=hint)
