"""Designs that are samples: points of the unit cube, and values at the quantiles that they are."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

from pydantic import Field

from arcless.errors import ModelError
from arcless.model.fields.part import Part
from arcless.study.designs.plan import Plan, checked
from arcless.study.variables.variables import Axis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

# Nearest to 0 and 1 that a point may lie: a normal distribution ends nowhere.
_EDGE = 2.0**-53
_SOBOL_BITS = 30
_MAX_SOBOL_VARIABLES = 1000


class Sample(Part):
    """A sample."""

    count: int = Field(description="How many variants.", ge=1)

    def plan(self, axes: Sequence[Axis], seed: int) -> Plan:
        """Draw the sample; number by number it is the same for the same seed."""
        count = checked(self.total(len(axes)))
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


class MonteCarlo(Sample):
    """A Monte Carlo sample: independent draws."""

    kind: Literal["monte-carlo"] = Field(description="Independent draws.")

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":
        """Return independent points; more of them leave the first ones as they are."""
        return random_numbers(seed).random((count, variables))


class LatinHypercube(Sample):
    """A Latin hypercube: of every variable one value from each of `count` equal parts.

    Source: McKay, Beckman and Conover, Technometrics 21 (1979) 239.
    """

    kind: Literal["latin-hypercube"] = Field(description="One value from each part.")

    def points(self, count: int, variables: int, seed: int) -> "NDArray[np.float64]":
        """Return (π(i) + r)/n, π a random order of each variable by itself, r random below 1."""
        import numpy as np

        random = random_numbers(seed)
        order = np.argsort(random.random((count, variables)), axis=0, kind="stable")
        points: NDArray[np.float64] = (order + random.random((count, variables))) / count
        return points


class Sobol(Sample):
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
        shift = (random_numbers(seed).random(variables) * scale).astype(np.int64)
        points: NDArray[np.float64] = ((digits ^ shift) + 0.5) / scale
        return points


def random_numbers(seed: int) -> "np.random.Generator":
    """Return the random numbers of a seed."""
    import numpy as np

    # Named, not the default of the day; only `random()` is used, whose stream NumPy keeps.
    return np.random.Generator(np.random.PCG64(seed))
