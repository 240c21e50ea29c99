"""Amounts in a study file: numbers in SI or texts with a unit, read by the unit of their field."""

from typing import Annotated, Any

from pydantic import Field, StrictFloat, StrictInt, StrictStr

from arcless.errors import ModelError
from arcless.model.fields.part import Unit
from arcless.units import WRONG_VALUE, show, to_si

Amount = Annotated[
    StrictInt | StrictFloat | StrictStr,
    Field(json_schema_extra={"of": "number in SI, or text with the unit of the field"}),
]


def number(value: Any, unit: Unit | None, *field: str | int) -> float:
    """Return an amount in SI.

    Parameters
    ----------
    value
        As written.
    unit
        Of the field that it is for; None takes plain numbers only.
    field
        Where it stands, for the message.

    Raises
    ------
    ModelError
        Not a number, or of another kind. Bounds are not looked at: a value outside makes its
        variant invalid, which is a row of the table and not an error of the file.
    """
    if unit is None:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise ModelError(
                WRONG_VALUE, got=show(value), expected="a number without unit", field=field
            )
        return float(value)
    try:
        return to_si(value, unit.unit)
    except ModelError as error:
        error.field = field
        raise


def plain(value: Any, unit: Unit | None, *field: str | int) -> Any:
    """Return any value of a field: in SI where it is an amount, words and groups as they are."""
    if isinstance(value, list | tuple):
        return [plain(item, unit, *field, index) for index, item in enumerate(value)]
    is_word = unit is not None and isinstance(value, str) and value.strip() in unit.words
    if unit is None or is_word or value is None or isinstance(value, dict):
        return value
    return number(value, unit, *field)
