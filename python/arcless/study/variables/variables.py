"""Variables of a study: a field of the scenario each, and its values."""

from dataclasses import dataclass
from typing import Any

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields.part import Part, Unit, nearest
from arcless.study.variables.amounts import Amount, number, plain
from arcless.study.variables.distributions import Choice, Distribution, Quantile, Uniform
from arcless.study.variables.random_fields import FIELDS, RandomField, drawing
from arcless.units import show, written_in

WAYS = ("values", "range", "distribution", "random_field")


class Variable(Part):
    """A variable: a field of the scenario, and the values it takes."""

    field: str = Field(description="Dotted path of the field, as `arcless run --set` takes it.")
    values: tuple[Any, ...] | None = Field(
        default=None, description="The values themselves, of any kind.", min_length=1
    )
    range: tuple[Amount, Amount] | None = Field(
        default=None, description="Lowest and highest value; count says how many for a grid."
    )
    count: int | None = Field(
        default=None, description="Values of a range, evenly spaced, both ends included.", ge=2
    )
    distribution: Distribution | None = Field(
        default=None, description="Distribution that a sample is drawn from."
    )
    random_field: RandomField | None = Field(
        default=None, description="Errors along the line, drawn independently in every variant."
    )
    description: str = Field(default="", description="What it stands for, in a sentence.")

    @model_validator(mode="after")
    def _check_way(self) -> "Variable":
        given = [name for name in WAYS if getattr(self, name) is not None]
        if len(given) != 1:
            what = f"both {' and '.join(given)} given" if given else "no values given"
            expected = "values, or range, or distribution, or random_field"
            raise ModelError(what, expected=expected, field=tuple(given[1:2]))
        if self.random_field is not None and self.field not in FIELDS:
            raise ModelError(
                "random field",
                got=show(self.field),
                expected=" or ".join(FIELDS),
                hint=nearest(self.field, list(FIELDS)),
                field=("field",),
            )
        if self.count is not None and self.range is None:
            raise ModelError("count without range", expected="range: [low, high]", field=("count",))
        return self


@dataclass(frozen=True)
class Axis:
    """A variable made ready: its values in SI.

    Attributes
    ----------
    name, field, unit
        Column of the table, field of the scenario, SI unit as printed (empty for none).
    levels
        The values that can be counted out; None for a range without count and a distribution.
    quantile
        The value at a point 0 < u < 1 of a sample.
    typed_unit, scale
        Unit that the study file gives its values in, as printed, and its size in SI: what people
        are shown.
    """

    name: str
    field: str
    unit: str
    levels: tuple[Any, ...] | None
    quantile: Quantile
    typed_unit: str = ""
    scale: float = 1.0

    @property
    def is_drawn(self) -> bool:
        """True when its values are numbers of drawings, of which none is near another one."""
        return self.quantile is drawing

    def shown(self, value: Any) -> str:
        """Return one of its values in words: a number in the unit of the study file."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            return str(value)
        return f"{value / self.scale:.6g} {self.typed_unit}".rstrip()


def axis(name: str, variable: Variable, field: str, unit: Unit | None) -> Axis:
    """Return a variable made ready by the whole path and the unit of its field.

    Raises
    ------
    ModelError
        A value is no amount of that unit, or a range is empty; `field` says where below it.
    """
    levels, quantile = _values(variable, unit)
    label = "" if unit is None else unit.label
    typed, scale = _typed(variable, unit)
    return Axis(name, field, label, levels, quantile, typed, scale)


def _typed(variable: Variable, unit: Unit | None) -> tuple[str, float]:
    """Return the first unit that a variable is given in, and its size; SI of bare numbers."""
    if unit is None or unit.unit == "1":
        return "", 1.0
    given: list[Any] = [*(variable.values or ()), *(variable.range or ())]
    if variable.distribution is not None:
        for one in variable.distribution.model_dump().values():
            given += one if isinstance(one, list | tuple) else [one]
    found = (written_in(value, unit.unit) for value in given)
    return next((one for one in found if one is not None), (unit.label, 1.0))


def _values(variable: Variable, unit: Unit | None) -> tuple[tuple[Any, ...] | None, Quantile]:
    if variable.values is not None:
        values = tuple(plain(v, unit, "values", i) for i, v in enumerate(variable.values))
        return values, Choice(kind="choice", values=values).quantile
    if variable.range is not None:
        low, high = (number(end, unit, "range", i) for i, end in enumerate(variable.range))
        if not low < high:
            given = ", ".join(show(end) for end in variable.range)
            expected = "the lowest value, then a higher one"
            raise ModelError("empty range", got=f"[{given}]", expected=expected, field=("range",))
        return spaced(low, high, variable.count), Uniform(
            kind="uniform", low=low, high=high
        ).quantile
    if variable.random_field is not None:
        return None, drawing
    assert variable.distribution is not None
    try:
        ready = variable.distribution.in_si(unit)
    except ModelError as error:
        error.field = ("distribution", *error.field)
        raise
    return (ready.values if isinstance(ready, Choice) else None), ready.quantile


def spaced(low: float, high: float, count: int | None) -> tuple[float, ...] | None:
    """Return evenly spaced values, both ends exact; None without a count."""
    if count is None:
        return None
    return (*(low + (high - low) * i / (count - 1) for i in range(count - 1)), high)
