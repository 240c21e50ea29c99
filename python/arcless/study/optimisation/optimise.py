"""Optimisation: a design that chooses its next variants by what came out of those before.

What the study file says of it, which rows keep the constraints, and which are the best.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Literal

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.model.fields.part import Part, nearest
from arcless.study.designs import MAX_VARIANTS
from arcless.study.designs.plan import refuse_drawn
from arcless.study.journal.row import Row
from arcless.study.optimisation import pruning
from arcless.study.optimisation.constraints import check_hard
from arcless.study.optimisation.pruning import Pruning, Watch
from arcless.study.optimisation.search import Search
from arcless.study.variables.variables import Axis
from arcless.units import show

_SIGNS = {"minimise": 1.0, "maximise": -1.0}


class Constraint(Part):
    """A constraint: a bound of an output."""

    output: str = Field(description="Name of the output.")
    at_most: float | None = Field(default=None, description="Highest value that is allowed.")
    at_least: float | None = Field(default=None, description="Lowest value that is allowed.")
    hard: bool = Field(
        default=False, description="Whether a run is stopped at once that has broken it for good."
    )

    def excess(self, value: float) -> float:
        """Return by how much a value is outside; 0 or less where it is allowed."""
        above = -float("inf") if self.at_most is None else value - self.at_most
        below = -float("inf") if self.at_least is None else self.at_least - value
        return max(above, below)


class Optimise(Part):
    """A search for the best values by Optuna."""

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
    def _check_pruning(self) -> "Optimise":
        if self.pruning is not None and len(self.objectives) > 1:
            raise ModelError(
                "pruning compares one objective",
                got=f"{len(self.objectives)} objectives",
                expected="one, or no pruning",
                hint="with several, `hard: true` in constraints stops what has broken them",
                field=("pruning",),
            )
        return self

    def plan(self, axes: Sequence[Axis], seed: int) -> "Search":
        """Return the plan, which fills as the search goes on."""
        for axis in axes:
            refuse_drawn(axis, "an optimisation")
        return Search.of(self, tuple(axes), seed)

    def check(
        self, outputs: Mapping[str, str], scenario: Scenario, varied: Collection[str]
    ) -> None:
        """Refuse objectives and constraints that there cannot be.

        Parameters
        ----------
        outputs
            Expressions by name.
        scenario, varied
            The base, and the fields that are varied.

        Raises
        ------
        ModelError
            An output that there is not; a constraint without bound; one that is hard on what may
            still get better, or where a mean force is searched for.
        """
        named: list[tuple[str, tuple[str, ...]]] = [
            (name, ("design", "objectives", name)) for name in self.objectives
        ]
        named += [
            (bound.output, ("design", "constraints", str(index), "output"))
            for index, bound in enumerate(self.constraints)
        ]
        for name, place in named:
            if name not in outputs:
                hint = nearest(name, list(outputs))
                expected = "the name of an output"
                raise ModelError("no output", got=show(name), expected=expected, hint=hint,
                                 field=place)  # fmt: skip
        searches = any(
            placed.mean_force is not None
            and not {"pantographs", f"pantographs.{i}", f"pantographs.{i}.static_force"} & {*varied}
            for i, placed in enumerate(scenario.pantographs)
        )
        for index, bound in enumerate(self.constraints):
            try:
                self._check_bound(bound, outputs[bound.output], searches=searches)
            except ModelError as error:
                error.field = ("design", "constraints", str(index), *error.field)
                raise

    @staticmethod
    def _check_bound(bound: Constraint, expression: str, *, searches: bool) -> None:
        if bound.at_most is None and bound.at_least is None:
            raise ModelError("no bound", expected="at_most or at_least")
        if not bound.hard:
            return
        check_hard(bound, expression)
        if searches:
            raise ModelError(
                "a hard constraint in a search for a mean force",
                expected="static_force: none of several runs is known to be the one that counts",
                hint="leave `hard` away; `pruning` looks at the first run of the search",
                field=("hard",),
            )

    @property
    def watched(self) -> bool:
        """Whether runs are looked at while they step."""
        return self.pruning is not None or any(bound.hard for bound in self.constraints)

    def watch(self, earlier: Sequence[Row]) -> Watch | None:
        """Return what runs of the next round are watched for, given the rows of earlier ones."""
        if not self.watched:
            return None
        made: tuple[pruning.Comparison, ...] = ()
        if self.pruning is not None:
            ((name, goal),) = self.objectives.items()
            aim = (name, _SIGNS[goal])
            made = pruning.comparisons(self.pruning, aim, self.constraints, earlier, self.feasible)
        seen = (*self.objectives, *(bound.output for bound in self.constraints))
        return Watch(
            looks=pruning.LOOKS if self.pruning is None else self.pruning.looks,
            seen=tuple(dict.fromkeys(seen)),
            comparisons=made,
            hard=tuple(bound for bound in self.constraints if bound.hard),
        )

    def feasible(self, row: Row) -> bool:
        """Whether a row has all objectives and keeps all constraints."""
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
