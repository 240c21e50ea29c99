"""Distributions of a variable, each by its quantile function F⁻¹(u), 0 < u < 1.

A design hands out points u of the unit cube; nothing here draws at random. The normal quantile is
that of Python's `statistics` (algorithm AS 241, Wichura 1988, relative error below 1e-15).
"""

import math
from collections.abc import Callable
from statistics import NormalDist
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field, StrictFloat, StrictInt, StrictStr

from arcless.errors import ModelError
from arcless.model.fields.part import Part, Unit
from arcless.study.variables.amounts import Amount, number, plain
from arcless.units import show

_STANDARD = NormalDist()


class _Distribution(Part):
    """A distribution."""

    _amounts: ClassVar[tuple[str, ...]] = ()
    _rising: ClassVar[tuple[str, ...]] = ()
    _positive: ClassVar[tuple[str, ...]] = ()

    def in_si(self, unit: Unit | None) -> Self:
        """Return it with its parameters in SI, checked against each other.

        Raises
        ------
        ModelError
            A parameter is no amount of the unit, bounds are out of order, a spread is not positive.
        """
        found = {name: number(getattr(self, name), unit, name) for name in self._amounts}
        for low, high in zip(self._rising, self._rising[1:], strict=False):
            if not found[low] < found[high]:
                raise ModelError(
                    "empty range",
                    got=f"{low} {show(getattr(self, low))}, {high} {show(getattr(self, high))}",
                    expected=f"{low} below {high}",
                    field=(high,),
                )
        for name in self._positive:
            if not found[name] > 0.0:
                got = show(getattr(self, name))
                raise ModelError("not positive", got=got, expected="more than zero", field=(name,))
        return self.model_copy(update=found)

    def quantile(self, u: float) -> Any:
        """Return the value below which a part `u` of all values lies, parameters in SI."""
        raise NotImplementedError


class Uniform(_Distribution):
    """A uniform distribution."""

    _amounts = _rising = ("low", "high")

    kind: Literal["uniform"] = Field(description="Equally likely between two bounds.")
    low: Amount = Field(description="Lower bound.")
    high: Amount = Field(description="Upper bound.")

    def quantile(self, u: float) -> float:
        """Return low + u (high − low)."""
        low, high = _floats(self.low, self.high)
        return low + u * (high - low)


class Normal(_Distribution):
    """A normal distribution."""

    _amounts = ("mean", "standard_deviation")
    _positive = ("standard_deviation",)

    kind: Literal["normal"] = Field(description="Normal.")
    mean: Amount = Field(description="Mean.")
    standard_deviation: Amount = Field(description="Standard deviation.")

    def quantile(self, u: float) -> float:
        """Return μ + σ Φ⁻¹(u)."""
        mean, deviation = _floats(self.mean, self.standard_deviation)
        return mean + deviation * _STANDARD.inv_cdf(u)


class TruncatedNormal(_Distribution):
    """A normal distribution of which only what lies between two bounds is kept."""

    _amounts = ("mean", "standard_deviation", "low", "high")
    _rising = ("low", "high")
    _positive = ("standard_deviation",)

    kind: Literal["truncated-normal"] = Field(description="Normal, cut off at two bounds.")
    mean: Amount = Field(description="Mean before truncation.")
    standard_deviation: Amount = Field(description="Standard deviation before truncation.")
    low: Amount = Field(description="Lower bound.")
    high: Amount = Field(description="Upper bound.")

    def in_si(self, unit: Unit | None) -> Self:
        """Return it in SI; bounds must leave something of the distribution between them."""
        found = super().in_si(unit)
        below, above, _ = found._tails()
        if not above - below > 0.0:
            raise ModelError(
                "nothing between the bounds",
                got=f"low {show(self.low)}, high {show(self.high)}",
                expected="bounds within 37 standard deviations of the mean",
                field=("low",),
            )
        return found

    def quantile(self, u: float) -> float:
        """Return μ + σ Φ⁻¹(a + u (b − a)), a and b the parts below low and below high."""
        mean, deviation, low, high = _floats(
            self.mean, self.standard_deviation, self.low, self.high
        )
        below, above, mirrored = self._tails()
        part = below + (1.0 - u if mirrored else u) * (above - below)
        z = _STANDARD.inv_cdf(min(max(part, 5e-324), 1.0 - 2.0**-53))
        return min(max(mean + (-z if mirrored else z) * deviation, low), high)

    def _tails(self) -> tuple[float, float, bool]:
        """Return the parts below the bounds; bounds above the mean are mirrored to below it."""
        mean, deviation, low, high = _floats(
            self.mean, self.standard_deviation, self.low, self.high
        )
        low, high = (low - mean) / deviation, (high - mean) / deviation
        mirrored = low > 0.0  # near one, a part has lost the digits that matter
        low, high = (-high, -low) if mirrored else (low, high)
        root = math.sqrt(2.0)
        return 0.5 * math.erfc(-low / root), 0.5 * math.erfc(-high / root), mirrored


