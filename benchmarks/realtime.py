"""One step at a time, as a test bench takes them: contact force in, height of the wire out.

    python -m benchmarks.realtime [--fifo] [--steps 1000000]

Each step is timed twice: by the clock, and by the processor time of the thread. What the clock
shows beyond the processor time, the system did: it let something else run. A loop that does nothing
but read the clock, for as long, shows what the system does to any program on the machine then.
After 16 spans the same steps are taken again, to the bit: the least time of each over all rounds is
what it takes by itself, and the largest of these is the step that costs most.
With `--fifo` the system is asked for real-time priority, as a test bench would.
"""

import argparse
import gc
import math
import os
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.model import load
from arcless.simulate import Realtime, realtime
from benchmarks.tables import table
from benchmarks.whole_runs import SOLVED, SOLVED_IN_SPACE

CASES: tuple[tuple[str, str, dict[str, Any], int], ...] = (
    ("AC simple, 20 spans, planar", "en50318-ac-simple-320-planar", {}, 1_000_000),
    ("the same with a matrix", "en50318-ac-simple-320-planar", SOLVED, 1_000_000),
    ("in three dimensions", "en50318-ac-simple-320", {}, 1_000_000),
    ("the same with a matrix", "en50318-ac-simple-320", SOLVED_IN_SPACE, 100_000),
)
HEAD = ("µs per step", "steps", "least", "median", "99 %", "99.99 %", "largest", "over 100 µs")
LIMIT = 100.0  # the goal for the 99.99th percentile, µs
Times = NDArray[np.float64]


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="Time single steps.")
    parser.add_argument("--steps", type=int, help="fewer or more than a million")
    parser.add_argument("--fifo", action="store_true", help="ask for real-time priority")
    asked = parser.parse_args()
    print(_priority() if asked.fifo else "ordinary priority")
    print(table(HEAD, list(rows(asked.steps))))


def rows(steps: int | None = None) -> Iterator[list[str]]:
    """Yield a line of the table for each measurement."""
    gc.disable()  # a collection of Python's own takes milliseconds; the loop makes no cycles
    try:
        for title, name, changes, count in CASES:
            loop = realtime(load(name).with_(**changes))
            wall, own, again = measure(loop, steps or count)
            yield row(f"{title}: clock", wall)
            yield row(f"{title}: processor time", own)
            yield row("each step, the least of its rounds", again)
            yield row("a loop that does nothing, as long", idle(float(wall.sum())))
    finally:
        gc.enable()


def measure(loop: Realtime, steps: int, length: float = 880.0) -> tuple[Times, Times, Times]:
    """Return the times in µs of so many steps, which begin anew after so many m.

    By the clock, of the processor, and by the clock the least of each step over all rounds.
    """
    start, clock, own = loop.save(), time.perf_counter_ns, time.thread_time_ns
    end = loop.position_m + length
    taken, inside, least = np.zeros((2, steps)), 0, []
    for number in range(steps):
        if loop.position_m > end:
            loop.restore(start)
            inside = 0
        force = 170.0 + 80.0 * math.sin(0.04 * inside)
        a, b = own(), clock()
        loop.step(force)
        taken[:, number] = clock() - b, own() - a
        if inside == len(least):
            least.append(math.inf)
        least[inside] = min(least[inside], taken[0, number])
        inside += 1
    return taken[0] / 1e3, taken[1] / 1e3, np.array(least) / 1e3


def idle(duration: float) -> Times:
    """Return the times in µs between readings of the clock, some microseconds of nothing apart."""
    clock, pauses = time.perf_counter_ns, []
    before = clock()
    end = before + 1e3 * duration
    while before < end:
        for _ in range(200):
            pass
        now = clock()
        pauses.append(now - before)
        before = now
    return np.array(pauses) / 1e3


def row(title: str, times: Times) -> list[str]:
    """Return a line of the table for times in µs."""
    shown = [times.min(), *np.percentile(times, [50.0, 99.0, 99.99]), times.max()]
    over = str(np.count_nonzero(times > LIMIT))
    return [title, str(len(times)), *(f"{value:.1f}" for value in shown), over]


def _priority() -> str:
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(50))
    except (AttributeError, OSError) as error:
        return f"ordinary priority: {error}"
    return "real-time priority"


if __name__ == "__main__":
    main()
