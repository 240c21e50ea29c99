"""Designs: which combinations of values a study computes, and in which order they are counted.

A design is a model of the file and a function `plan` that numbers its combinations. Another one is
another class in `Design`.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import Part
from arcless.study.variables import Axis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

MAX_VARIANTS = 1_000_000
# Nearest to 0 and 1 that a point may lie: a normal distribution ends nowhere.
_EDGE = 2.0**-53
_SOBOL_BITS = 30
_MAX_SOBOL_VARIABLES = 1000


@dataclass(frozen=True)
class Plan:
    """The combinations of a design, counted from 0; none is made before it is asked for."""

    count: int
    values: Callable[[int], tuple[Any, ...]]


class Grid(Part):
    """A grid: every combination of the values of all variables, the last variable fastest."""

    kind: Literal["grid"] = Field(description="Every combination.")

    def plan(self, axes: Sequence[Axis], seed: int) -> Plan:  # noqa: ARG002 - same for all designs
        """Count the combinations."""
        levels = [_levels(axis, "a grid") for axis in axes]
        count = _checked(prod(len(values) for values in levels))

        def values(number: int) -> tuple[Any, ...]:
            chosen = []
            for values in reversed(levels):
                number, place = divmod(number, len(values))
                chosen.append(values[place])
            return tuple(reversed(chosen))

        return Plan(count, values)


class Listed(Part):
    """A list: the first values of all variables together, then the second ones, and so on."""

    kind: Literal["list"] = Field(description="Values side by side.")

    def plan(self, axes: Sequence[Axis], seed: int) -> Plan:  # noqa: ARG002 - same for all designs
        """Count the rows of the list."""
        levels = [_levels(axis, "a list") for axis in axes]
        count = _checked(len(levels[0]))
        for axis, values in zip(axes, levels, strict=True):
            if len(values) != count:
                raise ModelError(
                    "lists of different lengths",
                    got=f"{len(values)} values",
                    expected=f"{count}, as {axes[0].name} has",
                    field=("variables", axis.name),
                )
        return Plan(count, lambda number: tuple(values[number] for values in levels))


class _Sample(Part):
    """A sample."""

    count: int = Field(description="How many variants.", ge=1)

    def plan(self, axes: Sequence[Axis], seed: int) -> Plan:
        """Draw the sample; number by number it is the same for the same seed."""
        count = _checked(self.total(len(axes)))
        points = self.points(count, len(axes), seed)

        def values(number: int) -> tuple[Any, ...]:
            row = (min(max(float(u), _EDGE), 1.0 - _EDGE) for u in points[number])
            return tuple(axis.quantile(u) for axis, u in zip(axes, row, strict=True))

        return Plan(count, values)

    def total(self, variables: int) -> int:  # noqa: ARG002 - of some designs it depends on them
        """Return how many variants there are."""
        return self.count

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":
        """Return points of the unit cube, one a row."""
        raise NotImplementedError


class MonteCarlo(_Sample):
    """A Monte Carlo sample: independent draws."""

    kind: Literal["monte-carlo"] = Field(description="Independent draws.")

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":
        """Return independent points; more of them leave the first ones as they are."""
        return _random(seed).random((count, variables))


class LatinHypercube(_Sample):
    """A Latin hypercube: of every variable one value from each of `count` equal parts.

    Source: McKay, Beckman and Conover, Technometrics 21 (1979) 239.
    """

    kind: Literal["latin-hypercube"] = Field(description="One value from each part.")

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":
        """Return (π(i) + r)/n, π a random order of each variable by itself, r random below 1."""
        import numpy as np

        random = _random(seed)
        order = np.argsort(random.random((count, variables)), axis=0, kind="stable")
        points: NDArray[np.float64] = (order + random.random((count, variables))) / count
        return points


class Sobol(_Sample):
    """A Sobol sequence with a random digital shift; most even at powers of two.

    Source: direction numbers of Joe and Kuo, SIAM J. Sci. Comput. 30 (2008) 2635, from SciPy.
    """

    kind: Literal["sobol"] = Field(description="Evenly filling sequence.")

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":
        """Return x ⊕ s, x the sequence, s one random shift a variable, both in binary digits."""
        import numpy as np
        from scipy.stats.qmc import Sobol as Sequence_

        if variables > _MAX_SOBOL_VARIABLES:
            got, most = f"{variables} variables", f"at most {_MAX_SOBOL_VARIABLES}"
            raise ModelError("too many variables", got=got, expected=most, field=("design",))
        whole = 1 << max(count - 1, 1).bit_length()  # only powers of two come without a warning
        sequence = Sequence_(variables, scramble=False, bits=_SOBOL_BITS)
        drawn = sequence.random_base2(whole.bit_length() - 1)[:count]
        scale = float(1 << _SOBOL_BITS)
        digits = np.rint(drawn * scale).astype(np.int64)
        shift = (_random(seed).random(variables) * scale).astype(np.int64)
        points: NDArray[np.float64] = ((digits ^ shift) + 0.5) / scale
        return points


class SobolIndices(_Sample):
    """Blocks of points for Sobol indices: A, A with each column from B, B.

    Source: Saltelli, Comput. Phys. Commun. 145 (2002) 280; A and B are the halves of a Sobol
    sequence. A block has k + 2 points for k variables, 2k + 2 with B with each column from A.
    """

    kind: Literal["sobol-indices"] = Field(description="Blocks for Sobol indices.")
    count: int = Field(description="How many blocks, a power of two.", ge=2)
    second_order: bool = Field(default=False, description="Whether pairs get an index, too.")

    @model_validator(mode="after")
    def _check_count(self) -> "SobolIndices":
        if self.count & (self.count - 1):
            near = 1 << self.count.bit_length() - 1
            raise ModelError(
                "not a power of two",
                got=str(self.count),
                expected=f"a power of two, such as {near} or {2 * near}",
                field=("count",),
            )
        return self

    def block(self, variables: int) -> int:
        """Return the points of a block."""
        return (2 * variables if self.second_order else variables) + 2

    def total(self, variables: int) -> int:
        """Return blocks times points of a block."""
        return self.count * self.block(variables)

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":  # noqa: ARG002
        """Return the blocks, one after the other."""
        import numpy as np

        both = Sobol(kind="sobol", count=self.count).points(self.count, 2 * variables, seed)
        a, b = both[:, :variables], both[:, variables:]
        rows = [a]
        for one, other in ((a, b), (b, a)) if self.second_order else ((a, b),):
            for column in range(variables):
                mixed = one.copy()
                mixed[:, column] = other[:, column]
                rows.append(mixed)
        return np.stack([*rows, b], axis=1).reshape(-1, variables)


class Morris(_Sample):
    """Trajectories for Morris' elementary effects: one variable after the other is moved.

    Source: Morris, Technometrics 33 (1991) 161. Of p levels of each variable, l = 0 … p − 1, a step
    is p/2 levels up or down; level l is the quantile (l + ½)/p, since a normal distribution has
    none at 0 and 1.
    """

    kind: Literal["morris"] = Field(description="Trajectories for elementary effects.")
    count: int = Field(description="How many trajectories.", ge=2)
    levels: int = Field(default=4, description="Levels of each variable, even.", ge=2, le=100)

    @model_validator(mode="after")
    def _check_levels(self) -> "Morris":
        if self.levels % 2:
            raise ModelError(
                "odd number of levels",
                got=str(self.levels),
                expected="an even one, so that all levels are equally likely",
                field=("levels",),
            )
        return self

    def block(self, variables: int) -> int:
        """Return the points of a trajectory."""
        return variables + 1

    def total(self, variables: int) -> int:
        """Return trajectories times points of one."""
        return self.count * self.block(variables)

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":  # noqa: ARG002
        """Return the trajectories, one after the other."""
        import numpy as np

        random = _random(seed)
        half = self.levels // 2
        draws = random.random((self.count, 3, variables))
        points = np.empty((self.count, variables + 1, variables))
        for path, (start, side, order) in zip(points, draws, strict=True):
            low = np.floor(half * start)
            up = side < 0.5  # noqa: PLR2004 - both ways are equally likely
            level = np.where(up, low, low + half)
            path[0] = level
            for step, column in enumerate(np.argsort(order, kind="stable"), start=1):
                level[column] += half if up[column] else -half
                path[step] = level
        return (points.reshape(-1, variables) + 0.5) / self.levels


Design = Annotated[
    Grid | Listed | LatinHypercube | Sobol | MonteCarlo | SobolIndices | Morris,
    Field(discriminator="kind"),
]


def _random(seed: int) -> "np.random.Generator":
    import numpy as np

    # Named, not the default of the day; only `random()` is used, whose stream NumPy keeps.
    return np.random.Generator(np.random.PCG64(seed))


def _levels(axis: Axis, title: str) -> tuple[Any, ...]:
    if axis.levels is None:
        raise ModelError(
            "values cannot be counted",
            expected=f"values, or range with count, since the design is {title}",
            hint="or take a sample: latin-hypercube, sobol, monte-carlo",
            field=("variables", axis.name),
        )
    return axis.levels


def _checked(count: int) -> int:
    if count > MAX_VARIANTS:
        raise ModelError(
            "too many variants",
            got=f"{count:,} variants".replace(",", " "),
            expected=f"at most {MAX_VARIANTS:,}".replace(",", " "),
            hint="fewer values, or a sample: latin-hypercube, sobol, monte-carlo",
            field=("design",),
        )
    return count
