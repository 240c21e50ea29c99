"""Settings of an optimisation, the rows that keep its constraints, and the best of them."""

from collections.abc import Iterable, Sequence
from typing import Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields.part import Part
from arcless.study.designs import MAX_VARIANTS
from arcless.study.journal.row import Row
from arcless.study.optimisation import pruning
from arcless.study.optimisation.constraints import Constraint
from arcless.study.optimisation.pruning import Monitoring, Pruning

_SIGNS = {"minimise": 1.0, "maximise": -1.0}


class SearchSettings(Part):
    """Objectives, constraints and pruning of a search for the best values."""

    kind: Literal["optimise"] = Field(description="Best values, searched for.")
    trials: int = Field(description="How many variants.", ge=1, le=MAX_VARIANTS)
    at_once: int = Field(
        default=4, description="Variants of a round, chosen before any of them is known.", ge=1
    )
    objectives: dict[str, Literal["minimise", "maximise"]] = Field(
        description="What to do with which output; of several there is a front.", min_length=1
    )
    constraints: tuple[Constraint, ...] = Field(
        default=(), description="Bounds of outputs that the best variants keep."
    )
    sampler: Literal["tpe", "random"] = Field(
        default="tpe", description="How variants are chosen: by what is known so far, or not."
    )
    pruning: Pruning | None = Field(
        default=None, description="When a run is stopped that cannot become good; never without."
    )

    @model_validator(mode="after")
    def _check_pruning(self) -> "SearchSettings":
        if self.pruning is not None and len(self.objectives) > 1:
            raise ModelError(
                "pruning compares one objective",
                got=f"{len(self.objectives)} objectives",
                expected="one, or no pruning",
                hint="with several, `hard: true` in constraints stops what has broken them",
                field=("pruning",),
            )
        return self

    @property
    def watched(self) -> bool:
        """True when a monitor observes runs while they step."""
        return self.pruning is not None or any(bound.hard for bound in self.constraints)

    def watch(self, earlier: Sequence[Row]) -> Monitoring | None:
        """Return the monitoring of runs of the next round, given the rows of earlier ones."""
        if not self.watched:
            return None
        made: tuple[pruning.Comparison, ...] = ()
        if self.pruning is not None:
            ((name, goal),) = self.objectives.items()
            aim = (name, _SIGNS[goal])
            made = pruning.comparisons(self.pruning, aim, self.constraints, earlier, self.feasible)
        seen = (*self.objectives, *(bound.output for bound in self.constraints))
        return Monitoring(
            looks=pruning.LOOKS if self.pruning is None else self.pruning.looks,
            seen=tuple(dict.fromkeys(seen)),
            comparisons=made,
            hard=tuple(bound for bound in self.constraints if bound.hard),
        )

    def feasible(self, row: Row) -> bool:
        """Return whether a row has all objectives and keeps all constraints."""
        found = self.numbers(row)
        return found is not None and all(excess <= 0.0 for excess in found[1])

    def best(self, given: Iterable[Row]) -> list[Row]:
        """Return the rows that no other one surpasses in every objective, by the first of them.

        Only rows that keep the constraints count. Of one objective it is the best row, of
        equals the first.
        """
        rows = {row.variant: row for row in given}
        costs = {n: self._costs(row) for n, row in sorted(rows.items()) if self.feasible(row)}
        front = [
            number
            for number, cost in costs.items()
            if not any(
                all(a <= b for a, b in zip(other, cost, strict=True))
                and (other != cost or earlier < number)
                for earlier, other in costs.items()
                if earlier != number
            )
        ]
        return [rows[number] for number in sorted(front, key=lambda number: costs[number])]

    def _costs(self, row: Row) -> list[float]:
        return [_SIGNS[goal] * float(row.outputs[name] or 0.0)
                for name, goal in self.objectives.items()]  # fmt: skip

    def numbers(self, row: Row) -> tuple[list[float], list[float]] | None:
        """Return objectives and excesses of a row; None where one of them has no value."""
        names = [*self.objectives, *(bound.output for bound in self.constraints)]
        values = [row.outputs.get(name) for name in names]
        if row.status != "done" or any(value is None for value in values):
            return None
        numbers = [float(value) for value in values if value is not None]
        count = len(self.objectives)
        bounds = zip(self.constraints, numbers[count:], strict=True)
        return numbers[:count], [bound.excess(value) for bound, value in bounds]
