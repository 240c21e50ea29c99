"""The work that has a goal in docs/performance.md, beside what is reached."""

import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from arcless.equilibrium import equilibrium
from arcless.model import Scenario, load
from benchmarks.clock import Taken, process, timed
from benchmarks.whole_runs import SOLVED, SOLVED_IN_SPACE, Stepping

HEAD = ("work", "goal", "reached", "wall time")
# The environment that users have, which starts faster than one with other programs on top.
OWN = Path(__file__).parents[1] / ".venv" / "bin" / "python"
COMMAND = (str(OWN) if OWN.exists() else sys.executable, "-m", "arcless")
REFERENCE, PLANAR = "en50318-ac-simple-320", "en50318-ac-simple-320-planar"
# Of all shipped scenarios this takes longest.
SLOWEST = "spain-ca-160-3kv-160"
STARTS = "{starts: 8, other_family: false}"


def _seconds(taken: Taken) -> list[str]:
    """Processor time and wall time."""
    return [f"{taken.processor:.3g} s", f"{taken.wall:.3g} s"]


def stepping() -> list[list[str]]:
    """Real-time factor of the stepping loops."""
    found = []
    for title, name, changes, goal in (
        ("AC simple, 20 spans, 320 km/h, 1 ms, three-dimensional", REFERENCE, {}, 50),
        ("the same with a matrix", REFERENCE, SOLVED_IN_SPACE, 50),
        ("planar", PLANAR, {}, 150),
        ("planar with a matrix", PLANAR, SOLVED, 150),
    ):
        one = Stepping.of(load(name).with_(**changes))
        taken, duration = timed(one.run), one.job.travel.duration
        reached = [f"{duration / taken.processor:.0f}", f"{taken.wall:.3g} s"]
        found.append([title, f"≥ {goal} × real time", *reached])
    return found


def at_rest() -> list[list[str]]:
    """Static equilibrium, from a loaded scenario."""
    found = []
    for spans, goal in ((20, "≤ 50 ms"), (900, "≤ 3 s")):
        scenario = of_spans(spans)
        taken = timed(lambda scenario=scenario: equilibrium.find(scenario))
        title = f"static equilibrium of AC simple, planar, {spans} spans"
        found.append([title, goal, *_seconds(taken)])
    return found


def of_spans(count: int) -> Scenario:
    """AC simple with another number of spans."""
    changes: dict[str, Any] = {"line.spans": [{"type": "standard", "count": count}]}
    return load(PLANAR).with_(**changes, **{"analysis.spans": None})


def processes() -> list[list[str]]:
    """Whole processes, from the shell's point of view."""
    with TemporaryDirectory() as folder:
        out = ("--out", str(Path(folder) / "out"), "--overwrite")
        run = [*COMMAND, "run", REFERENCE, "--no-report", *out]
        helped, ran = process([*COMMAND, "--help"]), process(run)
        sure = process([*run, "--set", f"certainty={STARTS}"])
        reported = process([*COMMAND, "run", REFERENCE, *out])
        slowest = process([*COMMAND, "run", SLOWEST, *out])
    runs = [f"{of / one:.2f} runs" for of, one in ((sure.processor, ran.processor),
                                                   (sure.wall, ran.wall))]  # fmt: skip
    return [
        ["`arcless --help`, whole process", "≤ 0.3 s", *_seconds(helped)],
        [f"`arcless run {REFERENCE} --no-report`", "≤ 1.0 s", *_seconds(ran)],
        ["the same with report", "≤ 1.6 s", *_seconds(reported)],
        [f"`arcless run {SLOWEST}`, with report", "≤ 2.5 s", *_seconds(slowest)],
        ["eight starts, without report and refined run", "≤ 2.5 runs", *runs],
    ]


PARTS: tuple[Callable[[], list[list[str]]], ...] = (stepping, at_rest, processes)
