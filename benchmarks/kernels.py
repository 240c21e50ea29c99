"""Kernels of the core: what `cargo bench` prints, as rows."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[1]
HEAD = ("kernel", "fastest", "median")
NAMES = {
    "factorisation": "factorisation",
    "solve": "solve",
    "contact_column": "contact column",
    "mass_product": "product with the mass matrix",
    "new_state": "new state",
    "hundred_and_one_steps": "warm step",
    "hundred_and_one_steps_with_ledger": "warm step with energy ledger",
    "lcp_warm": "complementarity problem: contact and droppers,",
}
# A run of one step, and how many more the others take.
START, MORE = "begin_a_run", 100  # printed first: names are sorted
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


def rows(printed: str) -> list[list[str]]:
    """Read divan's tree: groups, and in them names with fastest, slowest, median, mean."""
    found, group, start = [], "", [0.0, 0.0]
    for line in printed.splitlines():
        opened = GROUP.match(line)
        if opened:
            group = opened[1]
        match = LINE.search(line)
        if match is None:
            continue
        name = match[2]
        times = [
            float(value) * SECONDS[unit] for value, unit in (match.group(3, 4), match.group(5, 6))
        ]
        if name == START:
            start = times
            continue
        if name.startswith("hundred"):
            times = [(time - begin) / MORE for time, begin in zip(times, start, strict=True)]
        title = f"{NAMES[group]} {name}" if group in NAMES else f"{NAMES[name]}, {group}"
        found.append([title, *(f"{1e6 * time:.3g} µs" for time in times)])
    return found
