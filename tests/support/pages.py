"""Tables of pages, and the modules of docs/validation that make them."""

import importlib
import re
import sys
from pathlib import Path
from types import ModuleType

DOCS = Path(__file__).parents[2] / "docs"


def from_docs(name: str) -> ModuleType:
    """Import `docs/validation/NAME.py`, as `docs/make_validation.py` does."""
    if str(DOCS) not in sys.path:
        sys.path.append(str(DOCS))
    return importlib.import_module(f"validation.{name}")


def maker(name: str = "make_validation") -> ModuleType:
    """Import `docs/NAME.py`."""
    from_docs("runs")
    return importlib.import_module(name)


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


# Loss of contact and slack droppers make of rounding another course of events: some per cent.
REPEATS = 0.02
# Residuals below this are rounding, of which only that they are small is said.
NOTHING = 1e-9
NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def alike(cell: str, shown: str) -> bool:
    """Whether two cells say the same: equal words, numbers to a unit of their last digit or 2 %."""
    if NUMBER.sub("#", cell) != NUMBER.sub("#", shown):
        return False
    pairs = zip(NUMBER.findall(cell), NUMBER.findall(shown), strict=True)
    return all(_close(one, other) for one, other in pairs)


def _close(one: str, other: str) -> bool:
    now, then = (float(text.replace("−", "-")) for text in (one, other))
    if abs(now) < NOTHING and abs(then) < NOTHING:
        return True
    decimals = len(other.partition(".")[2].partition("e")[0])
    exponent = int(other.partition("e")[2] or 0)
    return abs(now - then) <= max(1.01 * 10.0 ** (exponent - decimals), REPEATS * abs(then))


def renewed(page: str, name: str, made: str) -> None:
    """Put a table into its page, row by row where a row says something else."""
    path = DOCS / "validation" / f"{page}.md"
    text, old = path.read_text(encoding="utf-8"), table(page, name)
    before, now = old.splitlines(), made.strip().splitlines()
    if len(before) == len(now):
        now = [o if alike(n, o) else n for o, n in zip(before, now, strict=True)]
    begin = f"<!-- table: {name} -->"
    head, _, rest = text.partition(begin)
    _, end, tail = rest.partition("<!-- end -->")
    path.write_text(head + begin + "\n\n" + "\n".join(now) + "\n\n" + end + tail, encoding="utf-8")
