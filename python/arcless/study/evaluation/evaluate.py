"""Variants → rows: the work of an executor, in this process or in a worker elsewhere."""

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError, ModelError
from arcless.model import Scenario, load
from arcless.simulate import Outcome, batch
from arcless.study.definition.expressions import Expression, UndefinedError
from arcless.study.definition.quantities import is_number, reasons, values
from arcless.study.definition.study import Study
from arcless.study.evaluation.run_monitor import RunMonitor
from arcless.study.evaluation.variants import Variant
from arcless.study.evaluation.version import code_version
from arcless.study.journal.row import Row, Status
from arcless.study.optimisation.pruning import Monitoring

WRONG_INPUT = 2
Take = Callable[[Row], None]
Cancel = Callable[[], bool]


@dataclass(frozen=True)
class Task:
    """Data that all variants of a study share, as plain data that travel to a worker.

    Attributes
    ----------
    scenario
        The base scenario.
    outputs
        Expressions by name of the output.
    known
        Names that they may use.
    results
        Folder for whole results; None keeps none.
    watch
        What runs are watched for while they step; None for nothing.
    """

    scenario: dict[str, Any]
    outputs: dict[str, str]
    known: list[str]
    results: str | None
    watch: Monitoring | None = None

    @classmethod
    def of(cls, study: Study, results: Path | None) -> "Task":
        """Return the task of a study."""
        outputs = {name: output.expression for name, output in study.outputs.items()}
        folder = None if results is None else str(results.absolute())
        return cls(study.base.to_dict(), outputs, study.known_keys(), folder)


def evaluate(
    task: Task,
    variants: Iterable[Variant],
    take: Take,
    *,
    workers: int | None = None,
    cancel: Cancel | None = None,
) -> None:
    """Compute variants, and hand each row on as it is there.

    Parameters
    ----------
    task
        What they share.
    variants
        Those that share a line had best follow each other.
    take
        Called with each row, in any order, in this thread.
    workers
        Threads; all cores without.
    cancel
        Asked now and then; ends the work with KeyboardInterrupt when it returns True.

    Raises
    ------
    OutputError
        A result cannot be kept.
    """
    work = _Work(task)
    running = work.running

    def scenarios() -> Iterator[Scenario]:
        for variant in variants:
            began = time.perf_counter()
            try:
                scenario = work.scenario(variant)
            except ModelError as error:
                take(_row(variant, "invalid", {}, _reason(error), time.perf_counter() - began))
            else:
                running[work.begun] = variant
                work.begun += 1
                yield scenario

    batch(
        scenarios(),
        keep="assessment" if task.results is None else "result",
        workers=workers,
        cancel=cancel,
        take=lambda outcome: take(work.row(running.pop(outcome.index), outcome)),
        watch=None if task.watch is None else work.watcher,
    )


class _Work:
    """A task in the making: the base scenario and the expressions, made once."""

    def __init__(self, task: Task) -> None:
        self.begun = 0
        self.running: dict[int, Variant] = {}
        self._watch, self._watchers = task.watch, dict[int, RunMonitor]()
        self._base = load(task.scenario)
        self._outputs = {name: Expression(text, task.known) for name, text in task.outputs.items()}
        self._results = None if task.results is None else Path(task.results)

    def scenario(self, variant: Variant) -> Scenario:
        """Return the scenario of a variant.

        Raises
        ------
        ModelError
            The values make none that is valid.
        """
        return self._base.with_(**variant.changes)

    def watcher(self, index: int, scenario: Scenario) -> RunMonitor:
        """Return who watches the runs of a variant that is running."""
        assert self._watch is not None
        searches = any(placed.mean_force is not None for placed in scenario.pantographs)
        numbers = _numbers(self.running[index])
        made = RunMonitor(self._watch, self._outputs, numbers, searches=searches)
        self._watchers[index] = made
        return made

    def row(self, variant: Variant, outcome: Outcome) -> Row:
        """Return the row of a variant that was run; keep its result where that is asked for."""
        watcher = self._watchers.pop(outcome.index, None)
        row = self._row(variant, outcome)
        if watcher is None:
            return row
        return replace(
            row, so_far=watcher.so_far, steps=outcome.steps, steps_of_run=outcome.steps_of_run
        )

    def _row(self, variant: Variant, outcome: Outcome) -> Row:
        error, wall = outcome.error, outcome.wall_time_s
        if outcome.stopped is not None:
            at = outcome.stopped
            row = _row(variant, "pruned", {}, at.why, wall)
            return replace(row, stopped_at_m=at.position_m, stopped_after_s=at.time_s)
        if error is not None:
            # Input that only the mesh or the statics can refuse is input all the same.
            status: Status = "invalid" if error.exit_code == WRONG_INPUT else "failed"
            return _row(variant, status, {}, _reason(error), wall)
        assert outcome.assessment is not None
        if self._results is not None and outcome.result is not None:
            outcome.result.save(self._results / f"{variant.number:07d}.nc")
        numbers: dict[str, float | None] = values(outcome.assessment)
        numbers |= _numbers(variant)
        outputs: dict[str, float | None] = {}
        undefined, why = [], reasons(outcome.assessment)
        for name, expression in self._outputs.items():
            try:
                outputs[name] = expression.value(numbers)
            except UndefinedError as none:
                outputs[name] = None
                undefined.append(f"{name}: {none}")
            else:
                undefined += [f"{name}: {why[key]}" for key in sorted(expression.names & set(why))]
        return _row(variant, "done", outputs, "; ".join(undefined), wall)


def _numbers(variant: Variant) -> dict[str, float]:
    """Return the values of a variant that expressions may use."""
    return {name: value for name, value in variant.values.items() if is_number(value)}


def failed(variant: Variant, why: str) -> Row:
    """Return the row of a variant that cannot be computed."""
    return _row(variant, "failed", {}, why, 0.0)


def _row(
    variant: Variant,
    status: Status,
    outputs: dict[str, float | None],
    error: str,
    wall_time_s: float,
) -> Row:
    return Row(
        variant=variant.number,
        key=variant.key,
        values=variant.values,
        status=status,
        outputs=outputs,
        error=error,
        wall_time_s=round(wall_time_s, 6),
        arcless_version=code_version(),
    )


def _reason(error: ArclessError) -> str:
    """Return what went wrong without the hint: it may name files of the machine that ran it."""
    error.hint = None
    return str(error)
