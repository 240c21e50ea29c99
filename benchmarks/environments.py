"""Environments of control: samples of one at a time, and of many by one call of the core.

    python -m benchmarks.environments [--samples 400]

A sample is five time steps of 1 ms of the whole line. Rates are of the clock, which alone shows
what several threads bring, so nothing else should run; the processor time of a sample is the other
column.
"""

import argparse
import os
import time
from collections.abc import Iterator

import numpy as np

from arcless import control
from benchmarks.tables import table

CASE = "en50318-ac-simple-320-planar"
HEAD = ("environments", "threads", "samples/s", "time steps/s", "ratio", "processor µs per sample")
MANY = (8, 32)


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="Time the samples of environments.")
    parser.add_argument("--samples", type=int, default=400, help="of each environment")
    asked = parser.parse_args()
    print(table(HEAD, list(rows(asked.samples))))


def rows(samples: int = 400) -> Iterator[list[str]]:
    """Yield a line of the table for each measurement."""
    task = control.task(CASE)
    steps = round(task.sample_time_s / task.line.time_step_s)
    single = one(task, samples)
    yield row("one `PantographEnv`", 1, single, single[0], steps)
    for count in MANY:
        for workers in sorted({1, len(os.sched_getaffinity(0))}):
            name = f"{count} in a `PantographVectorEnv`"
            yield row(name, workers, many(task, count, workers, samples), single[0], steps)


def row(
    name: str, threads: int, measured: tuple[float, float], alone: float, steps: int
) -> list[str]:
    """Return a line of the table, from samples per second and the processor time of one in s."""
    rate, used = measured
    shown = [f"{rate:.0f}", f"{rate * steps:.0f}", f"{rate / alone:.2f}", f"{1e6 * used:.0f}"]
    return [name, str(threads), *shown]


def one(task: control.Task, samples: int) -> tuple[float, float]:
    """Return samples in a second by the clock, and the processor time of one in s."""
    env = control.PantographEnv(task=task)
    env.reset(seed=1)
    began, used = time.perf_counter(), time.process_time()
    for _ in range(samples):
        env.step([0.1])
    return samples / (time.perf_counter() - began), (time.process_time() - used) / samples


def many(task: control.Task, count: int, workers: int, samples: int) -> tuple[float, float]:
    """Return samples in a second of all together, and the processor time of one in s."""
    env = control.PantographVectorEnv(count, task=task, workers=workers)
    env.reset(seed=1)
    actions = np.full((count, 1), 0.1)
    began, used = time.perf_counter(), time.process_time()
    for _ in range(samples):
        env.step(actions)
    all_of_them = samples * count
    wall, own = time.perf_counter() - began, time.process_time() - used
    return all_of_them / wall, own / all_of_them


if __name__ == "__main__":
    main()
