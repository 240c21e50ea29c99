"""The shipped lines, pantographs and scenarios."""

from functools import cache
from pathlib import Path
from typing import NamedTuple

from arcless.model.reader import parse, read_text

FOLDER = Path(__file__).resolve().parent.parent / "models"


class LibraryEntry(NamedTuple):
    """A shipped model: kind, name, what it is, and the keys and citations of its sources."""

    kind: str
    name: str
    title: str
    source: str


@cache
def shipped(kind: str) -> dict[str, Path]:
    """Return the files of the shipped models of a kind, by name."""
    return {path.stem: path for path in sorted((FOLDER / f"{kind}s").glob("*.yaml"))}


def library() -> list[LibraryEntry]:
    """Return every shipped model: lines, then pantographs, then scenarios."""
    entries = []
    for kind in ("line", "pantograph", "scenario"):
        for name, path in shipped(kind).items():
            data, _ = parse(read_text(path, str(path)), str(path))
            source = "; ".join(f"{key}: {text}" for key, text in data["sources"].items())
            entries.append(LibraryEntry(kind, name, data["description"], source))
    return entries
