"""Runs that are computed again, because something is broken meanwhile."""

from typing import Any

import arcless
from arcless.results import Result
from arcless.simulate import StaticsResult


def run(name: str, changes: dict[str, Any] | None = None) -> Result:
    """Run a shipped scenario with changes by dotted path."""
    return arcless.run(arcless.load(name).with_(**(changes or {})))


def at_rest(name: str, changes: dict[str, Any] | None = None) -> StaticsResult:
    """Find the initial configuration of a shipped scenario with changes by dotted path."""
    return arcless.statics(arcless.load(name).with_(**(changes or {})))
