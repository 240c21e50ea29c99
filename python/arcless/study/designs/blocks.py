"""Designs for sensitivity: samples in blocks whose points belong together."""

from typing import TYPE_CHECKING, Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.study.designs.samples import Sample, Sobol, random_numbers

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class SobolIndices(Sample):
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


class Morris(Sample):
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

        random = random_numbers(seed)
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
