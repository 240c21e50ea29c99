"""One browser for the session, and the pages that it opens."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.browser import kinds, tools
from tests.browser.browser import SCREENS, Browser, Page

HERE = Path(__file__).parent


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Bring the tests of a page together, so that each page is opened once."""
    at = [place for place, item in enumerate(items) if item.path.parent == HERE]
    for place, item in zip(at, sorted((items[place] for place in at), key=_page), strict=True):
        items[place] = item


def _page(item: pytest.Item) -> tuple[str, int]:
    params = item.callspec.params if hasattr(item, "callspec") else {}
    return str(params.get("file", "")), int(params.get("opened", 0))


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    if sentence := tools.missing():
        pytest.skip(sentence)
    found = Browser()
    yield found
    found.close()


@pytest.fixture(scope="session", params=kinds.PAGES)
def file(
    browser: Browser, request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    """Return the page of each kind."""
    return kinds.PAGES[request.param](tmp_path_factory.mktemp("page"))


@pytest.fixture(scope="session", params=SCREENS, ids=lambda width: f"{width} px")
def opened(browser: Browser, file: Path, request: pytest.FixtureRequest) -> Iterator[Page]:
    """Return the page of each kind, opened in a window of each width for all tests of it."""
    with browser.open(file, request.param) as found:
        yield found


@pytest.fixture
def page(opened: Page) -> Iterator[Page]:
    """Return that page as it was opened; no complaint and no request is left after a test."""
    yield opened
    opened.reset()
    assert opened.events == []
