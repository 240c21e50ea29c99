"""Generated parts of pages: what stands between `<!-- table: NAME -->` and `<!-- end -->`.

A page keeps its prose; `docs/make_pages.py` writes its fragments, or says which are out of date.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from difflib import unified_diff
from pathlib import Path

DOCS = Path(__file__).parent
BEGIN = re.compile(r"<!-- table: ([\w-]+) -->")
END = "<!-- end -->"
# Loss of contact and slack droppers make of rounding another course of events: some per cent.
REPEATS = 0.02
# Residuals below this are rounding, of which only that they are small is said.
NOTHING = 1e-9
NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


@dataclass(frozen=True)
class Fragment:
    """One generated part of a page.

    Attributes
    ----------
    page, name
        The page below docs, without `.md`, and the name in the comment that begins the fragment.
    make
        Returns the text.
    slow
        Whether it takes more than some seconds, mostly for runs.
    computed
        Whether it has computed numbers, which other processors find with other rounding.
    """

    page: str
    name: str
    make: Callable[[], str]
    slow: bool = False
    computed: bool = True

    def printed(self) -> str:
        """Return the text that stands in the page."""
        return shown(self.page, self.name)

    def made(self) -> str:
        """Return the text as it should stand: printed lines stay where only rounding differs."""
        before, now = self.printed().splitlines(), self.make().strip().splitlines()
        if self.computed and len(before) == len(now):
            now = [o if alike(n, o) else n for o, n in zip(before, now, strict=True)]
        return "\n".join(now)


def path_of(page: str) -> Path:
    return DOCS / f"{page}.md"


def names(page: str) -> list[str]:
    """Return the names of the fragments of a page."""
    text = path_of(page).read_text(encoding="utf-8")
    found = BEGIN.findall(text)
    if text.count(END) != len(found) or len(set(found)) != len(found):
        raise SystemExit(f"{page}: a fragment has no end, or a name stands twice")
    return found


def shown(page: str, name: str) -> str:
    """Return the text of a fragment as it stands in its page."""
    text = path_of(page).read_text(encoding="utf-8")
    _, begin, rest = text.partition(f"<!-- table: {name} -->")
    found, end, _ = rest.partition(END)
    if not (begin and end):
        raise SystemExit(f"{page}: no place for the fragment {name}")
    return found.strip("\n")


def put(page: str, name: str, text: str) -> None:
    """Write a fragment into its page."""
    path = path_of(page)
    begin = f"<!-- table: {name} -->"
    head, _, rest = path.read_text(encoding="utf-8").partition(begin)
    _, end, tail = rest.partition(END)
    path.write_text(f"{head}{begin}\n\n{text}\n\n{end}{tail}", encoding="utf-8")


def cells(text: str) -> list[list[str]]:
    """Return the cells of a table without its head."""
    rows = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in rows[2:]]


def alike(line: str, printed: str) -> bool:
    """Whether two lines have equal words, and numbers to a unit of their last digit or 2 %."""
    words = (" ".join(NUMBER.sub("#", text).split()) for text in (line, printed))
    if len(set(words)) > 1:
        return False
    pairs = zip(NUMBER.findall(line), NUMBER.findall(printed), strict=True)
    return all(_close(one, other) for one, other in pairs)


def _close(one: str, other: str) -> bool:
    now, then = (float(text.replace("−", "-")) for text in (one, other))
    if abs(now) < NOTHING and abs(then) < NOTHING:
        return True
    decimals = len(other.partition(".")[2].partition("e")[0])
    exponent = int(other.partition("e")[2] or 0)
    return abs(now - then) <= max(1.01 * 10.0 ** (exponent - decimals), REPEATS * abs(then))


def changes(printed: str, made: str) -> list[str]:
    """Return the lines that differ between a printed text and the one that should stand there."""
    lines = unified_diff(printed.splitlines(), made.splitlines(), lineterm="", n=0)
    return [line for line in lines if not line.startswith(("---", "+++", "@@"))]
