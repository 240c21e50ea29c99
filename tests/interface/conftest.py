"""The command line as a user meets it: in this process, or as a process of its own."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from arcless.cli.app import app

SHORT = Path(__file__).parent / "data" / "short.yaml"


@pytest.fixture
def arcless(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """Run a command line in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "160")
    return lambda *words: CliRunner().invoke(app, [str(word) for word in words])


@pytest.fixture
def process(tmp_path: Path) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Run a command line as a process in an empty folder."""

    def run(*words: object, **options: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            command(*words),
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
            **options,
        )

    return run


@pytest.fixture(scope="session")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of one finished run of the short scenario."""
    folder = tmp_path_factory.mktemp("finished") / "out"
    done = subprocess.run(
        command("run", SHORT, "--out", folder, "--quiet"),
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode in (0, 3), done.stderr
    assert (folder / "result.nc").is_file(), done.stderr
    return folder


@pytest.fixture
def short() -> Path:
    """Return the file of a scenario that runs in about a second."""
    return SHORT


def command(*words: object) -> list[str]:
    """Return the argument list of a process."""
    return [sys.executable, "-m", "arcless", *map(str, words)]
