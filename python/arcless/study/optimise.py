"""Optimisation: a design that chooses its next variants by what came out of those before.

Variants are chosen in rounds of `at_once`. A round follows from the seed and the rows of the
rounds before it alone, never from the order in which they came: so every executor gives the same
table, and a study that is resumed goes on as it would have gone on. Optuna chooses; the journal is
its memory.

Source: Bergstra et al., NeurIPS 24 (2011), tree-structured Parzen estimator, as in Optuna.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from pydantic import Field

from arcless.errors import ModelError, StudyError
from arcless.model.fields import Part, nearest
from arcless.study.designs import MAX_VARIANTS, Plan
from arcless.study.designs.plan import refuse_drawn
from arcless.study.rows import Row
from arcless.study.variables import Axis
from arcless.units import show

if TYPE_CHECKING:
    import optuna

# Nearest to 0 and 1 that a quantile may lie, as in samples.
_EDGE = 2.0**-53
_DIRECTIONS: dict[str, Literal["minimize", "maximize"]] = {
    "minimise": "minimize", "maximise": "maximize",
}  # fmt: skip


class Constraint(Part):
    """A constraint: a bound of an output."""

    output: str = Field(description="Name of the output.")
    at_most: float | None = Field(default=None, description="Highest value that is allowed.")
    at_least: float | None = Field(default=None, description="Lowest value that is allowed.")

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

    def plan(self, axes: Sequence[Axis], seed: int) -> "Search":
        """Return the plan, which fills as the search goes on."""
        for axis in axes:
            refuse_drawn(axis, "an optimisation")
        return Search.of(self, tuple(axes), seed)

    def check(self, outputs: Sequence[str]) -> None:
        """Refuse objectives and constraints of outputs that there are not, and empty ones."""
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
        for index, bound in enumerate(self.constraints):
            if bound.at_most is None and bound.at_least is None:
                place = ("design", "constraints", str(index))
                raise ModelError("no bound", expected="at_most or at_least", field=place)

    def feasible(self, row: Row) -> bool:
        """Whether a row has all objectives and keeps all constraints."""
        found = self._numbers(row)
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
        signs = {"minimise": 1.0, "maximise": -1.0}
        return [signs[goal] * float(row.outputs[name] or 0.0)
                for name, goal in self.objectives.items()]  # fmt: skip

    def _numbers(self, row: Row) -> tuple[list[float], list[float]] | None:
        """Return objectives and excesses of a row; None where one of them has no value."""
        names = [*self.objectives, *(bound.output for bound in self.constraints)]
        values = [row.outputs.get(name) for name in names]
        if row.status != "done" or any(value is None for value in values):
            return None
        numbers = [float(value) for value in values if value is not None]
        count = len(self.objectives)
        bounds = zip(self.constraints, numbers[count:], strict=True)
        return numbers[:count], [bound.excess(value) for bound, value in bounds]

    def trial(self, asked: "optuna.Trial", row: Row) -> "optuna.trial.FrozenTrial":
        """Return what Optuna is told of a row; one without values has failed."""
        import optuna

        found = self._numbers(row)
        known: dict[str, Any] = {"params": asked.params, "distributions": asked.distributions}
        if found is None:
            return optuna.trial.create_trial(state=optuna.trial.TrialState.FAIL, **known)
        excesses = {str(index): excess for index, excess in enumerate(found[1])}
        return optuna.trial.create_trial(
            values=found[0], **(known | ({"constraints": excesses} if excesses else {}))
        )


@dataclass(frozen=True)
class Search(Plan):
    """A plan whose values are known as far as the search has come."""

    design: Optimise
    axes: tuple[Axis, ...]
    seed: int
    known: dict[int, tuple[Any, ...]] = field(default_factory=dict)

    @classmethod
    def of(cls, design: Optimise, axes: tuple[Axis, ...], seed: int) -> "Search":
        """Return a search that has not begun."""
        known: dict[int, tuple[Any, ...]] = {}

        def values(number: int) -> tuple[Any, ...]:
            if number not in known:
                raise StudyError(
                    "not chosen yet",
                    got=f"variant {number + 1}",
                    expected="a variant that the search has come to",
                    hint="if it has a folder of its own, name that with `--out`",
                )
            return known[number]

        return cls(design.trials, values, design, axes, seed, known)

    def recall(self, rows: Iterable[Row]) -> None:
        """Take the values of variants from their rows."""
        for row in rows:
            self.known[row.variant - 1] = tuple(row.values[axis.name] for axis in self.axes)

    def rounds(self, rows: Callable[[], Iterable[Row]]) -> Iterator[list[int]]:
        """Yield the numbers of each round, from 1; `rows` has all of a round when it is over."""
        told: list[Any] = []
        for first in range(0, self.count, self.design.at_once):
            numbers = list(range(first + 1, min(first + self.design.at_once, self.count) + 1))
            asked = self._ask(first, len(numbers), told)
            for number, trial in zip(numbers, asked, strict=True):
                self.known[number - 1] = tuple(
                    _value(axis, trial.params[axis.name]) for axis in self.axes
                )
            yield numbers
            there = {row.variant: row for row in rows()}
            told += [
                self.design.trial(trial, there[number])
                for number, trial in zip(numbers, asked, strict=True)
            ]

    def _ask(self, first: int, count: int, told: Sequence[Any]) -> list["optuna.Trial"]:
        """Choose a round; a sampler of its own each time, whose numbers nothing else has used."""
        import optuna

        optuna.logging.set_verbosity(optuna.logging.ERROR)
        samplers = {"tpe": optuna.samplers.TPESampler, "random": optuna.samplers.RandomSampler}
        study = optuna.create_study(
            directions=[_DIRECTIONS[goal] for goal in self.design.objectives.values()],
            sampler=samplers[self.design.sampler](seed=(self.seed + first) % 2**32),
        )
        study.add_trials(told)
        choices = {axis.name: _choice(axis) for axis in self.axes}
        return [study.ask(choices) for _ in range(count)]


def _choice(axis: Axis) -> "optuna.distributions.BaseDistribution":
    """Return a variable as Optuna knows it: a quantile, or which of its values."""
    from optuna.distributions import (
        BaseDistribution,
        CategoricalDistribution,
        FloatDistribution,
        IntDistribution,
    )

    found: BaseDistribution
    if axis.levels is None:
        found = FloatDistribution(0.0, 1.0)
    elif _rises(axis.levels):
        found = IntDistribution(0, len(axis.levels) - 1)
    else:
        found = CategoricalDistribution(range(len(axis.levels)))
    return found


def _rises(levels: Sequence[Any]) -> bool:
    numbers = all(isinstance(v, int | float) and not isinstance(v, bool) for v in levels)
    return numbers and sorted(levels) == list(levels)


def _value(axis: Axis, chosen: Any) -> Any:
    if axis.levels is not None:
        return axis.levels[chosen]
    return axis.quantile(min(max(chosen, _EDGE), 1.0 - _EDGE))
