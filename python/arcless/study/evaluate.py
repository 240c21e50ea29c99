"""Variants → rows: the work of an executor, in this process or in a worker elsewhere."""

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError, ModelError
from arcless.model import Scenario, load
from arcless.simulate import Outcome, batch
from arcless.study.expressions import Expression, UndefinedError
from arcless.study.model import Study
from arcless.study.quantities import is_number, values
from arcless.study.rows import Row, Status
from arcless.study.variants import Variant
from arcless.study.version import code_version

WRONG_INPUT = 2
Take = Callable[[Row], None]
Cancel = Callable[[], bool]


@dataclass(frozen=True)
class Task:
    """What all variants of a study share, as plain data that travel to a worker.

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
    """

    scenario: dict[str, Any]
    outputs: dict[str, str]
    known: list[str]
    results: str | None

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
    running: dict[int, Variant] = {}

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
    )


class _Work:
    """A task in the making: the base scenario and the expressions, made once."""

    def __init__(self, task: Task) -> None:
        self.begun = 0
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

    def row(self, variant: Variant, outcome: Outcome) -> Row:
        """Return the row of a variant that was run; keep its result where that is asked for."""
        error, wall = outcome.error, outcome.wall_time_s
        if error is not None:
            # Input that only the mesh or the statics can refuse is input all the same.
            status: Status = "invalid" if error.exit_code == WRONG_INPUT else "failed"
            return _row(variant, status, {}, _reason(error), wall)
        assert outcome.assessment is not None
        if self._results is not None and outcome.result is not None:
            outcome.result.save(self._results / f"{variant.number:07d}.nc")
        numbers: dict[str, float | None] = values(outcome.assessment)
        numbers |= {name: v for name, v in variant.values.items() if is_number(v)}
        outputs: dict[str, float | None] = {}
        undefined = []
        for name, expression in self._outputs.items():
            try:
                outputs[name] = expression.value(numbers)
            except UndefinedError as none:
                outputs[name] = None
                undefined.append(f"{name}: {none}")
        return _row(variant, "done", outputs, "; ".join(undefined), wall)


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
