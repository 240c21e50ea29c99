"""Threads of this process: no cluster, no other package."""

from collections.abc import Iterator

from arcless.study.evaluate import Cancel, Take, Task, evaluate
from arcless.study.variants import Variant


class Threads:
    """Computes in threads, through the batch of runs that shares what variants have in common.

    Parameters
    ----------
    workers
        Threads; all cores without.
    """

    def __init__(self, workers: int | None) -> None:
        self._workers = workers

    def compute(
        self, task: Task, variants: Iterator[Variant], count: int, take: Take, cancel: Cancel
    ) -> None:
        """Compute variants; see `Executor`."""
        del count
        evaluate(task, variants, take, workers=self._workers, cancel=cancel)
