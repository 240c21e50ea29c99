"""Runs side by side and in any order

A run knows nothing of other runs: several at once in threads, and in another order, give the
bits of each of them alone. The core releases the interpreter while it steps, so the threads do
run at the same time.

Four runs on four uneven spans in space (`tests/support/small.py`), 1309 steps each: as it is,
with rigid contact, at another speed, and controlled from Python by an object that remembers.
Then one line, factorised once, on which three runs with other static forces step at the same
time.
"""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import count
from typing import Any
from unittest.mock import patch

import numpy as np

import arcless
from arcless import ControlInput
from arcless.results import Result
from arcless.simulate.setup import controllers, pantographs
from tests.support.faults import Fault
from tests.support.parts import unlike
from tests.support.python_faults import misled
from tests.support.small import differing, laid_out, small

Work = Callable[[], Result]
FORCES = (120.0, 150.0, 180.0)


class Damper:
    """Pushes against the speed of the head, through a filter that remembers."""

    def __init__(self) -> None:
        self.speed = 0.0

    def __call__(self, sample: ControlInput) -> float:
        self.speed += 0.1 * (sample.velocities_m_s[-1] - self.speed)
        return -40.0 * self.speed


def works() -> list[Work]:
    slow, rigid = small(speed="200 km/h"), small(**{"contact.law": "rigid"})
    damped = partial(arcless.run, small(), controllers={"P1": Damper()})
    return [partial(arcless.run, small()), partial(arcless.run, rigid), damped, damped,
            partial(arcless.run, slow)]  # fmt: skip


def test_order_and_threads(evidence: Any) -> None:
    asked = works()
    alone = [work() for work in asked]
    backwards = [work() for work in asked[::-1]][::-1]
    with ThreadPoolExecutor(len(asked)) as pool:
        together = list(pool.map(lambda work: work(), asked))
    for how, others in (("in the other order", backwards), ("in threads at once", together)):
        counts = [unlike(one, other) for one, other in zip(alone, others, strict=True)]
        evidence.same(
            f"five runs {how}, all numbers of their results",
            compared=sum(size for size, _ in counts),
            differing=sum(count for _, count in counts),
            reason="a run shares nothing with another one",
        )


def test_one_line_for_several_runs(evidence: Any) -> None:
    job = laid_out(small())

    def force(static: float) -> Any:
        return job.step([static], full=True)["force"]

    alone = [force(static) for static in FORCES]
    assert np.ptp([one.mean() for one in alone]) > 10.0, "three different runs"
    with ThreadPoolExecutor(len(FORCES)) as pool:
        together = list(pool.map(force, FORCES))
    counts = [differing(one, other) for one, other in zip(alone, together, strict=True)]
    evidence.same(
        "three runs at once on one factorised line: contact forces",
        compared=sum(size for size, _ in counts),
        differing=sum(count for _, count in counts),
        reason="a factorised line does not change while runs use it",
    )


def creeping(pantograph: Any, force: float, *rest: Any) -> tuple[Any, ...]:
    return pantograph, force + 1e-12 * next(RUNS), *rest


RUNS = count()
FAULTS = [
    Fault("a controller remembers the run before",
          patch.object(controllers, "fresh", lambda function: function), test_order_and_threads),
    Fault("each run adds 1e-12 N to the static force", misled(pantographs, "data", creeping),
          test_one_line_for_several_runs),
]  # fmt: skip
