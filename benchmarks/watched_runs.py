"""Time of a run that is watched, and of one whose motion is recorded, beside the run alone.

As a worker process of the studio does it: pieces are written to a file without a name by a thread
of their own. Each run has a process of its own; those of a round follow one another, in another
order in each round, so that a slow moment of the machine does not always hit the same of them.
"""

import sys
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from benchmarks.long_line import SCENARIO, shorter

LONG = (SCENARIO, SCENARIO.with_name("long-line.yaml"))
WAYS = ("alone", "watched", "recorded")
# As in the worker processes of the studio: when the thread that steps gets its turn, s.
TURN_S = 2e-4


@dataclass(frozen=True)
class Took:
    """Times in s: of the processor, for the thread that steps and for all; of the steps, wall."""

    thread: float
    process: float
    steps: float


def take(way: str, spans: int | None) -> Took:
    """Run so many spans of the line of 50 km, or all of it, and save the result."""
    import arcless
    from arcless import simulate
    from arcless.platforms.shared_files import new_file
    from arcless.studio.motion.spool import SpoolWriter
    from arcless.studio.motion.watching import Watching

    sys.setswitchinterval(TURN_S)
    scenario = arcless.load(SCENARIO)
    if spans is not None:
        scenario = shorter(scenario, spans, one_wire=False)
    if way == "recorded":
        scenario = scenario.with_(**{"output.motion": True})

    def announce(layout: Any, _geometry: Any, **_ends: float) -> SpoolWriter:
        return SpoolWriter(spool.fileno(), layout.type, lambda *_grown: None)

    with TemporaryDirectory() as folder, new_file() as spool:
        file = Path(folder) / "result.nc"
        process, thread = time.process_time(), time.thread_time()
        to = file if simulate.is_long(scenario) else None
        if way == "watched":
            with Watching(scenario, announce) as watching:
                result = simulate.run(scenario, to=to, watch=watching)
        else:
            result = simulate.run(scenario, to=to)
        if to is None:
            result.save(file)
        thread, process = time.thread_time() - thread, time.process_time() - process
        return Took(thread, process, result.metadata["wall_time_s"])


def rounds(spans: int | None, count: int) -> list[dict[str, Took]]:
    """Run each way once in each of so many rounds."""
    found = []
    with ProcessPoolExecutor(1, get_context("spawn"), max_tasks_per_child=1) as pool:
        for n in range(count):
            ways = (*WAYS[n % len(WAYS) :], *WAYS[: n % len(WAYS)])
            took = {way: pool.submit(take, way, spans).result() for way in ways}
            found.append(took)
    return found


def ratios(found: Sequence[dict[str, Took]], way: str, of: str) -> tuple[float, float, float]:
    """Return median, least and largest of a time beside that of the run alone, round by round."""
    each = [getattr(one[way], of) / getattr(one["alone"], of) for one in found]
    return median(each), min(each), max(each)
