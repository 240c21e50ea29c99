"""Designs of values that are counted out: grids and lists."""

from collections.abc import Sequence
from math import prod
from typing import Any, Literal

from pydantic import Field

from arcless.errors import ModelError
from arcless.model.fields.part import Part
from arcless.study.designs.plan import Plan, checked, refuse_drawn
from arcless.study.variables.variables import Axis


class Grid(Part):
    """A grid: every combination of the values of all variables, the last variable fastest."""

    kind: Literal["grid"] = Field(description="Every combination.")

    def plan(self, axes: Sequence[Axis], seed: int) -> Plan:  # noqa: ARG002 - same for all designs
        """Count the combinations."""
        levels = [_levels(axis, "a grid") for axis in axes]
        count = checked(prod(len(values) for values in levels))

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
        count = checked(len(levels[0]))
        for axis, values in zip(axes, levels, strict=True):
            if len(values) != count:
                raise ModelError(
                    "lists of different lengths",
                    got=f"{len(values)} values",
                    expected=f"{count}, as {axes[0].name} has",
                    field=("variables", axis.name),
                )
        return Plan(count, lambda number: tuple(values[number] for values in levels))


def _levels(axis: Axis, title: str) -> tuple[Any, ...]:
    refuse_drawn(axis, title)
    if axis.levels is None:
        raise ModelError(
            "values cannot be counted",
            expected=f"values, or range with count, since the design is {title}",
            hint="or take a sample: latin-hypercube, sobol, monte-carlo",
            field=("variables", axis.name),
        )
    return axis.levels
