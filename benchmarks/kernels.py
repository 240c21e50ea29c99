"""Kernels of the core: what `cargo bench` prints, as rows; and a warm step of a whole run.

`cargo bench` has wall times of some microseconds, the fastest of which nothing has disturbed. A
warm step is what a longer run takes more than a shorter one, in processor time.
"""

import re
import subprocess
from pathlib import Path
from typing import Any

from arcless.model import load
from benchmarks.clock import REPEATS, timed
from benchmarks.whole_runs import SOLVED, SOLVED_IN_SPACE, Stepping

ROOT = Path(__file__).parents[1]
HEAD = ("kernel", "fastest", "median")
NAMES = {
    "factorisation": "factorisation",
    "solve": "solve",
    "contact_column": "contact column",
    "mass_product": "product with the mass matrix",
    "new_state": "new state",
    "lcp_warm": "complementarity problem: contact and droppers,",
}
LINES: dict[str, tuple[str, dict[str, Any]]] = {
    "planar": ("en50318-ac-simple-320-planar", SOLVED),
    "spatial": ("en50318-ac-simple-320", SOLVED_IN_SPACE),
    "planar, explicit": ("en50318-ac-simple-320-planar", {}),
    "spatial, explicit": ("en50318-ac-simple-320", {}),
}
SHORT, LONG = 1000, 3000  # steps
SECONDS = {"ns": 1e-9, "µs": 1e-6, "us": 1e-6, "ms": 1e-3, "s": 1.0}
LINE = re.compile(r"([├╰])─ (\w+)\s*([\d.]+) (\ws|s) *│ [\d.]+ \w+ *│ ([\d.]+) (\ws|s)")
GROUP = re.compile(r"^[├╰]─ (\w+) +│")


def output() -> str:
    """Run the kernels; returns what they print."""
    done = subprocess.run(
        ["cargo", "bench", "--package", "arcless-core", "--bench", "kernels"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode != 0:
        raise SystemExit(f"make bench: the kernels failed:\n{done.stderr[-2000:]}")
    return done.stdout


def rows() -> list[list[str]]:
    """Return kernels, then warm steps."""
    return [*read(output()), *(_warm(title, *line) for title, line in LINES.items())]


def read(printed: str) -> list[list[str]]:
    """Read divan's tree: groups, and in them names with fastest, slowest, median, mean."""
    found, group = [], ""
    for line in printed.splitlines():
        opened = GROUP.match(line)
        if opened:
            group = opened[1]
        match = LINE.search(line)
        if match is None:
            continue
        name = match[2]
        title = f"{NAMES[group]} {name}" if group in NAMES else f"{NAMES[name]}, {group}"
        times = (
            float(value) * SECONDS[unit] for value, unit in (match.group(3, 4), match.group(5, 6))
        )
        found.append([title, *map(_micro, times)])
    return found


def _warm(title: str, name: str, changes: dict[str, Any]) -> list[str]:
    """Time a step as the difference of two runs of the same start."""
    scenario = load(name).with_(**changes, **{"analysis.spans": None})
    start, length = scenario.travel_range()[0], scenario.speed * scenario.time_step_s
    ends = [start + (count + 0.5) * length for count in (SHORT, LONG)]
    runs = [Stepping.of(scenario.with_(**{"travel.end": end})).run for end in ends]
    taken = [[timed(run, 1).processor for run in runs] for _ in range(REPEATS)]
    steps = sorted((long - short) / (LONG - SHORT) for short, long in taken)
    return [f"warm step, {title}", _micro(steps[0]), _micro(steps[REPEATS // 2])]


def _micro(time: float) -> str:
    return f"{1e6 * time:.3g} µs"
