"""Tables of a line → its model file: what they change is rewritten, every other byte stays."""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path as FilePath
from typing import Any

from arcless.errors import ModelError
from arcless.model.edit import change, remove, write_text
from arcless.model.fields.part import Path
from arcless.model.files.text_patches import added, find, folded, removed, replaced
from arcless.model.files.yaml_nodes import Node, compose
from arcless.model.files.yaml_reader import Origin, parse, read_text
from arcless.model.line.line import Line
from arcless.model.scenario.references import build
from arcless.model.tables.files import read_tables
from arcless.model.tables.over import Tables, laid
from arcless.units import plain

TYPES = "span_types"


@dataclass(frozen=True)
class Edited:
    """A line file with tables laid over it.

    Attributes
    ----------
    text
        The new text.
    changed
        Dotted paths of what is another value now.
    read
        Names of the sheets that were read.
    left_out
        Sheets or files that are no tables of a line.
    """

    text: str
    changed: list[str]
    read: list[str]
    left_out: list[str]


@dataclass(frozen=True)
class _TableOrigin(Origin):
    """Where the fields of a line come from: cells of tables, and lines of its file for the rest."""

    places: Mapping[Path, str] = field(default_factory=dict)

    def where(self, path: Path = ()) -> str | None:
        """Return the cell that a field, or the nearest thing around it, came from."""
        own = tuple(part for part in path if part != "value")
        for count in range(len(own), 1, -1):
            if own[:count] in self.places:
                return self.places[own[:count]]
        return super().where(path)


def edited_line(text: str, label: str, tables: str | os.PathLike[str]) -> Edited:
    """Return the text of a line file with tables laid over it; nothing is written.

    Values that the tables change lose their marks and sources, and say in a note which file they
    are from.

    Parameters
    ----------
    text, label
        The text of a valid line file, and its name in messages.
    tables
        A workbook, or a folder with CSV files; see `read_tables`.

    Raises
    ------
    ModelError
        The line is not valid, a table is wrong, or the line would not be valid with it; then the
        message says in which row and column.
    """
    data, positions = parse(text, label)
    line = build(data, "line", Line, Origin(label, positions=positions))
    read, left_out = read_tables(FilePath(tables))
    new, changed, places = _laid_over(text, label, line, read, FilePath(tables).name)
    data, positions = parse(new, label)
    build(data, "line", Line, _TableOrigin(label, positions=positions, places=places))
    return Edited(new, changed, list(read), left_out)


def edit_line(file: str | os.PathLike[str], tables: str | os.PathLike[str]) -> Edited:
    """Lay tables over a line file, which is replaced as a whole; see `edited_line`.

    Raises
    ------
    ModelError
        See `edited_line`; the file stays as it is.
    OutputError
        The file cannot be written; it stays as it is.
    """
    found = edited_line(read_text(FilePath(file), str(file)), str(file), tables)
    if found.changed:
        write_text(FilePath(os.path.realpath(file)), found.text)
    return found


def _laid_over(
    text: str, label: str, line: Line, tables: Tables, name: str
) -> tuple[str, list[str], dict[Path, str]]:
    """Return the new text, what is changed in it, and where the fields of the line come from."""
    found = laid(tables, line)
    note = f"from {plain(name)}"
    types = {
        kind: None if content is None else {"value": content, "note": note}
        for kind, content in found.span_types.items()
    }
    changed = [f"{TYPES}.{kind}" for kind in types]
    for path, value in found.changes.items():
        if value is not None:
            new = {"value": value, "note": note}
            text = change(text, path, new, label, is_folded=True).apply(text)
        elif not find(_root(text, label), tuple(path.split("."))).missing:
            text = remove(text, path, label).apply(text)
        changed.append(path)
    # Last: the text is read again with every change, and types are most of it.
    text = _with_types(text, label, types) if types else text
    return text, changed, found.places


def _root(text: str, label: str) -> Node:
    root = compose(text, label)
    assert root is not None
    return root


def _with_types(text: str, label: str, types: Mapping[str, Any]) -> str:
    """Return the text with types of spans changed, added and, where None, taken away.

    Types that stay keep their lines; in brackets, all are written again.
    """
    root = _root(text, label)
    section = find(root, (TYPES,)).nodes[-1]
    entries = section.value
    is_block = isinstance(entries, dict) and not section.style and section.anchor is None
    data = parse(text, label)[0]
    own = data[TYPES]
    if "value" in own:
        own, is_block = own["value"], False
    new = {name: types.get(name, own[name]) for name in own} | dict(types)
    new = {name: value for name, value in new.items() if value is not None}
    if not is_block:
        return change(text, TYPES, new, label, is_folded=True).apply(text)
    patches = []
    for name, value in types.items():
        found = find(root, (TYPES, name))
        if value is None:
            patches.append(removed(text, found, others_come=True))
        else:
            made = added(text, found, value) if found.missing else replaced(text, found, value)
            patches.append(folded(made, text))
    made_text = text
    # From the end: places of the others stay. Of entries at one place the first goes last.
    for patch in sorted(reversed(patches), key=lambda one: -one.start):
        made_text = patch.apply(made_text)
    if parse(made_text, label)[0] != {**data, TYPES: new}:
        raise ModelError(f"{TYPES}: cannot be edited in place", where=label,
                         expected="types of spans that are written out",
                         hint="are they used again by an alias? write them out")  # fmt: skip
    return made_text
