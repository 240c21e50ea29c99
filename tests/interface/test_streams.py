"""Standard streams that the process was started without, as services and timed jobs do."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.interface.conftest import command

SHORT = Path(__file__).parent / "data" / "short.yaml"
CLOSED = ["2>&-", ">&-", "<&- >&- 2>&-"]
COMMANDS = [
    ("check", str(SHORT)),
    ("library",),
    ("statics", str(SHORT), "--json"),
    ("run", str(SHORT), "--out", "out", "--no-report"),  # which warns
]


def shell(folder: Path, words: tuple[str, ...], closed: str) -> subprocess.CompletedProcess[str]:
    """Run a command line with streams closed by a shell."""
    return subprocess.run(
        ["sh", "-c", f'exec "$@" {closed}', "sh", *command(*words)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


@pytest.mark.parametrize("closed", CLOSED)
@pytest.mark.parametrize("words", COMMANDS, ids=lambda words: words[0])
def test_commands_do_their_work(tmp_path: Path, words: tuple[str, ...], closed: str) -> None:
    done = shell(tmp_path, words, closed)
    assert done.returncode == 0, done.stderr
    assert "error" not in done.stderr
    if closed == "2>&-":
        assert done.stdout
    if words[0] == "run":
        found = sorted(path.name for path in (tmp_path / "out").iterdir())
        assert found == ["assessment.json", "result.nc"]


@pytest.mark.parametrize("closed", CLOSED)
def test_exit_codes_are_the_same(tmp_path: Path, closed: str) -> None:
    assert shell(tmp_path, ("check", "none.yaml"), closed).returncode == 2
    assert shell(tmp_path, ("replay", str(SHORT)), closed).returncode == 2


def test_no_file_takes_the_place_of_a_stream(tmp_path: Path) -> None:
    """The next file that is opened would get its number, and the output of libraries."""
    code = (
        "import os; from arcless.cli.process import start; start.open_missing_streams();"
        "print(os.open('x', os.O_CREAT | os.O_WRONLY), file=open('number', 'w'))"
    )
    words = ["sh", "-c", 'exec "$@" >&- 2>&-', "sh", sys.executable, "-c", code]
    subprocess.run(words, cwd=tmp_path, check=True)
    assert int((tmp_path / "number").read_text()) > 2


def test_a_full_standard_error_stops_nothing(tmp_path: Path) -> None:
    done = shell(tmp_path, ("run", str(SHORT), "--out", "out", "--no-report"), "2>/dev/full")
    assert done.returncode == 0
    assert (tmp_path / "out" / "result.nc").is_file()
