"""A search: rounds of variants, each chosen by Optuna from the outputs of earlier ones.

Variants are chosen in rounds of `at_once`. A round follows from the seed and the rows of the
rounds before it alone, never from the order in which they came: so every executor gives the same
table, and a resumed study chooses as it would have done without a stop. Optuna chooses; the
journal is its memory.

Source: Bergstra et al., NeurIPS 24 (2011), tree-structured Parzen estimator, as in Optuna.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from arcless.errors import StudyError
from arcless.study.designs import Plan
from arcless.study.journal.row import Row
from arcless.study.optimisation.pruning import Monitoring
from arcless.study.optimisation.search_settings import SearchSettings
from arcless.study.variables.variables import Axis

if TYPE_CHECKING:
    import optuna

# Nearest to 0 and 1 that a quantile may lie, as in samples.
EDGE = 2.0**-53
DIRECTIONS: dict[str, Literal["minimize", "maximize"]] = {
    "minimise": "minimize", "maximise": "maximize",
}  # fmt: skip


@dataclass(frozen=True)
class Search(Plan):
    """A plan whose values are known as far as the search has come."""

    design: SearchSettings
    axes: tuple[Axis, ...]
    seed: int
    known: dict[int, tuple[Any, ...]] = field(default_factory=dict)

    @classmethod
    def of(cls, design: SearchSettings, axes: tuple[Axis, ...], seed: int) -> "Search":
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

    def rounds(
        self, rows: Callable[[int, int], Iterable[Row]]
    ) -> Iterator[tuple[list[int], Monitoring | None]]:
        """Yield the numbers of each round, from 1, and the quantities its runs are monitored by.

        `rows` gives those from one number to another; it has all of a round when that is over.
        """
        earlier: list[Row] = []
        told: list[Any] = []
        for first in range(0, self.count, self.design.at_once):
            numbers = list(range(first + 1, min(first + self.design.at_once, self.count) + 1))
            asked = self._ask(first, len(numbers), told)
            for number, trial in zip(numbers, asked, strict=True):
                self.known[number - 1] = tuple(
                    _value(axis, trial.params[axis.name]) for axis in self.axes
                )
            yield numbers, self.design.watch(earlier)
            there = {row.variant: row for row in rows(numbers[0], numbers[-1])}
            for number, trial in zip(numbers, asked, strict=True):
                earlier.append(there[number])
                told.append(frozen(self.design, there[number], trial.params, trial.distributions))

    def _ask(self, first: int, count: int, told: Sequence[Any]) -> list["optuna.Trial"]:
        """Choose a round; a sampler of its own each time, whose numbers nothing else has used."""
        import optuna

        optuna.logging.set_verbosity(optuna.logging.ERROR)
        samplers = {"tpe": optuna.samplers.TPESampler, "random": optuna.samplers.RandomSampler}
        study = optuna.create_study(
            directions=[DIRECTIONS[goal] for goal in self.design.objectives.values()],
            sampler=samplers[self.design.sampler](seed=(self.seed + first) % 2**32),
        )
        study.add_trials(told)
        choices = {axis.name: _choice(axis) for axis in self.axes}
        return [study.ask(choices) for _ in range(count)]


def frozen(
    design: SearchSettings,
    row: Row,
    params: Mapping[str, Any],
    distributions: Mapping[str, "optuna.distributions.BaseDistribution"],
    **attributes: Any,
) -> "optuna.trial.FrozenTrial":
    """Return a row as a trial of Optuna; one without values has failed.

    Of one that was pruned the values so far stand for those at the end.
    """
    from optuna.trial import TrialState, create_trial

    known: dict[str, Any] = {"params": dict(params), "distributions": dict(distributions)}
    known |= attributes
    if len(design.objectives) == 1:  # Optuna has no values so far of several
        (so_far,) = (row.so_far.get(name, []) for name in design.objectives)
        steps = {step: value for step, value in enumerate(so_far, start=1) if value is not None}
        known["intermediate_values"] = steps
    if row.status == "pruned":
        so_far_excess = {}
        for index, bound in enumerate(design.constraints):
            last = row.so_far.get(bound.output, [None])[-1]
            if last is not None:
                so_far_excess[str(index)] = bound.excess(last)
        return create_trial(state=TrialState.PRUNED, **known, **_constraints(so_far_excess))
    found = design.numbers(row)
    if found is None:
        return create_trial(state=TrialState.FAIL, **known)
    ends = {str(index): excess for index, excess in enumerate(found[1])}
    return create_trial(values=found[0], **known, **_constraints(ends))


def _constraints(excesses: dict[str, float]) -> dict[str, Any]:
    return {"constraints": excesses} if excesses else {}


def _choice(axis: Axis) -> "optuna.distributions.BaseDistribution":
    """Return a value as Optuna knows it: a quantile, or the index of a choice."""
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
    return axis.quantile(min(max(chosen, EDGE), 1.0 - EDGE))
