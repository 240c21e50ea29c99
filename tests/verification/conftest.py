"""Shipped scenarios, each run once however many tests look at it; faults as tests of their own."""

from collections.abc import Callable, Iterator
from typing import Any

import pytest

import arcless
from arcless.results import Result
from tests.support import records
from tests.support.faults import Fault
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


def pytest_pycollect_makeitem(
    collector: pytest.Module, name: str, obj: object
) -> pytest.Collector | None:
    """Make tests of the table FAULTS of a verification file."""
    return Table.from_parent(collector, name=name, faults=obj) if name == "FAULTS" else None


class Table(pytest.Collector):
    """A table of faults: `FILE::FAULTS::CHECK[what is broken]`."""

    def __init__(self, *, faults: list[Fault], **more: Any) -> None:
        super().__init__(**more)
        self.faults = faults

    def collect(self) -> Iterator[pytest.Item]:
        # One fault of each table tells that the check can fail; the others belong to the evidence.
        quick = next((fault for fault in self.faults if not fault.slow), None)
        for number, fault in enumerate(self.faults):
            test = pytest.Function.from_parent(self, name=fault.name, callobj=self.test(number))
            if fault is not quick:
                test.add_marker("evidence")
            yield test

    def test(self, number: int) -> Callable[[pytest.FixtureRequest], None]:
        """Return the test that a fault is noticed, by what its record says, or write that."""

        def notice(request: pytest.FixtureRequest) -> None:
            found = self.faults[number].noticed(request.getfixturevalue)
            if request.config.getoption("--publish"):
                records.publish_fault(self.path, self.faults, found)
            else:
                records.compare_fault(self.path, found)

        return notice
