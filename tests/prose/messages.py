"""Words of what the program says: help, messages, labels, units aside."""

import ast
from collections.abc import Iterator
from pathlib import Path

from tests.prose.words import unusual

FEWEST = 2  # words in a text that is said; a single one is a name

Found = Iterator[tuple[int, str]]


def documentation(tree: ast.AST) -> set[int]:
    """Return the identities of all docstrings in a module."""
    bodies = (getattr(node, "body", None) for node in ast.walk(tree))
    return {
        id(statement.value)
        for body in bodies
        if isinstance(body, list)
        for statement in body
        if isinstance(statement, ast.Expr)
    }


def said(source: str, *, docstrings: bool) -> Found:
    """Yield line and text of the strings in a module, docstrings only if they are help."""
    tree = ast.parse(source)
    left_out = set() if docstrings else documentation(tree)
    for node in ast.walk(tree):
        if not isinstance(node, ast.Constant) or id(node) in left_out:
            continue
        if isinstance(node.value, str) and len(node.value.split()) >= FEWEST:
            yield node.lineno, node.value


def in_program(path: Path) -> Found:
    """Yield the refused words in what a module says."""
    source = path.read_text(encoding="utf-8")
    for line, text in said(source, docstrings="commands" in path.parts):
        for offset, message in unusual(text):
            yield line + offset, message
