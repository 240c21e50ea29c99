"""Titles of sheets, and names of files → sheets of a line, notes of the office, and slips."""

import re
from collections.abc import Callable, Iterable
from difflib import get_close_matches

from arcless.errors import ModelError
from arcless.model.tables.sheets import SHEETS
from arcless.units import MAX_TEXT, show

# A title that begins with it is a note, whatever else it says.
NOTE = "#"
# A title as near to the name of a sheet as this is taken for a slip (`difflib`, from 0 to 1): of
# more, slips are passed over as notes of the office; of less, notes are refused.
SLIP = 0.75


def sheet_of(title: str) -> str | None:
    """Return the name of the sheet that a title is, in any case and with blanks, or None."""
    name = title.strip().lower().replace(" ", "_")
    return name if name in SHEETS else None


def sorted_out(
    titles: Iterable[str], stem: Callable[[str], str], where: str
) -> tuple[dict[str, str], list[str]]:
    """Return name of sheet by title, and titles that are no sheets of a line; notes are in neither.

    Parameters
    ----------
    titles
        Titles of sheets, or names of files.
    stem
        Title → what of it is compared.
    where
        Place of a title for messages, with braces for the title.

    Raises
    ------
    ModelError
        Two titles are one sheet; a title is nearly the name of a sheet, or has in it the name of
        one that is not there, as after "supports" was renamed to "supports rev B".
    """
    wanted: dict[str, str] = {}
    others = []
    for title in titles:
        if stem(title).strip().startswith(NOTE):
            continue
        name = sheet_of(stem(title))
        if name is None:
            others.append(title)
        elif name in wanted.values():
            raise ModelError("sheet given twice", where=where.format(title), got=show(title),
                             expected=f"one sheet {name}")  # fmt: skip
        else:
            wanted[title] = name
    missing = [name for name in SHEETS if name not in wanted.values()]
    for title in others:
        meant = _meant(stem(title), missing)
        if meant is not None:
            raise ModelError(
                "unknown sheet", where=where.format(title), got=show(title),
                expected=", ".join(SHEETS),
                hint=f"did you mean {meant}? a name that begins with {NOTE} is left out",
            )  # fmt: skip
    return wanted, others


def _meant(title: str, missing: Iterable[str]) -> str | None:
    """Return the sheet that a title which is none was probably meant for."""
    # No name of ours is longer; to look for a long text among many takes seconds.
    name = title.strip().lower().replace(" ", "_")[:MAX_TEXT]
    close = get_close_matches(name, SHEETS, n=1, cutoff=SLIP)
    if close:
        return close[0]
    letters = _letters(title)
    return next((own for own in missing if _letters(own).removesuffix("s") in letters), None)


def _letters(name: str) -> str:
    return re.sub(r"[\W_]+", "", name.lower())
