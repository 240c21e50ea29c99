"""Endings of names of files, which say what is written to them."""

from collections.abc import Iterable
from pathlib import Path

from arcless.errors import OutputError
from arcless.units import show


def check_ending(path: Path, endings: Iterable[str], what: str, *, hint: str | None = None) -> str:
    """Return the ending of a name, in small letters, if it is one of those that are written.

    Parameters
    ----------
    path
        The file that is to be written.
    endings
        Those that are written, with their point and in small letters.
    what
        What is wrong with another one: ``"unknown kind of file"``.
    hint
        Help to choose another name.

    Raises
    ------
    OutputError
        The name ends otherwise.
    """
    ending, known = path.suffix.lower(), tuple(endings)
    if ending not in known:
        raise OutputError(
            what,
            where=str(path),
            got=show(path.suffix) if path.suffix else "a name without an ending",
            expected=f"a name that ends in {', '.join(known)}",
            hint=hint,
        )
    return ending
