"""Unit that was meant by a number without one that its field cannot hold."""

from collections.abc import Callable
from numbers import Real

from arcless.units import to_si

# The unit in which engineers write what is in SI here, where that is another one.
WRITTEN = {"m": "mm", "rad": "deg", "s": "ms", "m/s": "km/h", "kg/m": "kg/km"}


def meant_unit(value: object, unit: str, holds: Callable[[float], bool]) -> str | None:
    """Return a question with the unit that makes a bare number a value of its field, or None.

    Parameters
    ----------
    value
        What was given; a text has its unit, and nothing is guessed of it.
    unit
        The SI unit of the field.
    holds
        Whether the field can hold a number in SI.
    """
    written = WRITTEN.get(unit)
    if written is None or not isinstance(value, Real):
        return None
    text = f"{value:g} {written}"
    return f"did you mean {text}?" if holds(to_si(text, unit)) else None
