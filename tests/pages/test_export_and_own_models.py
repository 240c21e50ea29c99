"""Pages on export and on models of one's own: their commands run, and print what is shown."""

import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from arcless.cli.app import app

GUIDE = Path(__file__).parents[2] / "docs/guide"
BLOCK = re.compile(r"(?:<!-- file: (\S+) -->\n)?```(\w+)\n(.*?)```", re.S)


def blocks(page: str) -> Iterator[tuple[str, str, str]]:
    """Yield the file that a block shows the beginning of, its language, its text."""
    yield from BLOCK.findall((GUIDE / page).read_text("utf-8"))


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def run(text: str) -> str:
    """Run the commands of a block, and return what the last one prints."""
    printed = ""
    for line in text.splitlines():
        program, *words = shlex.split(line)
        if program == "mkdir":
            Path(words[0]).mkdir()
            continue
        assert program == "arcless"
        done = CliRunner().invoke(app, words)
        # 3: the run is done, and a limit is not met.
        assert done.exit_code in ((0, 3) if words[0] == "run" else (0,)), (line, done.stderr)
        printed = done.stdout
    return printed


def test_own_models() -> None:
    printed = ""
    for file, language, text in blocks("own-models.md"):
        if file:
            Path(file).write_text(text, "utf-8")
        elif language == "sh":
            printed = run(text)
        elif language == "text":
            assert text == printed
        else:
            assert Path("valley.yaml").read_text("utf-8").startswith(text)


def test_export() -> None:
    pytest.importorskip("openpyxl")
    pytest.importorskip("pyarrow")
    for file, language, text in blocks("export.md"):
        if language == "yaml":
            Path(file).write_text(text, "utf-8")
        elif language == "sh":
            run(text)
        elif language == "text":
            assert Path(file or "run.csv").read_text("utf-8").startswith(text.rstrip("\n"))


def test_what_matlab_is_told_to_plot_is_there() -> None:
    from scipy.io import loadmat

    (first,) = [text for _, language, text in blocks("export.md") if language == "matlab"]
    (commands, *_) = [text for _, language, text in blocks("export.md") if language == "sh"]
    run(
        "\n".join(
            line for line in commands.splitlines() if "xlsx" not in line and "parquet" not in line
        )
    )
    found = loadmat("run.mat", simplify_cells=True)
    names = re.findall(r"run\.contact_channels\.(\w+)", first)
    assert len(names) == 3
    assert set(names) <= set(found["contact_channels"])
