"""The words that the style page refuses, from its own table."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

STYLE = Path(__file__).parents[2] / "docs" / "style.md"
HEADING = "## Words"


@dataclass(frozen=True)
class Refused:
    """Words that are refused, as a pattern, and what to write instead."""

    pattern: re.Pattern[str]
    instead: str


def pattern(phrases: str) -> re.Pattern[str]:
    """Return the pattern of phrases like ``hold|s on, held on``: bars separate endings."""
    forms = []
    for phrase in phrases.split(","):
        words = []
        for word in phrase.split():
            stem, *endings = word.split("|")
            ending = f"(?:{'|'.join(map(re.escape, endings))})?" if endings else ""
            words.append(re.escape(stem) + ending)
        forms.append(r"\s+".join(words))
    return re.compile(rf"\b(?:{'|'.join(forms)})\b", re.IGNORECASE)


@cache
def refused() -> tuple[Refused, ...]:
    """Return the rows of the table on the style page.

    Raises
    ------
    ValueError
        The page has no such table.
    """
    text = STYLE.read_text(encoding="utf-8").partition(HEADING)[2]
    rows = [line.strip("| \n") for line in text.splitlines() if line.startswith("| ")]
    cells = [re.split(r"\s\|\s", row) for row in rows if not row.startswith("---")][1:]
    if not cells or any(len(row) != 2 for row in cells):
        raise ValueError(f"{STYLE}: a table of two columns is expected below `{HEADING}`")
    return tuple(Refused(pattern(left), right) for left, right in cells)


def unusual(text: str) -> Iterator[tuple[int, str]]:
    """Yield the line in the text, from 0, of each refused word, with what to write instead."""
    for row in refused():
        for match in row.pattern.finditer(text):
            found = " ".join(match[0].split())
            yield text.count("\n", 0, match.start()), f"`{found}`: write {row.instead}"
