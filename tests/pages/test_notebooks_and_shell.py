"""Pages on notebooks and on the prompt: cells show what is printed, names are completed as told."""

import ast
import re
import shlex
from pathlib import Path
from typing import Any

import pandas
import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from arcless.cli.completion.scripts import VARIABLE

GUIDE = Path(__file__).parents[2] / "docs/guide"
BLOCK = re.compile(r"(<!-- not run[^>]*-->\n\n)?```(\w+)\n(.*?)```", re.S)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")


def shown_by(cell: str, names: dict[str, Any]) -> str:
    """Run a cell, and return its last expression as a prompt shows it."""
    *before, last = ast.parse(cell).body
    exec(compile(ast.Module(before, []), "cell", "exec"), names)
    if not isinstance(last, ast.Expr):
        exec(compile(ast.Module([last], []), "cell", "exec"), names)
        return ""
    with pandas.option_context("display.width", 120):
        return repr(eval(compile(ast.Expression(last.value), "cell", "eval"), names))


def test_cells_show_what_the_page_prints() -> None:
    names: dict[str, Any] = {}
    shown, compared = "", 0
    for left_out, language, text in BLOCK.findall((GUIDE / "notebooks.md").read_text("utf-8")):
        if language == "python":
            ast.parse(text)
            shown = "" if left_out else shown_by(text, names)
        else:
            assert shown.splitlines() == text.splitlines()
            compared += 1
    assert compared > 4


def test_tables_of_the_page_are_all_that_there_are() -> None:
    page = (GUIDE / "notebooks.md").read_text("utf-8")
    for names in (
        ("contact channels", "droppers", "supports"), ("quantities", "criteria"),
        ("numbers", "criteria", "fields"), ("droppers", "supports", "elasticity"),
    ):  # fmt: skip
        assert all(f'`"{name}"`' in page for name in names)


def test_the_tab_key_offers_what_the_page_says(monkeypatch: pytest.MonkeyPatch) -> None:
    from arcless.cli.completion import scripts

    page = (GUIDE / "shell.md").read_text("utf-8")
    rows = re.findall(r"^\| `(arcless [^`]*)` \| (.*) \|$", page, re.M)
    assert len(rows) > 6
    monkeypatch.setenv(VARIABLE, "complete_bash")
    scripts.listen()
    for typed, offers in rows:
        words = typed.split()
        monkeypatch.setenv("COMP_WORDS", "\n".join(words))
        monkeypatch.setenv("COMP_CWORD", str(len(words) - 1))
        told = CliRunner().invoke(app, [], prog_name="arcless").stdout.split()
        assert told == re.findall("`([^`]*)`", offers), typed


def test_commands_of_the_page_on_the_prompt() -> None:
    blocks = BLOCK.findall((GUIDE / "shell.md").read_text("utf-8"))
    lines = [line for _, language, text in blocks if language == "sh" for line in text.splitlines()]
    (told,) = [text for _, language, text in blocks if language == "text"]
    assert lines[0] == 'eval "$(arcless completion bash)"'  # tests/interface/test_completion.py
    *good, bad = [shlex.split(line)[1:] for line in lines[1:]]
    for words in good:
        assert CliRunner().invoke(app, words).exit_code in (0, 3), words
    refused = CliRunner().invoke(app, bad)
    assert (refused.exit_code, refused.stderr) == (2, told)
