"""The shipped lines, pantographs, scenarios, studies and wires."""

from pathlib import Path
from typing import NamedTuple
from warnings import warn

from arcless.model.files.yaml_reader import parse, read_text
from arcless.model.shipped.wire_catalogue import catalogue
from arcless.storage.shipped_files import FOLDER, FOLDERS, shipped

__all__ = ["FOLDER", "RENAMED", "LibraryEntry", "ModelRenamed", "find", "library", "shipped"]


# Earlier names of shipped models, which load until version 0.3: old name → new name.
RENAMED = {
    "scenario": {
        "ac-simple-3d-275": "en50318-ac-simple-275",
        "ac-simple-3d-320": "en50318-ac-simple-320",
    }
}


class ModelRenamed(FutureWarning):
    """A shipped model was asked for by a name that a later version will not know."""


class LibraryEntry(NamedTuple):
    """A shipped model: kind, name, what it is, and the keys and citations of its sources."""

    kind: str
    name: str
    title: str
    source: str


def find(kind: str, name: str) -> Path | None:
    """Return the file of the shipped model of a kind and a name, also of an earlier name.

    None if there is none. An earlier name gives the warning `ModelRenamed`.
    """
    known = shipped(kind)
    if name in known:
        return known[name]
    new = RENAMED.get(kind, {}).get(name)
    if new is None:
        return None
    text = f"{kind} {name} is now called {new}; the earlier name goes with version 0.3"
    warn(text, ModelRenamed, stacklevel=2)
    return known[new]


def library() -> list[LibraryEntry]:
    """Return what is shipped: lines, pantographs, scenarios, studies, wires lines may name."""
    entries = []
    for kind in FOLDERS:
        for name, path in shipped(kind).items():
            data, _ = parse(read_text(path, str(path)), str(path))
            entries.append(LibraryEntry(kind, name, data["description"], _cited(data["sources"])))
    book = catalogue()
    for name, wire in book.wires.items():
        origins = (book.origin_of(f"wires.{name}.{field}") for field in type(wire).model_fields)
        keys = {key for origin in origins if origin for key in origin.source_keys}
        cited = {key: text for key, text in book.sources.items() if key in keys}
        entries.append(LibraryEntry("wire", name, wire.description, _cited(cited)))
    return entries


def _cited(sources: dict[str, str]) -> str:
    cited = "; ".join(f"{key}: {text}" for key, text in sources.items())
    return cited or "no source: from memory or assumed, which the mark of each value says"
