"""The core knows nodes, elements, masses, springs, links and contacts; no word of the field.

Every type of line is made of the same few parts; a word of the field in the core would be the
first sign of a special case. Titles of cited papers may hold such words: lines that cite are left
out.
"""

import re
from pathlib import Path

CORE = Path(__file__).parents[2] / "crates" / "core" / "src"
WORDS = [
    "aerial",
    "trolley",
    "bridle",
    "messenger",
    "dropper",
    "hanger",
    "stitch",
    "catenary",
    "compound",
    "auxiliary",
    "pantograph",
    "registration",
    "steady.?arm",
    "conductor.?rail",
    "section.?insulator",
    "midpoint",
    "tension.?length",
    "encumbrance",
    "stagger",
    "presag",
    "pre-sag",
    "railway",
    "railroad",
    "train",
    "mast",
    "bogie",
    "balance.?weight",
    "tensioner",
]
CITED = ("Source", "(in Russian)", "et al", "& ", "Eng. Struct.")


def found(word: str) -> list[str]:
    pattern = re.compile(rf"\b{word}(s|ed|ing)?\b", re.IGNORECASE)
    return [
        f"{path.relative_to(CORE)}:{number}: {line.strip()}"
        for path in sorted(CORE.rglob("*.rs"))
        # Tests of what is private use the lines of the other tests, which are of the field.
        if not path.name.endswith("_tests.rs")
        for number, line in enumerate(path.read_text("utf-8").splitlines(), start=1)
        if pattern.search(line) and not any(mark in line for mark in CITED)
    ]


def test_the_core_knows_no_word_of_the_field() -> None:
    assert not [hit for word in WORDS for hit in found(word)]


def test_the_search_finds_what_is_there() -> None:
    assert found("node")
    assert found("link")
