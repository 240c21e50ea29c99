"""Files are text in UTF-8 with the line ends of their content, whatever the system prefers.

On Windows the encoding that nobody names is that of the country, and `\\n` becomes `\\r\\n`.
"""

import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.interface.test_imports import modules

# Calls that open a text, and the place of the encoding among their arguments.
OPENERS = {"read_text": 0, "write_text": 1, "open": 2, "fdopen": 2, "TextIOWrapper": 1}
# Methods and functions of other things that have the name of one.
OTHERS = {"arcless.studio.stream.routes", "arcless.studio.runs.motions"}
SCENARIO = "en50318-ac-simple-320-planar"


def unnamed(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Yield calls that open a text without naming its encoding, with their lines."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        function = node.func
        name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
        of = function.value if isinstance(function, ast.Attribute) else None
        if name not in OPENERS or (isinstance(of, ast.Name) and of.id in ("os", "study")):
            continue
        named = {keyword.arg for keyword in node.keywords}
        place = OPENERS[name] - (name == "open" and of is not None)
        if "encoding" in named or len(node.args) > place:
            continue
        texts = [argument.value for argument in node.args if isinstance(argument, ast.Constant)]
        if not any(isinstance(text, str) and "b" in text for text in texts):
            yield node.lineno, ast.unparse(node)


def test_every_text_names_its_encoding() -> None:
    found = [
        f"{name}:{line}: {call}"
        for name, path in modules().items()
        if name not in OTHERS
        for line, call in unnamed(ast.parse(path.read_text("utf-8")))
        if "self." not in call  # methods of ours
    ]
    assert found == []


@pytest.mark.parametrize("call", [
    "open(path)", "path.read_text()", "path.write_text(text)", "path.open('w')", "open(path, 'r')",
    "io.TextIOWrapper(raw)", "fdopen(number, 'w')",
])  # fmt: skip
def test_the_search_finds(call: str) -> None:
    assert [found for _, found in unnamed(ast.parse(call))] == [call]


@pytest.mark.parametrize("call", [
    "open(path, 'rb')", "path.read_text('utf-8')", "path.write_text(text, 'utf-8')",
    "path.open('w', encoding='utf-8')", "open(path, 'r', 1, 'utf-8')", "path.read_bytes()",
])  # fmt: skip
def test_the_search_passes(call: str) -> None:
    assert list(unnamed(ast.parse(call))) == []


DRIVER = """
import sys, warnings
warnings.filterwarnings("error", category=EncodingWarning, module=r"arcless(\\\\.|$)")
from arcless.cli.app import app
for line in sys.argv[1:]:
    try:
        app(line.split(), prog_name="arcless")
    except SystemExit as end:
        if end.code not in (0, 3):
            sys.exit(f"{line}: {end.code}")
"""
LINES = [
    "library",
    "new my-line --from norway-s25-250",
    "check my-line.yaml",
    f"statics {SCENARIO} --out rest",
    f"run {SCENARIO} --out run --set output.line_every=50 --until 400m",
    "report run",
    "explain run",
    "runs .",
    "export run --to values.csv",
    "measure run --to measured.csv",
    "assess run --from 200m --to 300m",
]


def test_no_command_leaves_it_to_the_system(tmp_path: Path) -> None:
    """A system whose own encoding is ASCII, which says each time that it was left the choice."""
    environment = {**os.environ, "PYTHONWARNDEFAULTENCODING": "1", "LC_ALL": "C",
                   "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "ARCLESS_TRACEBACK": "1",
                   "PYTHONIOENCODING": "utf-8"}  # fmt: skip
    done = subprocess.run(
        [sys.executable, "-c", DRIVER, *LINES], cwd=tmp_path, env=environment, check=False,
        capture_output=True, encoding="utf-8",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-2000:]
    texts = [path for path in tmp_path.rglob("*") if path.suffix in (".yaml", ".csv", ".json")]
    assert len(texts) >= 5
    for path in texts:
        assert "\r" not in path.read_bytes().decode("utf-8")
