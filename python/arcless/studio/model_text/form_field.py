"""One field of a form: as typed, in SI, and what it is."""

from typing import Any

from arcless.errors import ModelError
from arcless.studio.model_text.about import KEYS, About
from arcless.studio.model_text.places import VALUE, Place
from arcless.units import to_si


def value_of(data: Any) -> Any:
    """Return a value without its source."""
    return data[VALUE] if isinstance(data, dict) and VALUE in data else data


def told(
    field: str,
    label: str,
    typed: Any,
    known: About,
    place: Place | None,
    *,
    inherited: Any = None,
    together: str | None = None,
) -> dict[str, Any]:
    """Return a field as the page shows it.

    Parameters
    ----------
    field, label, typed, known, place
        Dotted path, name, what stands in the text, what is known of the field, and where it stands.
    inherited
        Its value where none is typed.
    together
        Path of the thing whose lists have one value each for the same droppers; None of others.
    """
    return {
        "field": field,
        "label": label.replace("_", " ").capitalize(),
        "typed": [value_of(one) for one in typed] if isinstance(typed, list) else typed,
        "inherited": inherited,
        "value": _in_si(inherited if typed is None else typed, known),
        "unit": known.unit,
        "units": known.units,
        "minimum": known.minimum,
        "maximum": known.maximum,
        "description": known.description,
        "line": place["line"] if place else None,
        "required": known.required,
        "choices": known.choices,
        "together": together,
    }


def _in_si(typed: Any, known: About) -> Any:
    """Return values in SI; None of what is no amount."""
    if isinstance(typed, list):
        return [_in_si(value_of(one), known) for one in typed]
    if known.unit is None or isinstance(typed, dict | bool) or typed is None:
        return typed if isinstance(typed, str | int | float) else None
    try:
        return to_si(typed, KEYS[known.unit])
    except ModelError:
        return None
