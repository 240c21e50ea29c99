"""The command of the campaign: what to look for, how long, and what was found."""

import argparse
import sys
import time
from collections import Counter
from pathlib import Path

from tests.hostile.campaign import border, models, receptances, texts
from tests.hostile.campaign.blocks import Kind, Place

KINDS = {
    "texts": Kind("texts", texts.case, 500),
    "models": Kind("models", models.case, 50),
    "receptances": Kind("receptances", receptances.case, 500),
    "calls": Kind("calls", border.case, 2000),
}
COUNTS = {"texts": 200_000, "models": 10_000, "receptances": 20_000, "calls": 800_000}


def main() -> int:
    """Search until each kind has as many cases as asked for, or its time is over."""
    options = arguments()
    place, found = Place(options.folder), 0
    for name, kind in KINDS.items():
        first, _, last = getattr(options, name).rpartition(":")
        until = None if options.seconds is None else time.monotonic() + options.seconds
        seeds = range(int(first or 0), int(last))
        for block in kind.blocks(seeds):
            if until is not None and time.monotonic() > until:
                break
            place.search(kind, block)
        counts, findings = place.told(kind, seeds)
        found += len(findings)
        show(name, seeds, counts, findings)
    return 1 if found else 0


def show(name: str, seeds: range, counts: Counter[str], findings: list[str]) -> None:
    """Print what became of the cases of a kind."""
    outcomes = ", ".join(f"{count} {outcome}" for outcome, count in counts.most_common())
    print(f"{name}: {counts.total()} of seeds {seeds.start} to {seeds.stop - 1}: {outcomes}")  # noqa: T201
    for finding in findings:
        print(f"  FOUND {name} {finding}")  # noqa: T201


def arguments() -> argparse.Namespace:
    """Read the command line."""
    parser = argparse.ArgumentParser(prog="python -m tests.hostile.campaign", description=__doc__)
    for name, count in COUNTS.items():
        parser.add_argument(
            f"--{name}", default=str(count), metavar="[FROM:]TO", help="seeds; 0 for none"
        )
    parser.add_argument("--seconds", type=float, help="for each kind; no limit without")
    parser.add_argument("--folder", type=Path, default=Path("target/fuzz/campaign"))
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
