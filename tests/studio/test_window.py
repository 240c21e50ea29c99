"""The window: what it shows at first, its keys, its sizes, what it says when the server is gone."""

from collections.abc import Callable
from pathlib import Path

from tests.studio.studio import Studio


def test_an_empty_folder(studio: Callable[[Path], Studio], tmp_path: Path) -> None:
    page = studio(tmp_path).open()
    page.wait("main")
    assert page.axe() == []
