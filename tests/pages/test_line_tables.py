"""The page on line tables: its commands run, print what is shown, and change what it says."""

import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from arcless.model.line.parts.masses_and_inserts import Insert
from arcless.model.tables.sheets import SHEETS

pytest.importorskip("openpyxl")

PAGE = (Path(__file__).parents[2] / "docs/guide/line-tables.md").read_text("utf-8")
PARTS = re.compile(r"<!-- (file|change): (.*?) -->|```(\w+)\n(.*?)```", re.S)


def test_line_tables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    shown, printed, tried = None, [""], 0
    for what, argument, language, text in PARTS.findall(PAGE):
        if what == "change":
            file, old, new = re.split(r": | -> ", argument)
            before = Path(file).read_text("utf-8")
            assert before.count(f"\n{old}") == 1
            Path(file).write_text(before.replace(f"\n{old}", f"\n{new}"), "utf-8")
        elif what == "file":
            shown = argument
        elif language == "sh":
            printed = []
            for line in text.splitlines():
                program, *words = shlex.split(line)
                assert program == "arcless"
                done = CliRunner().invoke(app, words)
                printed.append(done.stdout + done.stderr)
        elif language == "python":
            exec(compile(text, "line-tables.md", "exec"), {"print": lambda changed: None})
        elif shown is not None:
            assert Path(shown).read_text("utf-8").startswith(text.rstrip("\n"))
            shown, tried = None, tried + 1
        else:
            assert text in printed or text == printed[0]
            tried += 1
    assert tried == 6
    assert Path("valley.yaml").exists()
    assert Path("again.xlsx").exists()


def test_every_sheet_and_column_is_on_the_page() -> None:
    told: dict[str, set[str]] = {}
    for name, row in re.findall(r"^\| `(\w+)` \|(.*)\|$", PAGE, re.M):
        told[name] = set(re.findall(r"`(\w+)`", row))
    assert told.keys() == SHEETS.keys()
    assert "droppers" in told["hangers"]
    assert "point_masses" in told["inserts"]
    for name in SHEETS.keys() - {"hangers"}:
        before = SHEETS["point_masses"].by_name if name == "inserts" else ()
        assert set(SHEETS[name].by_name) - set(before) <= told[name]


def test_inserts_have_what_point_masses_have() -> None:
    # The page says so, and adds what they have beyond them.
    assert set(SHEETS["point_masses"].by_name) < set(SHEETS["inserts"].by_name)
    assert set(SHEETS["inserts"].by_name) == set(Insert.field_names())
