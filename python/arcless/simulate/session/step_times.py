"""Times of the steps of a loop on this machine, and their lateness, next to an empty loop.

A bench releases step k at the time r_k = r_0 + k h of the clock. The thread wakes up at w_k ≥ r_k,
takes the step, and is done at d_k. Its computing time is d_k − w_k, its response time d_k − r_k;
the deadline is missed where d_k − r_k > h. A loop that does nothing at the same times has the
response of the system alone. Both take turns, so that both see the same machine.
"""

import gc
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.simulate.session.realtime import Realtime

Wait = Literal["sleep", "spin"]
Floats = NDArray[np.float64]
# Length in s of a turn of each of the two loops. Longer, they may see different machines.
TURN_S = 1.0
PERCENTILES = (50.0, 99.0, 99.99)
# Classes of a histogram: below the shortest time in s one, from there on two for each doubling.
_SHORTEST_S, PER_DOUBLING = 1e-6, 2
# Amplitude of the force put in, of the force at the start, and its wavelength in m: about a span.
_SWAY, _WAVELENGTH_M = 0.4, 60.0
Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]
# A step, and what is done between two of them.
Loop = tuple[Callable[[], None], Callable[[], None]]


@dataclass(frozen=True)
class Times:
    """Times of one loop.

    Attributes
    ----------
    computing_s
        From waking up to being done, s, one value for each step.
    response_s
        From the time at which a step was due to being done, s.
    deadline_s
        The time step, s.
    """

    computing_s: Floats
    response_s: Floats
    deadline_s: float

    @property
    def misses(self) -> int:
        """Number of steps that were done after the next one was due."""
        return int(np.count_nonzero(self.response_s > self.deadline_s))

    def percentiles(self, of: Literal["computing", "response"]) -> dict[str, float]:
        """Return least, 50th, 99th and 99.99th percentile and largest of the times, s."""
        times = self.computing_s if of == "computing" else self.response_s
        found = {f"{q:g} %": float(v) for q, v in zip(PERCENTILES, np.percentile(
            times, PERCENTILES, method="higher"), strict=True)}  # fmt: skip
        return {"least": float(times.min()), **found, "largest": float(times.max())}


@dataclass(frozen=True)
class StepTimes:
    """Times of the steps of a line, and of a loop that does nothing."""

    steps: Times
    empty: Times


def measure(
    loop: Realtime,
    end_m: float,
    seconds: float,
    *,
    wait: Wait = "sleep",
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> StepTimes:
    """Measure the steps of a loop, and an empty loop, each for so many seconds of the clock.

    The line begins again where it ends; that is not part of any step.

    Parameters
    ----------
    loop
        A loop at its start, which is where it begins again.
    end_m
        Position of the first pantograph, m, beyond which it begins again.
    seconds
        Time of each of the two, s.
    wait
        How the thread waits for a step: it sleeps, or it looks at the clock all the time, which
        takes the whole processor and wakes up sooner.
    progress, cancel
        As of `arcless.run`.

    Raises
    ------
    ModelError
        Fewer steps than one are asked for.
    ContactError
        A step cannot be solved.
    KeyboardInterrupt
        It was cancelled.
    """
    count = int(seconds / loop.time_step_s)
    if count < 1:
        raise ModelError("seconds", got=f"{seconds:g}", expected="one time step, or more")
    turn = max(1, min(count, round(TURN_S / loop.time_step_s)))
    stepping = Stepping(loop, end_m)
    loops: list[Loop] = [(stepping.step, stepping.begin_again), (_nothing, _nothing)]
    kept = [(np.empty(count), np.empty(count)) for _ in range(2)]
    waiting = _spin if wait == "spin" else _sleep
    with _no_garbage_collection():
        for first in range(0, count, turn):
            part = slice(first, min(first + turn, count))
            if cancel is not None and cancel():
                raise KeyboardInterrupt
            if progress is not None:
                progress(first / count, f"steps, {first * loop.time_step_s:.0f} of {seconds:g} s")
            for (computing, response), kind in zip(kept, loops, strict=True):
                _turn(computing[part], response[part], loop.time_step_s, kind, waiting)
    return StepTimes(*(Times(*times, loop.time_step_s) for times in kept))


def histograms(found: StepTimes) -> tuple[Floats, dict[str, NDArray[np.int64]]]:
    """Return edges of classes in s, and how many times lie in each, by name.

    The first class ends at 1 µs; each further one reaches to the square root of 2 of its start.
    """
    times = {
        "steps computing": found.steps.computing_s,
        "steps response": found.steps.response_s,
        "empty loop response": found.empty.response_s,
    }
    longest = max(float(each.max()) for each in times.values())
    doublings = max(1.0, np.floor(np.log2(max(longest, _SHORTEST_S) / _SHORTEST_S)) + 1.0)
    powers = np.arange(round(PER_DOUBLING * doublings) + 1) / PER_DOUBLING
    edges = np.concatenate([[0.0], _SHORTEST_S * 2.0**powers])
    return edges, {name: np.histogram(each, edges)[0] for name, each in times.items()}


class Stepping:
    """The steps that are measured: a force that sways along the line, from its start to its end.

    Parameters
    ----------
    loop, end_m
        The loop, and the position of its first pantograph, m, beyond which it begins again.
    """

    def __init__(self, loop: Realtime, end_m: float) -> None:
        self._loop, self._start, self._end_m = loop, loop.save(), end_m
        self._at_rest = np.array(loop.contact_force_N, copy=True)
        simulated = len(loop.displacement_m) > 0
        self._mean = np.zeros(len(loop.inputs)) if simulated else self._at_rest
        self._force = self._mean.copy()

    def step(self) -> None:
        """Take one step."""
        loop = self._loop
        sway = _SWAY * np.sin(2.0 * np.pi * loop.position_m / _WAVELENGTH_M)
        np.multiply(self._mean, 1.0 + sway, out=self._force)
        loop.step(self._force)

    def begin_again(self) -> None:
        """Go back to the start where the next step would leave the line."""
        loop = self._loop
        if loop.position_m + loop.speed_m_s * loop.time_step_s > self._end_m:
            loop.restore(self._start)


def _turn(
    computing: Floats, response: Floats, step_s: float, loop: Loop, wait: Callable[[int], int]
) -> None:
    """Let a loop run for as many steps as there is room for their times, s."""
    act, prepare = loop
    clock, every = time.perf_counter_ns, round(1e9 * step_s)
    due = clock() + every
    for number in range(len(computing)):
        woken = wait(due)
        act()
        done = clock()
        computing[number], response[number] = 1e-9 * (done - woken), 1e-9 * (done - due)
        due += every
        prepare()


def _sleep(due: int) -> int:
    """Sleep until a time in ns; return when it was over."""
    clock = time.perf_counter_ns
    left = due - clock()
    if left > 0:
        time.sleep(1e-9 * left)
    return clock()


def _spin(due: int) -> int:
    """Look at the clock until a time in ns; return when it was over."""
    clock = time.perf_counter_ns
    while (now := clock()) < due:
        pass
    return now


def _nothing() -> None:
    pass


@contextmanager
def _no_garbage_collection() -> Iterator[None]:
    """Keep Python from searching for garbage, which takes milliseconds; the loops make none."""
    was: Any = gc.isenabled()
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()
