"""Plan of a design: a count of combinations, each made when it is asked for."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from arcless.errors import ModelError
from arcless.study.variables.variables import Axis

MAX_VARIANTS = 1_000_000


@dataclass(frozen=True)
class Plan:
    """The combinations of a design, counted from 0; none is made before it is asked for."""

    count: int
    values: Callable[[int], tuple[Any, ...]]


def checked(count: int) -> int:
    """Return a number of variants that is not too large.

    Raises
    ------
    ModelError
        It is.
    """
    if count > MAX_VARIANTS:
        raise ModelError(
            "too many variants",
            got=f"{count:,} variants".replace(",", " "),
            expected=f"at most {MAX_VARIANTS:,}".replace(",", " "),
            hint="fewer values, or a sample: latin-hypercube, sobol, monte-carlo",
            field=("design",),
        )
    return count


def refuse_drawn(axis: Axis, title: str) -> None:
    """Refuse a random field in a design that asks for values one by one.

    Raises
    ------
    ModelError
        The variable is a random field.
    """
    if axis.is_drawn:
        raise ModelError(
            "a random field has no values to choose from",
            got=f"a design that is {title}",
            expected="a sample: monte-carlo, latin-hypercube or sobol",
            hint="monte-carlo with a count draws the field so many times",
            field=("variables", axis.name),
        )
