"""The tutorial: its commands run in the order of its pages, and print what is shown."""

import itertools
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import fragments
import pytest
from typer.testing import CliRunner

from arcless.cli.app import app
from tests.interface.test_house import TARGETS

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "docs/tutorial"
PAGES = ("index", "first-run", "own-line", "signed-report")
MARK = r"(?:<!-- (not run|file|append|change)(?:: (.*?))? -->\n)?"
BLOCK = re.compile(MARK + r"```(\w+)\n(.*?)```", re.S)
# Programs of the system that the pages call.
OTHERS = ("sha256sum", "cmp")
MISTAKE = "-> 4,75,0"


def run(line: str, monkeypatch: pytest.MonkeyPatch) -> tuple[int, str]:
    """Run one command of a page; return its exit code and what it prints."""
    program, *words = shlex.split(line)
    if program == "mkdir":
        Path(words[0]).mkdir()
    elif program == "cd":
        monkeypatch.chdir(words[0])
        shutil.copytree(ROOT / "examples/valley", "valley-tables")
    elif program in OTHERS:
        if shutil.which(program) is None:
            pytest.skip(f"there is no {program} here")
        done = subprocess.run(line, shell=True, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout
    else:
        assert program == "arcless"
        told = CliRunner().invoke(app, words)
        return told.exit_code, told.output
    return 0, ""


def change(what: str) -> None:
    """Change a file as a page says: `FILE: BEFORE -> AFTER`."""
    name, _, change = what.partition(": ")
    before, after = change.split(" -> ")
    text = Path(name).read_text("utf-8")
    assert text.count(before) == 1
    Path(name).write_text(text.replace(before, after), "utf-8")


def is_printed(shown: str, printed: str) -> bool:
    """Return whether each line of a page begins one that was printed, up to rounding."""
    lines = printed.splitlines()
    return all(
        any(fragments.alike(line[: len(text)], text) for line in lines)
        for text in shown.splitlines()
    )


def test_the_tutorial(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for needed in ("typst", "matplotlib"):
        pytest.importorskip(needed)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")
    compared = 0
    for page in PAGES:
        printed = ""
        for mark, what, language, text in BLOCK.findall((FOLDER / f"{page}.md").read_text("utf-8")):
            if mark == "append":
                path = Path(what)
                path.write_text(path.read_text("utf-8") + text, "utf-8")
            elif mark == "file":
                assert Path(what).read_text("utf-8").startswith(text)
            elif language == "sh" and mark != "not run":
                if mark == "change":
                    change(what)
                printed = ""
                for line in text.splitlines():
                    code, more = run(line, monkeypatch)
                    # 3: the run is done, and a limit is not met; 2: the mistake that is shown.
                    judges = line.startswith(("arcless run ", "arcless assess "))
                    allowed = {2} if MISTAKE in what else {0, 3} if judges else {0}
                    assert code in allowed, (line, more)
                    printed += more
            elif language == "text":
                assert is_printed(text, printed), (text, printed)
                compared += 1
    assert compared > 12
    assert Path("valley.pdf").stat().st_size > 100_000


def test_the_next_step_of_each_page_is_the_next_page() -> None:
    texts = {page: (FOLDER / f"{page}.md").read_text("utf-8") for page in PAGES}
    for page, follower in itertools.pairwise(PAGES):
        assert re.search(rf"^Next: \[[^]]*\]\({follower}\.md\)\.$", texts[page], re.M), page


def test_the_commands_of_make_exist() -> None:
    named = re.findall(r"^make (\w+)$", (FOLDER / "index.md").read_text("utf-8"), re.M)
    assert named and set(named) <= set(TARGETS)
