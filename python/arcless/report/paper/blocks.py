"""Parts of a document on paper: texts, tables, figures, in sections; data without any look."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from arcless.figures.description import Figure
from arcless.report.summary import Bullet, Verdict

TableRows = Sequence[Sequence["Cell | str"]]
Tone = Literal["", "met", "not_met", "open", "soft"]


@dataclass(frozen=True)
class Cell:
    """A cell of a table: its text, a smaller one below it, and the meaning of its colour.

    `wide` says over how many columns it goes. A `command` is set as code that can be copied: its
    lines end only between two words of it.
    """

    text: str
    small: str = ""
    tone: Tone = ""
    wide: int = 1
    command: bool = False


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Attributes
    ----------
    title
        Title; it is repeated on each page.
    share
        Part of the width that it takes of those with one; 0 for as much as its texts need.
    is_number
        Whether it stands to the right.
    is_code
        Whether its texts are names of fields or commands.
    below
        Smaller text below the title, such as the unit.
    """

    title: str
    share: float = 0.0
    is_number: bool = False
    is_code: bool = False
    below: str = ""


@dataclass(frozen=True)
class Paragraph:
    """A text, `soft` where it only explains; of a `coded` one parts between backticks are code."""

    text: str
    soft: bool = False
    coded: bool = False


@dataclass(frozen=True)
class Points:
    """Texts in a list, below a title; of `coded` ones parts between backticks are code."""

    items: Sequence[str]
    title: str = ""
    coded: bool = False


@dataclass(frozen=True)
class Pairs:
    """Names with their meanings."""

    rows: Sequence[tuple[str, str]]


@dataclass(frozen=True)
class Code:
    """Commands, as they are typed."""

    text: str


@dataclass(frozen=True)
class Table:
    """A table, on as many pages as it needs."""

    columns: Sequence[Column]
    rows: TableRows


@dataclass(frozen=True)
class Judgement:
    """The verdict in a frame, with sentences below it."""

    verdict: Verdict
    texts: Sequence[Paragraph] = ()


@dataclass(frozen=True)
class Bars:
    """Criteria as bars against their limits; neighbours of one criterion together."""

    groups: Sequence[Sequence[Bullet]]


@dataclass(frozen=True)
class Pictures:
    """Figures that stand next to each other; one alone has the whole width."""

    figures: Sequence[Figure]


@dataclass(frozen=True)
class Heading:
    """A heading inside of a section."""

    title: str


Block = Paragraph | Points | Pairs | Code | Table | Judgement | Bars | Pictures | Heading


@dataclass(frozen=True)
class Section:
    """A section with its number, or an appendix with its letter; maybe on pages on their side."""

    title: str
    blocks: Sequence[Block]
    on_side: bool = False


@dataclass(frozen=True)
class Document:
    """A document: cover, contents, sections, appendices.

    Attributes
    ----------
    kind, title, description
        What it is, of what, and what that is.
    identity
        Label and text of what the cover says of it.
    verdict
        Headline of the cover; None for a document without one.
    date
        When what it reports was computed, ISO 8601; the document has no other date.
    version
        Version of Arcless that computed it.
    """

    kind: str
    title: str
    description: str
    identity: Sequence[tuple[str, str]]
    verdict: Verdict | None
    date: str
    version: str
    sections: Sequence[Section]
    appendices: Sequence[Section] = field(default=())
