"""The page on reports on paper: its commands and its Python run, and make the files they name."""

import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from arcless.report.paper.fields import MOST_FIELDS, SIGNED
from arcless.study.report.variants import PRINTED
from tests.support.pdf import text_of
from tests.support.studies import written

PAGE = (Path(__file__).parents[2] / "docs/guide/pdf-report.md").read_text("utf-8")
BLOCKS = re.findall(r"```(\w+)\n(.*?)```", PAGE, re.S)


def run(line: str) -> str:
    """Run a command of the page, and return what it prints."""
    program, *words = shlex.split(line)
    assert program == "arcless"
    done = CliRunner().invoke(app, words)
    # 3: the run is done, and a limit is not met.
    assert done.exit_code in ((0, 3) if words[0] == "run" else (0,)), (line, done.output)
    return done.stdout


@pytest.mark.evidence
def test_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("typst", reason="typst is not installed")
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    monkeypatch.chdir(tmp_path)
    study = written(tmp_path)
    run(f"arcless study run {study} --quiet --out sweep")
    printed = ""
    for language, text in BLOCKS:
        if language == "sh":
            for line in text.splitlines():
                printed = run(line.replace("study report speed-sweep", "study report sweep"))
        elif language == "text":
            assert text == printed
        else:
            exec(text, {})
    files = {path.name for path in tmp_path.glob("*.pdf")}
    assert files == set(re.findall(r"--pdf (\S+\.pdf)", PAGE))
    assert files == {"run.pdf", "compared.pdf", "sweep.pdf"}
    assert "EX-001" in text_of(tmp_path / "run.pdf")


def test_numbers_and_names_are_those_of_the_program() -> None:
    assert MOST_FIELDS == 20
    assert "up to twenty times" in PAGE
    assert f"its variants (at most {PRINTED})" in PAGE
    assert ", ".join(f"`{name}`" for name in SIGNED) in PAGE
