"""One browser for the session; a server for each folder."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from tests.browser.browser import Browser
from tests.browser.conftest import browser  # noqa: F401 - a fixture of this folder too
from tests.studio.studio import Studio


@pytest.fixture
def studio(browser: Browser) -> Iterator[Callable[[Path], Studio]]:  # noqa: F811
    """Return a function that starts the studio on a folder, for the time of a test."""
    with ExitStack() as stack:
        yield lambda folder: stack.enter_context(Studio(browser, folder))
