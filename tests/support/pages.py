"""Tables of pages, and the modules of docs/validation that make them."""

import importlib
import sys
from pathlib import Path
from types import ModuleType

DOCS = Path(__file__).parents[2] / "docs"


def from_docs(name: str) -> ModuleType:
    """Import `docs/validation/NAME.py`, as `docs/make_validation.py` does."""
    if str(DOCS) not in sys.path:
        sys.path.append(str(DOCS))
    return importlib.import_module(f"validation.{name}")


def maker() -> ModuleType:
    """Import `docs/make_validation.py`."""
    from_docs("runs")
    return importlib.import_module("make_validation")


def table(page: str, name: str) -> str:
    """Return the text of a table of a page of docs/validation."""
    text = (DOCS / "validation" / f"{page}.md").read_text(encoding="utf-8")
    _, begin, rest = text.partition(f"<!-- table: {name} -->")
    found, end, _ = rest.partition("<!-- end -->")
    assert begin and end, f"{page}: no table {name}"
    return found.strip()


def cells(text: str) -> list[list[str]]:
    """Return the cells of a table without its head."""
    rows = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in rows[2:]]
