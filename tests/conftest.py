"""The fixture `evidence` of verification files, and what all processes of tests inherit."""

import signal
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support import records
from tests.support.evidence import Evidence


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--publish",
        action="store_true",
        help="write the records behind docs/validation instead of comparing with them",
    )


def pytest_configure(config: pytest.Config) -> None:
    option = config.option
    records.check_selection(option.publish, option.markexpr, option.keyword)
    _heed_interrupts()


def _heed_interrupts() -> None:
    """Let programs that tests start be interrupted, also below a shell that runs in the background.

    Such a shell, or `nohup`, has SIGINT ignored, and whoever is started inherits that.
    """
    is_main = threading.current_thread() is threading.main_thread()
    if is_main and signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


FAILED = pytest.StashKey[bool]()


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Iterator[None]:
    """Remember what failed: a failure that is expected counts as none in the session."""
    if call.when == "call":
        item.stash[FAILED] = call.excinfo is not None
    yield


@pytest.fixture
def evidence(request: pytest.FixtureRequest) -> Iterator[Evidence]:
    """Collect the values of a verification test; compare them with their record, or write it."""
    found = Evidence(request.node.name, records.is_slow(request.node))
    yield found
    if request.node.stash.get(FAILED, True):
        return  # what was not finished is not recorded
    file = Path(request.path)
    assert found.rows, "a verification test records at least one value"
    if request.config.getoption("--publish"):
        tests = {test.name for test in records.measuring(request.node.getparent(pytest.Module))}
        records.publish_rows(
            file, request.module, found.test, found.rows, found.figures, tests=tests
        )
    else:
        records.compare_rows(file, found.test, found.rows)
