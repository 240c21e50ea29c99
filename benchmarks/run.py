"""All benchmarks, or some of them, as tables.

    make bench                              everything; of it ten minutes for the studio
    make bench PARTS="sides accuracy"       some parts
    make bench PAGE=yes                     and write the tables into docs/performance.md

Times are processor times, medians of five, taken in turn where runs are compared: what other
programs on the machine take is left out, but not what they take of caches and clock rate. Compare
lines of one output only. Counts repeat exactly. Rates and times of the studio are of the clock.
"""

import argparse
import sys
from collections.abc import Callable

from benchmarks import (
    accuracy,
    batch,
    environments,
    goals,
    kernels,
    lines,
    machine,
    realtime,
    side_by_side,
    speeds,
    studies,
    studio,
    whole_runs,
)
from benchmarks.tables import put, table


def say(text: str) -> None:
    """Tell on standard error what is being done."""
    print(text, file=sys.stderr, flush=True)


PARTS: dict[str, Callable[[], str]] = {
    "machine": lambda: "\n".join(f"- {line}" for line in machine.machine()),
    "kernels": lambda: table(kernels.HEAD, kernels.rows()),
    "goals": lambda: table(goals.HEAD, [row for part in goals.PARTS for row in part()]),
    "runs": lambda: table(whole_runs.HEAD, whole_runs.rows()),
    "spans": lambda: table(whole_runs.SPANS_HEAD, whole_runs.over_spans()),
    "lines": lambda: table(lines.HEAD, lines.rows()),
    "batch": lambda: table(batch.HEAD, list(batch.rows())),
    "studies": lambda: table(studies.HEAD, list(studies.rows())),
    "speeds": lambda: table(speeds.HEAD, list(speeds.rows())),
    "loop": lambda: table(realtime.HEAD, list(realtime.rows())),
    "environments": lambda: table(environments.HEAD, list(environments.rows())),
    "sides": lambda: table(side_by_side.HEAD, side_by_side.rows(say)),
    "studio": lambda: table(studio.HEAD, list(studio.rows(say))),
    "studio-long": lambda: table(studio.HEAD, list(studio.long_rows(say))),
    "accuracy": lambda: table(accuracy.HEAD, accuracy.rows()),
}


def main() -> None:
    """Measure, print, and write the page when asked to."""
    parser = argparse.ArgumentParser(description="Measure how fast Arcless is.")
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join(PARTS)}")
    parser.add_argument("--page", action="store_true", help="write docs/performance.md")
    asked = parser.parse_args()
    unknown = set(asked.parts) - set(PARTS)
    if unknown:
        parser.error(f"unknown part {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}")
    for name in asked.parts or PARTS:
        say(f"Measuring: {name}")
        text = PARTS[name]()
        print(f"\n{name}\n\n{text}", flush=True)
        if asked.page:
            put(name, text)


if __name__ == "__main__":
    main()