class LogNormal(_Distribution):
    """A lognormal distribution: always positive, its logarithm is normal."""

    _amounts = _positive = ("mean", "standard_deviation")

    kind: Literal["lognormal"] = Field(description="Lognormal: always positive.")
    mean: Amount = Field(description="Mean of the values themselves.")
    standard_deviation: Amount = Field(description="Standard deviation of the values themselves.")

    def quantile(self, u: float) -> float:
        """Return exp(μ + σ Φ⁻¹(u)), σ² = ln(1 + (s/m)²), μ = ln m − σ²/2."""
        mean, deviation = _floats(self.mean, self.standard_deviation)
        variance = math.log1p((deviation / mean) ** 2)
        exponent = math.log(mean) - 0.5 * variance + math.sqrt(variance) * _STANDARD.inv_cdf(u)
        return math.exp(exponent)


class Triangular(_Distribution):
    """A triangular distribution."""

    _amounts = _rising = ("low", "mode", "high")

    kind: Literal["triangular"] = Field(description="Triangular between two bounds.")
    low: Amount = Field(description="Lower bound.")
    mode: Amount = Field(description="Most likely value.")
    high: Amount = Field(description="Upper bound.")

    def quantile(self, u: float) -> float:
        """Return low + √(u w (m − low)), or from the upper end; w is the width, m the mode."""
        low, mode, high = _floats(self.low, self.mode, self.high)
        width = high - low
        if u * width < mode - low:
            return low + math.sqrt(u * width * (mode - low))
        return high - math.sqrt((1.0 - u) * width * (high - mode))


class Choice(_Distribution):
    """A choice of values, equally likely or by weights."""

    kind: Literal["choice"] = Field(description="One of several values.")
    values: tuple[Any, ...] = Field(description="The values, of any kind.", min_length=1)
    weights: tuple[StrictFloat | StrictInt, ...] | None = Field(
        default=None, description="How likely each is, relative to the others; equal without."
    )

    def in_si(self, unit: Unit | None) -> Self:
        """Return it with its values in SI."""
        weights = self.weights
        if weights is not None and (
            len(weights) != len(self.values) or min(weights) < 0 or not sum(weights) > 0
        ):
            expected = "a number for each value, none below zero, not all zero"
            raise ModelError("wrong weights", got=show(weights), expected=expected)
        values = tuple(plain(v, unit, "values", i) for i, v in enumerate(self.values))
        return self.model_copy(update={"values": values})

    def quantile(self, u: float) -> Any:
        """Return the value at whose share of the weights `u` lies."""
        weights = self.weights or (1.0,) * len(self.values)
        wanted, reached = u * sum(weights), 0.0
        for value, weight in zip(self.values, weights, strict=True):
            reached += weight
            if wanted < reached:
                return value
        return self.values[-1]


Distribution = Annotated[
    Uniform | Normal | TruncatedNormal | LogNormal | Triangular | Choice,
    Field(discriminator="kind"),
]
Quantile = Callable[[float], Any]


def _floats(*amounts: StrictInt | StrictFloat | StrictStr) -> tuple[float, ...]:
    return tuple(float(amount) for amount in amounts)
