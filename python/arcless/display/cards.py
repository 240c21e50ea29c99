"""Objects as HTML for notebooks: a title, facts and tables, readable on light and on dark.

A card takes font colour and background from the notebook. It loads nothing, runs no script, and its
style reaches nothing outside. All texts are escaped here: names come from files.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import Literal, TypeAlias

State = Literal["met", "missed", "open"]

# Rows of a table that are shown; a notebook is no place to read thousands.
MOST_ROWS = 40
# White on each of the three colours has a contrast above 5; a sign says the same without colour.
_STYLE = (
    ".arcless-card{max-width:70em;overflow-x:auto;line-height:1.45}"
    ".arcless-card .arcless-title{font-weight:600;font-size:1.1em}"
    ".arcless-card .arcless-soft{opacity:.8}"
    ".arcless-card table.arcless-table{border-collapse:collapse;margin:.5em 0;border:0;"
    "color:inherit;table-layout:auto}"
    ".arcless-card .arcless-table tr{background:none}"
    ".arcless-card .arcless-table th,.arcless-card .arcless-table td{text-align:left;"
    "padding:.15em 1em .15em 0;border:0;border-bottom:1px solid rgba(128,128,128,.4);"
    "vertical-align:baseline;white-space:normal;max-width:none}"
    ".arcless-card .arcless-table th{font-weight:600}"
    ".arcless-card .arcless-table .arcless-n{text-align:right;white-space:nowrap;"
    "font-variant-numeric:tabular-nums}"
    ".arcless-card .arcless-badge{color:#fff;padding:.05em .5em;border-radius:.3em;"
    "white-space:nowrap}"
    ".arcless-card .arcless-met{background:#1a7f37}"
    ".arcless-card .arcless-missed{background:#b3261e}"
    ".arcless-card .arcless-open{background:#7a5900}"
    ".arcless-card summary{cursor:pointer}"
)
SIGNS: dict[State, str] = {"met": "✔", "missed": "✘", "open": "≈"}


@dataclass(frozen=True)
class Badge:
    """A verdict: its colour and sign, and its words."""

    state: State
    text: str


Cell: TypeAlias = str | Badge


def card(title: str, *parts: str, about: str = "") -> str:
    """Return a card.

    Parameters
    ----------
    title
        Kind and name, as text.
    *parts
        HTML, of the functions below.
    about
        A sentence below the title, as text.
    """
    head = f'<div class="arcless-title">{escape(title)}</div>'
    if about:
        head += f'<div class="arcless-soft">{escape(about)}</div>'
    return f'<div class="arcless-card"><style>{_STYLE}</style>{head}{"".join(parts)}</div>'


def verdict(badge: Badge, rest: str = "") -> str:
    """Return a verdict as a line of its own, with more words behind it."""
    more = f" {escape(rest)}" if rest else ""
    return f"<div>{_cell(badge)}{more}</div>"


def facts(rows: Sequence[tuple[str, Cell]]) -> str:
    """Return labels and what is said of each; those without words are left out."""
    lines = (
        f'<tr><th scope="row">{escape(label)}</th><td>{_cell(text)}</td></tr>'
        for label, text in rows
        if text
    )
    return f'<table class="arcless-table"><tbody>{"".join(lines)}</tbody></table>'


def table(
    titles: Sequence[str], rows: Sequence[Sequence[Cell]], *, numbers: Sequence[str] = ()
) -> str:
    """Return a table; of a long one the first rows, and how many more there are.

    Parameters
    ----------
    titles
        Of the columns.
    rows
        One cell for each column.
    numbers
        Titles of the columns that are set flush right.
    """
    classes = [' class="arcless-n"' if title in numbers else "" for title in titles]
    head = "".join(
        f'<th scope="col"{kind}>{escape(title)}</th>'
        for title, kind in zip(titles, classes, strict=True)
    )
    lines = [
        "".join(f"<td{kind}>{_cell(cell)}</td>" for cell, kind in zip(row, classes, strict=True))
        for row in rows[:MOST_ROWS]
    ]
    if len(rows) > MOST_ROWS:
        lines.append(f'<td colspan="{len(titles)}">… and {len(rows) - MOST_ROWS} more</td>')
    body = "".join(f"<tr>{line}</tr>" for line in lines)
    return (
        f'<table class="arcless-table"><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>'
    )


def folded(title: str, *parts: str) -> str:
    """Return parts that are shown when a reader asks for them."""
    return f"<details><summary>{escape(title)}</summary>{''.join(parts)}</details>"


def listed(texts: Sequence[str]) -> str:
    """Return sentences as a list."""
    return f"<ul>{''.join(f'<li>{escape(text)}</li>' for text in texts)}</ul>"


def _cell(cell: Cell) -> str:
    if isinstance(cell, str):
        return escape(cell)
    sign = SIGNS[cell.state]
    return f'<span class="arcless-badge arcless-{cell.state}">{sign} {escape(cell.text)}</span>'
