"""Every verification file has a table of faults, and what both say is recorded, and nothing else.

The files are collected, not run: a test or fault has its record, a record its test or fault.
"""

from pathlib import Path

import pytest

import arcless
from arcless.validate.evidence import GROUPS
from tests.support import records
from tests.support.faults import Fault

HERE = Path(__file__).parent
FILES = [file for group in GROUPS for file in sorted((HERE / group).glob("test_*.py"))]


@pytest.fixture(params=FILES, ids=lambda file: "/".join(records.place(file)))
def module(request: pytest.FixtureRequest) -> pytest.Module:
    """A verification file as pytest collects it."""
    return pytest.Module.from_parent(request.node.parent.parent, path=request.param)


def test_what_is_recorded_is_what_is_tested(module: pytest.Module) -> None:
    record = records.load(*records.place(module.path))
    assert record.title and record.text, "the docstring is what the page says"
    assert record.version == arcless.__version__
    assert record.rows and record.faults, f"nothing recorded: run `{records.PUBLISH}`"
    tests = {test.name: test for test in records.measuring(module)}
    measured = {row.test: row.slow for row in record.rows}
    gone = set(measured) - set(tests)
    assert not gone, f"no test measures what is recorded: {records.AGAIN}"
    slow = {name: records.is_slow(test) for name, test in tests.items() if name in measured}
    assert measured == slow, records.AGAIN
    expected_to_fail = {name for name, test in tests.items() if test.get_closest_marker("xfail")}
    assert set(tests) - set(measured) <= expected_to_fail, f"not recorded: {records.AGAIN}"


def test_what_is_noticed_is_what_is_broken(module: pytest.Module) -> None:
    faults: list[Fault] = module.obj.FAULTS
    assert len({fault.name for fault in faults}) == len(faults) > 0
    recorded = records.load(*records.place(module.path)).faults
    assert [(fault.test, fault.fault, fault.slow) for fault in recorded] == [
        (fault.name, fault.what, fault.slow) for fault in faults
    ], records.AGAIN


def test_no_record_is_without_its_file() -> None:
    known = [records.path_of(*records.place(file)) for file in FILES]
    assert sorted(records.RECORDS.glob("*/*.json")) == sorted(known)
    assert len(known) > 20
