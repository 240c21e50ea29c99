"""Shipped scenarios, each run once however many tests look at it."""

from collections.abc import Callable
from typing import Any

import pytest

import arcless
from arcless.results import Result
from tests.support.once import RunsOnce, folder_of_session

Run = Callable[..., Result]


@pytest.fixture(scope="session")
def run_once(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Run a shipped scenario with changes by dotted path; the same question is answered once."""
    runs = RunsOnce(folder_of_session(tmp_path_factory))

    def run(name: str, changes: dict[str, Any] | None = None) -> Result:
        key = repr((name, sorted((changes or {}).items())))
        return runs.answer(key, lambda: arcless.run(arcless.load(name).with_(**(changes or {}))))

    return run


@pytest.fixture(scope="session")
def at_rest() -> Callable[..., arcless.simulate.StaticsResult]:
    """Find the initial configuration of a shipped scenario, once for the same changes."""
    known: dict[tuple[str, str], arcless.simulate.StaticsResult] = {}

    def statics(name: str, changes: dict[str, Any] | None = None) -> arcless.simulate.StaticsResult:
        key = name, repr(sorted((changes or {}).items()))
        if key not in known:
            known[key] = arcless.statics(arcless.load(name).with_(**(changes or {})))
        return known[key]

    return statics
