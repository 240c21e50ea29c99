"""A study of a thousand short runs: variants per second with one worker and with two, and where the
time goes that is not the core's.

The core works without the interpreter's lock. What else a variant takes, Python holds the lock for,
and no second worker can do it meanwhile. Two processes of one worker each have no lock in common:
what they do together is what the machine gives, and what two workers stay below it the lock takes.
"""

import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import astuple, dataclass
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from unittest.mock import patch

from arcless.simulate.runs.job import Job
from arcless.study import Execution, load, run
from arcless.study.folder import table
from arcless.study.journal.journal import Journal
from benchmarks.batch import spent

HEAD = (
    "workers", "variants/s", "× one worker", "processor ms/variant", "of it in the core",
    "in Python under the lock", "of that journal and table",
)  # fmt: skip
STUDY = Path(__file__).with_name("short-runs.yaml")
REPEATS = 2


@dataclass(frozen=True)
class Took:
    """What a study took: variants per second of its summary, processor ms of a variant."""

    rate: float
    processor: float
    core: float
    kept: float

    @property
    def python(self) -> float:
        """Processor ms of a variant that Python takes, in whichever thread."""
        return self.processor - self.core


def once(workers: int, count: int | None = None) -> Took:
    """Compute the study, or so many variants of it, from its beginning."""
    data = load(STUDY).to_dict()
    study = load(data if count is None else data | {"design": {**data["design"], "count": count}})
    core: list[float] = []
    kept: list[float] = []
    rate: list[float] = []

    def work() -> None:
        with TemporaryDirectory() as folder:
            how = Execution(kind="threads", workers=workers)
            rate.append(run(study, Path(folder), executor=how).rate or 0.0)

    with (
        _counted(Job, "step", core),
        _counted(Journal, "append", kept),
        _counted(table, "write", kept),
    ):
        taken = spent(work)
    ms = 1e3 / study.plan.count
    return Took(rate[0], ms * taken.processor, ms * sum(core), ms * sum(kept))


def apart(count: int | None = None) -> Took:
    """Compute half of the study in each of two processes."""
    half = (count or load(STUDY).plan.count) // 2
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        list(pool.map(once, (1, 1), (2, 2)))  # imports are no part of it
        one, other = pool.map(once, (1, 1), (half, half))
    halves = zip(astuple(one), astuple(other), strict=True)
    _, processor, core, kept = (0.5 * (a + b) for a, b in halves)
    return Took(one.rate + other.rate, processor, core, kept)


def rows(repeats: int = REPEATS, count: int | None = None) -> Iterator[list[str]]:
    """Compute the study each way, in turn; the fastest of each counts."""
    ways: dict[str, Callable[[int | None], Took]] = {
        "1": partial(once, 1),
        "2": partial(once, 2),
        "1 in each of two processes": apart,
    }
    once(1, 2)
    turns = [[way(count) for way in ways.values()] for _ in range(repeats)]
    best = [max(took, key=lambda one: one.rate) for took in zip(*turns, strict=True)]
    for workers, one in zip(ways, best, strict=True):
        yield [
            workers,
            f"{one.rate:.3g}",
            f"{one.rate / best[0].rate:.3g}",
            f"{one.processor:.3g}",
            f"{one.core:.3g}",
            f"{100 * one.python / one.processor:.0f} %",
            f"{100 * one.kept / one.python:.0f} %",
        ]


@contextmanager
def _counted(owner: Any, name: str, seconds: list[float]) -> Iterator[None]:
    """Add up the processor time of a function, in whichever thread it is called."""
    original: Callable[..., Any] = getattr(owner, name)

    def timed(*given: Any, **named: Any) -> Any:
        began = time.thread_time()
        try:
            return original(*given, **named)
        finally:
            seconds.append(time.thread_time() - began)

    with patch.object(owner, name, timed):
        yield
