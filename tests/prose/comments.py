"""Style of comments: house rule 3 of CONTRIBUTING.md; and the names in the nomenclature."""

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
LONGEST = 100

# Such a first line names nothing: it is understood from the line above it only.
UNNAMED = re.compile(r"(The same|What|It|Those|As|Who|Whether|How)\b")
UNUSUAL = re.compile(
    r"\b(but for|anew|in the place of|whoever|beside|c[ao]mes? out|g(o|oes|one) on)\b", re.I
)
NOMENCLATURE = ROOT / "docs" / "reference" / "nomenclature.md"
NAMES_IN_CODE = 3  # column of its tables
COMMENT = re.compile(r"\s*(///|//!|//) ?(.*)")

Found = Iterator[tuple[int, str]]


def docstrings(source: str) -> Found:
    """Yield line number and text of every docstring, those of fields included."""
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        for statement in node.body:
            value = statement.value if isinstance(statement, ast.Expr) else None
            if isinstance(value, ast.Constant) and isinstance(value.value, str):
                yield statement.lineno, value.value


def comments(source: str) -> Found:
    """Yield line number and text of every comment in Python, one of several lines as one."""
    block: list[str] = []
    first = last = 0
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type != tokenize.COMMENT:
            continue
        number, alone = token.start[0], not token.line[: token.start[1]].strip()
        if block and not (alone and number == last + 1):
            yield first, "\n".join(block)
            block = []
        first = first if block else number
        block.append(token.string.lstrip("# "))
        last = number if alone else 0
    if block:
        yield first, "\n".join(block)


def rust_comments(source: str) -> Found:
    """Yield line number and text of every comment that has lines of its own in Rust."""
    block: list[str] = []
    first, kind = 0, ""
    for number, line in enumerate([*source.splitlines(), ""], start=1):
        match = COMMENT.match(line)
        if block and (match is None or match[1] != kind):
            yield first, "\n".join(block)
            block = []
        if match is not None:
            first, kind = first if block else number, match[1]
            block.append(match[2])


def broken(found: Found) -> Found:
    """Yield the lines of comments that break a rule, with the rule."""
    for first, text in found:
        if UNNAMED.match(text):
            yield first, f"begins with `{text.split(maxsplit=1)[0]}`: name the thing or the action"
        for number, line in enumerate(text.split("\n"), start=first):
            for match in UNUSUAL.finditer(line):
                yield number, f"`{match[0]}`: use the usual word"


def in_python(path: Path) -> Found:
    """Yield what is wrong with a file in Python: of tests, with the docstrings' first lines."""
    source = path.read_text(encoding="utf-8")
    if path.is_relative_to(ROOT / "tests"):
        yield from broken((number, text.split("\n")[0]) for number, text in docstrings(source))
    else:
        yield from broken(docstrings(source))
        yield from broken(comments(source))


def in_rust(path: Path) -> Found:
    """Yield what is wrong with a file in Rust."""
    source = path.read_text(encoding="utf-8")
    yield from broken(rust_comments(source))
    for number, line in enumerate(source.splitlines(), start=1):
        if len(line) > LONGEST and "//" in line:
            yield number, f"a comment of {len(line)} characters: {LONGEST} are the most"


def unknown_names(sources: str) -> Found:
    """Yield the names in the nomenclature that stand nowhere in the sources."""
    known = set(re.findall(r"\w+", sources))
    for number, line in enumerate(NOMENCLATURE.read_text(encoding="utf-8").splitlines(), start=1):
        cells = line.strip("|").split("|")
        for name in re.findall(r"`(\w+)`", "".join(cells[NAMES_IN_CODE : NAMES_IN_CODE + 1])):
            if name not in known:
                yield number, f"`{name}` is no name in the code"
