"""Many runs that share a line and a time step: a batch beside the same runs one by one."""

import resource
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import arcless
from arcless.model import Scenario, load
from benchmarks.clock import process
from benchmarks.goals import COMMAND, REFERENCE

HEAD = (
    "runs", "how", "processor s/run", "wall s/run", "throughput, × one by one",
)  # fmt: skip
# Enough that what is made once counts for little: a hundredth of a run for each.
MEMBERS = 12
REPEATS = 2
SHORT = {
    "travel": {"start": "250 m", "end": "500 m"},
    "analysis": {"from": "300 m", "to": "450 m"},
}
STATIC = {"pantographs.0.static_force": "170 N"}
CASES: tuple[tuple[str, dict[str, Any]], ...] = (
    ("AC simple, 20 spans, static force given", STATIC),
    ("the same, mean force searched", {}),
    ("the same line, 250 m travelled, static force given", {**STATIC, **SHORT}),
)


@dataclass(frozen=True)
class Spent:
    """Processor time of all threads, and wall time, in s."""

    processor: float
    wall: float


def members(changes: dict[str, Any], count: int = MEMBERS) -> list[Scenario]:
    """Return scenarios that differ in speed, force and pantograph."""
    base = load(REFERENCE).with_(**changes)
    force = "static_force" if "pantographs.0.static_force" in changes else "mean_force"
    return [
        base.with_(
            **{
                "speed": f"{280 + 40 * i / count:g} km/h",
                f"pantographs.0.{force}": f"{160 + i % 5:g} N",
                "pantographs.0.model.masses.1.mass": f"{7 + 0.1 * (i % 7):g} kg",
            }
        )
        for i in range(count)
    ]


def spent(work: Callable[[], Any]) -> Spent:
    """Time something that uses several threads."""
    before, wall = resource.getrusage(resource.RUSAGE_SELF), time.perf_counter()
    work()
    wall = time.perf_counter() - wall
    after = resource.getrusage(resource.RUSAGE_SELF)
    user = after.ru_utime - before.ru_utime
    return Spent(user + after.ru_stime - before.ru_stime, wall)


def rows(
    cases: Sequence[tuple[str, dict[str, Any]]] = CASES, count: int = MEMBERS
) -> Iterator[list[str]]:
    """Run each case one by one, in a batch of one worker and of two, in turn."""
    for title, changes in cases:
        scenarios = members(changes, count)
        alone, one, two = least([
            lambda scenarios=scenarios: [arcless.run(each).assessment for each in scenarios],
            lambda scenarios=scenarios: arcless.batch(scenarios, workers=1),
            lambda scenarios=scenarios: arcless.batch(scenarios, workers=2),
        ])  # fmt: skip
        gained = alone.processor / one.processor
        scaled = gained * one.wall / two.wall
        yield _row(title, "one by one, `arcless.run(…).assessment`", alone, count, "1")
        yield _row("", "batch, one worker", one, count, f"{gained:.2g}")
        yield _row("", "batch, two workers", two, count, f"{scaled:.2g}")
        apart = command(changes)
        ratio = alone.processor / count / apart.processor
        how = "a process each, `arcless run --no-report`"
        yield _row("", how, apart, 1, f"{ratio:.2g}")


def command(changes: dict[str, Any]) -> Spent:
    """Time a process for one run, from the file to the saved result."""
    flat = {
        f"{path}.{key}" if key else path: value
        for path, given in changes.items()
        for key, value in (given.items() if isinstance(given, dict) else [("", given)])
    }
    asked = [word for path, value in flat.items() for word in ("--set", f"{path}={value}")]
    with TemporaryDirectory() as folder:
        out = str(Path(folder) / "out")
        taken = process([*COMMAND, "run", REFERENCE, "--no-report", "--out", out, *asked])
    return Spent(taken.processor, taken.wall)


def least(works: Sequence[Callable[[], Any]]) -> list[Spent]:
    """Return the least times of several things done in turn: others only add to them."""
    found = [[spent(work) for work in works] for _ in range(REPEATS)]
    return [
        Spent(min(s.processor for s in of), min(s.wall for s in of))
        for of in zip(*found, strict=True)
    ]


def _row(title: str, how: str, taken: Spent, count: int, ratio: str) -> list[str]:
    return [title, how, f"{taken.processor / count:.3g}", f"{taken.wall / count:.3g}", ratio]
