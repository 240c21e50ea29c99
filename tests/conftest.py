"""Fixtures of the evidence: `evidence` for verification files, `noticed` for their partners."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from arcless.validate.evidence import Noticed
from tests.support import records
from tests.support.evidence import Evidence, OutsideError

Check = Callable[..., None]


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--publish",
        action="store_true",
        help="write the records behind docs/validation instead of comparing with them",
    )


FAILED = pytest.StashKey[bool]()


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Iterator[None]:
    """Remember what failed: a failure that is expected counts as none in the session."""
    if call.when == "call":
        item.stash[FAILED] = call.excinfo is not None
    yield


def _is_slow(request: pytest.FixtureRequest) -> bool:
    return request.node.get_closest_marker("evidence") is not None


@pytest.fixture
def evidence(request: pytest.FixtureRequest) -> Iterator[Evidence]:
    """Collect the values of a verification test; compare them with their record, or write it."""
    found = Evidence(request.node.name, _is_slow(request))
    yield found
    if request.node.stash.get(FAILED, True):
        return  # what was not finished is not recorded
    file = Path(request.path)
    assert found.rows, "a verification test records at least one value"
    if request.config.getoption("--publish"):
        records.publish_rows(file, request.module, found.test, found.rows, found.figures)
    else:
        records.compare_rows(file, found.test, found.rows)


@pytest.fixture
def noticed(request: pytest.FixtureRequest) -> Iterator[Callable[..., None]]:
    """Show that a check notices a fault: `noticed("what is broken", check, **fixtures)`."""
    test, slow = request.node.name, _is_slow(request)
    found: list[Noticed] = []

    def notice(fault: str, check: Check, **fixtures: object) -> None:
        wants = check.__code__.co_varnames[: check.__code__.co_argcount]
        if "evidence" in wants:
            fixtures["evidence"] = Evidence()
        try:
            check(**fixtures)
        except OutsideError as error:
            row = error.row
            found.append(Noticed(fault, row.what, f"{row.value:.4g}; {row.allowed}", test, slow))
        except AssertionError as error:
            said = str(error).strip().partition("\n")[0]
            found.append(Noticed(fault, check.__name__.replace("_", " "), said[:80], test, slow))
        else:
            pytest.fail(f"{check.__name__} does not notice: {fault}")

    yield notice
    if request.node.stash.get(FAILED, True):
        return
    assert found, "a test of faults shows at least one"
    if request.config.getoption("--publish"):
        records.publish_faults(Path(request.path), request.module, test, found)
    else:
        records.compare_faults(Path(request.path), test, found)
