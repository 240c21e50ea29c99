"""Threads of this process: no cluster, no other package."""

from collections.abc import Iterator
from itertools import islice

from arcless.study.evaluation.evaluate import Cancel, Take, Task, evaluate
from arcless.study.evaluation.variants import Variant

# A batch remembers its members to the end; so many at once keep memory small, and waiting rare.
AT_ONCE = 10_000


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
        for _ in range(0, count, AT_ONCE):
            some = islice(variants, AT_ONCE)
            evaluate(task, some, take, workers=self._workers, cancel=cancel)

    def close(self) -> None:
        """Do nothing: no thread outlives `compute`."""
