"""The page on measured runs: its programs run; files, numbers and messages are as shown."""

import json
import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from arcless.cli.app import app

PAGE = (Path(__file__).parents[2] / "docs/guide/measurements.md").read_text("utf-8")
BLOCK = re.compile(r"(?:<!-- (\w+)(?:: (\S[^\n]*))? -->\n)?```(\w+)\n(.*?)```", re.S)
ROW = re.compile(r"^\| (?:`(.*)`|nothing) \| ((?:run\.csv|--).*) \|$", re.M)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("COLUMNS", raising=False)


def arcless(line: str) -> Result:
    program, *words = shlex.split(line)
    assert program == "arcless"
    return CliRunner().invoke(app, words)


def numbers(line: str) -> str:
    [found] = json.loads(arcless(line).stdout)["pantographs"]
    return f"{found['mean_force_N']:.1f} N and {found['std_force_N']:.1f} N"


def test_programs_commands_and_what_they_print(capsys: pytest.CaptureFixture[str]) -> None:
    names: dict[str, object] = {}
    done, shown = None, 0
    for kind, what, language, text in BLOCK.findall(PAGE):
        if language == "python":
            exec(text, names)
        elif language == "sh":
            for line in text.splitlines():
                done = arcless(line)
                assert done.exit_code in (0, 3), (line, done.stderr)
                last = line
        elif kind == "file":
            assert Path(what).read_text("utf-8").startswith(text)
        elif kind == "printed":
            assert text in done.stdout
        elif kind == "found":
            without = re.sub(r'--head-(mass|lift) "[^"]*"', "", last)
            assert text == f"{numbers(last)}; without --head-mass {numbers(without)}\n"
        else:
            pytest.fail(f"a block that nothing tries: {text}")
        shown += 1
    assert shown == len(re.findall(r"^```\w", PAGE, re.M))
    assert Path("test-run.html").stat().st_size > 0
    assert capsys.readouterr().out.endswith(" N\n")


@pytest.mark.parametrize(("content", "message"), ROW.findall(PAGE))
def test_files_that_are_refused(content: str, message: str) -> None:
    text = content.replace("⏎", "\n")
    Path("run.csv").write_text(text + "\n" if text else "", "utf-8")
    done = arcless("arcless assess run.csv")
    told = re.sub(r"a force \(N, kN,[^)]*\)", "a force (N, kN, …)", done.stderr)
    assert (done.exit_code, told) == (2, f"error: {message}\n")


def test_every_refusal_of_the_page_is_tried() -> None:
    rows = PAGE.split("## Refusals")[1].split("|---|---|\n")[1].split("\n\n")[0]
    assert len(ROW.findall(PAGE)) == len(rows.splitlines()) > 10


def test_every_known_column_is_listed() -> None:
    from arcless.measurements.table.columns import KNOWN

    table = PAGE.split("## Columns")[1].split("Units are")[0]
    assert set(re.findall(r"`([a-z_]+?)(?:_\d)? \[", table)) == set(KNOWN)
