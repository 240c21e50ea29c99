"""The README: its commands and its Python run, and its numbers are those of the pages it names."""

import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from tests.interface.test_house import TARGETS

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text("utf-8")
BLOCKS = re.findall(r"```(\w+)\n(.*?)```", README, re.S)
# What fits a screen: lines of text, those of blocks and headings included.
LONGEST = 80


def test_commands_and_python(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for language, text in BLOCKS:
        if language == "python":
            exec(text, {})
            continue
        for line in text.splitlines():
            program, *words = shlex.split(line)
            if program == "make":
                assert set(words) <= set(TARGETS)
                continue
            assert program == ".venv/bin/arcless"
            done = CliRunner().invoke(app, words)
            # 3: the run is done, and a limit is not met.
            assert done.exit_code in ((0, 3) if words[0] == "run" else (0,)), (line, done.output)
    assert (tmp_path / "runs/my-line/report.html").exists()


def test_the_readme_is_short() -> None:
    assert len(README.splitlines()) <= LONGEST


def test_its_numbers_are_those_of_the_pages() -> None:
    page = (ROOT / "docs/validation/en50318-2002.md").read_text("utf-8")
    rows = re.findall(r"^\| [23][50]0 km/h \|.*\| (\S+) \| A \|$", page, re.M)
    assert (len(rows), rows.count("inside")) == (16, 15)
    assert "| minimum contact force (N) | 50 to 75 | 44.8 |" in page
    assert "the minimum force at 250 km/h is 44.8 N" in README
