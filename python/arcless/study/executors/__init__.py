"""Executors: threads or Dask workers that compute variants, with the same rows."""

from collections.abc import Iterator
from typing import Protocol

from arcless.study.definition.study import Execution
from arcless.study.evaluation.evaluate import Cancel, Take, Task
from arcless.study.evaluation.messages import Note
from arcless.study.evaluation.variants import Variant

__all__ = ["Executor", "Note", "executor"]


class Executor(Protocol):
    """Interface of executors: objects that compute variants."""

    def compute(
        self, task: Task, variants: Iterator[Variant], count: int, take: Take, cancel: Cancel
    ) -> None:
        """Compute `count` variants; `take` is called with each row in this thread.

        Raises
        ------
        KeyboardInterrupt
            `cancel` returned True.
        ExecutorError
            Who computes went away; all rows that were taken stay.
        """

    def close(self) -> None:
        """Release the resources that `compute` needed and kept for its next call."""


def executor(how: Execution, note: Note) -> Executor:
    """Return the executor that a study asks for; `note` is told what a user should know.

    Raises
    ------
    StudyError, ExecutorError
        A package is missing; the scheduler does not answer.
    """
    if how.kind == "dask":
        from arcless.study.executors.dask import Dask

        return Dask(how, note)
    from arcless.study.executors.threads import Threads

    return Threads(how.workers)
