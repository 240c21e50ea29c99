"""A scenario whose pantograph is an FMU: shown without its code, run only where that is allowed."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.interface.test_fmu import MODEL, SHORT
from tests.studio.studio import Studio, Window
from tests.support import fmus

Start = Callable[[Path], Studio]
pytestmark = fmus.can_run
# Time in ms for a run on a busy machine, the start of the FMU's process included.
RUN = 120_000


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with a short scenario and its FMU."""
    monkeypatch.delenv("ARCLESS_ALLOW_FMU", raising=False)
    fmus.fmu(tmp_path)
    (tmp_path / "pantograph.yaml").write_text(MODEL, encoding="utf-8")
    head, _, rest = SHORT.read_text("utf-8").partition("pantographs:\n")
    placed = "pantographs:\n  - {model: pantograph.yaml, static_force: 80 N}\n"
    text = f"{head}{placed}{rest[rest.index('speed:') :]}"
    (tmp_path / "mine.yaml").write_text(text, encoding="utf-8")
    return tmp_path


def opened(studio: Start, folder: Path) -> Window:
    """Return a window with the scenario, its line drawn at rest."""
    page = studio(folder).open()
    page.wait("button.run:not([aria-disabled=true])")
    page.wait(".drawing canvas")
    assert page.js("document.querySelectorAll('.messages .error').length") == 0
    return page


def test_it_is_refused_with_what_allows_it(studio: Start, folder: Path) -> None:
    page = opened(studio, folder)
    page.press("Control+Enter")
    page.wait(".messages .error", patience=RUN)
    told = page.text(".messages .error")
    assert "pantograph P1 is an FMU, and FMUs are not allowed to run" in told
    assert "a studio that was started with the environment variable ARCLESS_ALLOW_FMU=1" in told
    assert "--allow-fmu" not in told
    assert not (folder / "runs").exists() or not list((folder / "runs").iterdir())
    page.click('role=tab[name="Hands on"]')
    page.click('role=button[name="Start the session"]')
    page.until("document.body.textContent.includes('an FMU runs in a process of its own')")
    assert "realtime(" not in page.js("document.body.textContent")


def test_it_runs_where_it_is_allowed(
    studio: Start, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ARCLESS_ALLOW_FMU", "1")
    page = opened(studio, folder)
    page.press("Control+Enter")
    page.wait(".transport", patience=RUN)
    page.until("document.querySelectorAll('.messages .error').length === 0")
