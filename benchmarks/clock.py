"""How long something takes, on a machine that may be busy with something else."""

import resource
import subprocess
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from typing import Any

REPEATS = 5


@dataclass(frozen=True)
class Taken:
    """Medians in s: processor time, and wall time, which counts waiting for other programs too."""

    processor: float
    wall: float
    memory: int = 0


def timed(work: Callable[[], Any], repeats: int = REPEATS) -> Taken:
    """Time something that this thread does alone."""
    found = []
    for _ in range(repeats):
        wall, processor = time.perf_counter(), time.thread_time()
        work()
        found.append((time.thread_time() - processor, time.perf_counter() - wall))
    return Taken(median(p for p, _ in found), median(w for _, w in found))


def interleaved(works: Sequence[Callable[[], Any]], repeats: int = REPEATS) -> list[Taken]:
    """Time several things in turn, so that a slow moment of the machine hits all of them."""
    found: list[list[Taken]] = [[] for _ in works]
    for _ in range(repeats):
        for taken, work in zip(found, works, strict=True):
            taken.append(timed(work, 1))
    return [
        Taken(median(t.processor for t in taken), median(t.wall for t in taken)) for taken in found
    ]


def process(command: Sequence[str], repeats: int = REPEATS) -> Taken:
    """Time whole processes; memory is the largest of their resident sets so far, in bytes."""
    found = []
    for _ in range(repeats):
        before, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run(command, check=False, capture_output=True)
        wall = time.perf_counter() - wall
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        found.append((spent, wall, 1024 * after.ru_maxrss))
    return Taken(
        median(p for p, _, _ in found), median(w for _, w, _ in found), max(m for *_, m in found)
    )
