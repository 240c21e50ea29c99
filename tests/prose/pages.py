"""Sentences, headings and words of pages in Markdown."""

import re
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token

from tests.prose.words import unusual

# Words between two stops, and semicolons outside of a list after a colon: rule 1 of docs/style.md.
LONGEST = 32
SEMICOLONS = 1
SENTENCE_END = re.compile(r"(?<=[.!?])\s+(?=[A-ZÄÖÜΑ-ω0-9`\"([*+±])")
WORD = re.compile(r"[^\W\d_]{2}")
STOP = re.compile(r"(?<=[:;])\s+")
# A heading is a noun or an instruction, not a clause.
CLAUSE = re.compile(r"(What|Who|Whose|Why|Where|When|Whether)\b(?!.*\?$)")
CELLS = ("td_open", "th_open")
HIDDEN = {"code_inline": "`code`", "softbreak": "\n", "hardbreak": "\n", "image": ""}

Found = Iterator[tuple[int, str]]


def texts(page: str) -> Iterator[tuple[int, str, str]]:
    """Yield line, kind (the token that opens it) and plain text of each block of a page."""
    tokens = MarkdownIt("commonmark").enable("table").parse(page)
    for before, token in pairwise(tokens):
        if token.type == "inline" and token.map is not None:
            yield token.map[0] + 1, before.type, plain(token.children or [])


def plain(children: list[Token]) -> str:
    """Return the text that a reader sees, with a placeholder for code."""
    return "".join(HIDDEN.get(child.type, child.content) for child in children)


def broken(page: str) -> Found:
    """Yield the lines of a page that break a rule, with the rule."""
    for line, kind, text in texts(page):
        for offset, message in unusual(text):
            yield line + offset, message
        if kind == "heading_open":
            if CLAUSE.match(text):
                yield line, f"the heading `{text}` is a clause: use a noun or an instruction"
        elif kind not in CELLS:
            yield from long_sentences(line, text)


def long_sentences(line: int, text: str) -> Found:
    """Yield the line and the fault of each sentence that says too much."""
    begin = 0
    for sentence in SENTENCE_END.split(text):
        begin = text.index(sentence, begin)
        at = line + text.count("\n", 0, begin)
        longest = max(map(words, STOP.split(sentence)))
        if longest > LONGEST:
            yield at, f"{longest} words without a stop: {LONGEST} are the most"
        elif sentence.partition(":")[0].count(";") > SEMICOLONS:
            yield at, "a sentence with several semicolons: split it"


def words(text: str) -> int:
    """Return the number of words; numbers and the symbols of formulas are none."""
    return sum(WORD.search(word) is not None for word in text.split())


def in_page(path: Path) -> Found:
    """Yield what is wrong with a page."""
    yield from broken(path.read_text(encoding="utf-8"))
