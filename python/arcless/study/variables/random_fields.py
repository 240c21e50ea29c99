"""Errors along a line that belong together: a Gaussian process, drawn at droppers or supports.

Zero mean, covariance of the errors at x and x′: C = σ² exp(−|x − x′|/ℓ). Such a process has no
memory beyond its last value, so it is drawn exactly, from place to place:
e₁ = σ z₁, e_{i+1} = ρ e_i + σ √(1 − ρ²) z_{i+1}, ρ = exp(−(x_{i+1} − x_i)/ℓ), z standard normal.
Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), section 4.2.1.

Errors within ±b are the same process with σ = 1, each value y brought to where a uniform one
stands, e = b (2Φ(y) − 1). Every error between −b and b is as likely, and those of two places have
the covariance C = (b²/3) (6/π) arcsin(exp(−|x − x′|/ℓ)/2).
Source: Pearson, On Further Methods of Determining Correlation (1907), the correlation of ranks.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from statistics import NormalDist
from typing import Annotated, Any

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model import Line
from arcless.model.fields.part import Part, Unit
from arcless.model.line.places.dropper_names import DropperName, droppers_called
from arcless.model.line.places.support_names import SupportName, supports_called

# A drawing is told by a whole number below this, which a float holds and a table shows.
DRAWINGS = 2**31
_STANDARD = NormalDist()


class RandomField(Part):
    """Errors of all droppers, or of all supports, of a line."""

    standard_deviation: Annotated[float, Unit("m", above=0, maximum=0.2)] | None = Field(
        default=None, description="Standard deviation of the error of each, of normal errors."
    )
    bound: Annotated[float, Unit("m", above=0, maximum=0.5)] | None = Field(
        default=None,
        description="Largest error either way, of errors that are equally likely up to it.",
    )
    correlation_length: Annotated[float, Unit("m", minimum=0, maximum=1e5)] = Field(
        description="Distance over which the correlation falls to 1/e; 0 for errors that have"
        " nothing to do with each other."
    )

    @model_validator(mode="after")
    def _check_size(self) -> "RandomField":
        if (self.standard_deviation is None) == (self.bound is None):
            both = self.bound is not None
            raise ModelError(
                "size of the errors", got="both of them" if both else "neither of them",
                expected="standard_deviation of normal errors, or bound of equally likely ones",
                field=("bound",) if both else (),
            )  # fmt: skip
        return self

    @property
    def deviation(self) -> float:
        """Standard deviation of the process: in m, or 1 of what is brought within a bound."""
        return 1.0 if self.standard_deviation is None else self.standard_deviation

    def error(self, value: float) -> float:
        """Return the error in m at a value of the process."""
        return value if self.bound is None else self.bound * (2.0 * _STANDARD.cdf(value) - 1.0)


@dataclass(frozen=True)
class Errors:
    """Errors of one kind that a random field may describe.

    Attributes
    ----------
    error
        What an error is called in the list that the field of the scenario takes.
    places
        Where they are: place in m and full name, along the line.
    """

    error: str
    places: Callable[[Line], list[tuple[float, DropperName | SupportName]]]


def drawing(u: float) -> float:
    """Return the number of the drawing at a point 0 < u < 1 of a sample."""
    return float(int(u * DRAWINGS))


def errors(path: str, field: RandomField, line: Line, number: float) -> list[dict[str, Any]]:
    """Return the errors all along a line, as the field of the scenario takes them.

    Parameters
    ----------
    path
        Field of the scenario, a key of `FIELDS`.
    field
        What is drawn.
    line
        Each tension length, and of paired droppers each wire, has a process of its own.
    number
        Number of the drawing: the same one gives the same errors.
    """
    import numpy as np

    # Named, not the default of the day; only `random()` is used, whose stream NumPy keeps.
    random = np.random.Generator(np.random.PCG64(int(number)))
    last: dict[tuple[int | None, int | None], tuple[float, float]] = {}
    found = []
    for x, name in FIELDS[path].places(line):
        draw = _STANDARD.inv_cdf(min(max(float(random.random()), 2.0**-53), 1.0 - 2.0**-53))
        value = field.deviation * draw
        process = name.tension_length, getattr(name, "wire", None)
        if process in last:
            before, x_before = last[process]
            kept = _correlation(x - x_before, field.correlation_length)
            value = kept * before + math.sqrt(1.0 - kept * kept) * value
        last[process] = (value, x)
        whole = {key: part for key, part in name._asdict().items() if part is not None}
        found.append({**whole, FIELDS[path].error: field.error(value)})
    return found


def droppers(line: Line) -> list[tuple[float, DropperName | SupportName]]:
    """Return place in m and full name of every dropper, along the line."""
    found: list[tuple[float, DropperName | SupportName]] = []
    for number, (start, span) in enumerate(
        zip(line.support_positions(), line.span_list(), strict=False), start=1
    ):
        for index, x in enumerate(span.droppers.positions, start=1):
            names = droppers_called(line, DropperName(number, index))
            found += [(start + x, name) for name in names]
    return found


def supports(line: Line) -> list[tuple[float, DropperName | SupportName]]:
    """Return place in m and full name of every support that holds wires, along the line."""
    return [
        (x, name)
        for number, x in enumerate(line.support_positions(), start=1)
        for name in supports_called(line, SupportName(number))
    ]


FIELDS = {
    "as_built.dropper_length_errors": Errors("length_error", droppers),
    "as_built.support_height_errors": Errors("height_error", supports),
}


def _correlation(distance: float, length: float) -> float:
    return math.exp(-distance / length) if length > 0.0 else 0.0
