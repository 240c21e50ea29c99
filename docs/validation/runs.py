"""Runs for the pages of this folder, and tables in their format."""

from collections.abc import Iterable

from validation.variants import Changes

import arcless
from arcless.results import Result

_known: dict[tuple[str, str], Result] = {}


def run(name: str, changes: Changes | None = None) -> Result:
    """Run a shipped scenario, once for the same changes."""
    key = name, repr(changes or {})
    if key not in _known:
        print(f"{name} {key[1][:100]}", flush=True)
        _known[key] = arcless.run(arcless.load(name).with_(**(changes or {})))
    return _known[key]


def table(head: Iterable[str], rows: Iterable[Iterable[object]]) -> str:
    lines = [list(head), *([str(cell) for cell in row] for row in rows)]
    rule = ["---"] * len(lines[0])
    return "\n".join(f"| {' | '.join(line)} |" for line in [lines[0], rule, *lines[1:]])


def escaped(text: str) -> str:
    """Return a text that stays in its cell."""
    return " ".join(text.replace("|", "\\|").split())
