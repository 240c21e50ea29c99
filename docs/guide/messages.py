"""The page of messages, made from docs/mistakes.yaml.

Each mistake is made in the example files of docs/reference/model-files.md, in an empty folder, and
what the command line says goes into the page as it is.
"""

import os
import re
import tempfile
from collections.abc import Iterator
from contextlib import chdir
from pathlib import Path
from typing import Any
from unittest.mock import patch

import yaml
from typer.testing import CliRunner

from arcless.cli.app import app

DOCS = Path(__file__).parents[1]
COUNT = 20
SCENARIO = "my-scenario.yaml"
# Messages are one line each; a terminal breaks them where it ends.
ENVIRONMENT = {"COLUMNS": "10000", "NO_COLOR": "1"}
HEAD = """# Common mistakes and their messages

The files are `my-line.yaml` and `my-scenario.yaml` of
[model files](../reference/model-files.md#an-example), each with one mistake. A message states the
place, the error, the given value (`got`), the `expected` one, and a `hint`. An error ends with exit
code 2; warnings alone do not.
"""


def examples() -> dict[str, str]:
    """Return the example files of the reference by their names."""
    text = (DOCS / "reference/model-files.md").read_text(encoding="utf-8")
    return {
        name: body for body, name in re.findall(r"```yaml\n(# (\S+\.yaml)\n.*?)```", text, re.S)
    }


def mistakes() -> list[dict[str, Any]]:
    """Return the cases."""
    found: list[dict[str, Any]] = yaml.safe_load(
        (DOCS / "mistakes.yaml").read_text(encoding="utf-8")
    )
    return found


def said(case: dict[str, Any]) -> tuple[str, int]:
    """Return what the command line says of a case, and its exit code."""
    files = examples() | case.get("also", {})
    if "old" in case:
        name = case.get("file", SCENARIO)
        if files[name].count(case["old"]) != 1:
            raise ValueError(f"{case['title']}: {case['old']!r} is not once in {name}")
        files[name] = files[name].replace(case["old"], case["new"])
    with (
        tempfile.TemporaryDirectory() as folder,
        chdir(folder),
        patch.dict(os.environ, ENVIRONMENT),
    ):
        for name, text in files.items():
            Path(name).write_text(text, encoding="utf-8")
        done = CliRunner().invoke(app, words(command(case)))
    return done.stderr.strip(), done.exit_code


def command(case: dict[str, Any]) -> str:
    """Return the command of a case."""
    given: str = case.get("run", f"arcless check {case.get('file', SCENARIO)}")
    return given


def words(line: str) -> list[str]:
    """Return the arguments of a command line."""
    return line.split()[1:]


def typed(case: dict[str, Any]) -> str:
    """Return what was typed: the line that is not as in the example, and the command."""
    shown = command(case)
    if "old" in case:
        name = case.get("file", SCENARIO)
        text = examples()[name].replace(case["old"], case["new"])
        fresh = [line for line in text.splitlines() if line not in examples()[name].splitlines()]
        shown = "\n".join([f"# {name}", *fresh, "", f"$ {shown}"])
    else:
        shown = f"$ {shown}"
    return shown


def page() -> str:
    """Return the text of the page.

    Raises
    ------
    ValueError
        There are not twenty mistakes, or of one the program says no error and no warning, or ends
        with another exit code than the page says.
    """
    return "".join(_parts())


def _parts() -> Iterator[str]:
    yield HEAD
    cases = mistakes()
    if len(cases) != COUNT:
        raise ValueError(f"{len(cases)} mistakes, the page has {COUNT}")
    for number, case in enumerate(cases, start=1):
        message, code = said(case)
        if not message.startswith(("error: ", "warning: ")) or "Traceback" in message:
            raise ValueError(f"{case['title']}: the program says {message!r}")
        if code != (2 if "error: " in message else 0):
            raise ValueError(f"{case['title']}: the program ends with {code}")
        yield f"\n## {number}. {case['title']}\n\n```text\n{typed(case)}\n```\n"
        yield f"\n```text\n{message}\n```\n\n{case['then']}\n"
