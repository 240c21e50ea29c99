"""Places of the fields of a model file in its text."""

from bisect import bisect_right
from collections.abc import Iterator
from typing import TypedDict

from arcless.model.files.yaml_nodes import Node, compose

Path = tuple[str | int, ...]
# Entries of a value that carries its source: the value stands for the field itself.
VALUE = "value"


class Place(TypedDict):
    """Where a field stands, counted from 1; the end is behind its last character."""

    line: int
    column: int
    end_line: int
    end_column: int


def places(text: str, label: str) -> dict[str, Place]:
    """Return the places of all fields by dotted path, items of lists numbered from 0.

    Raises
    ------
    ModelError
        The text is no YAML.
    """
    root = compose(text, label)
    starts = [0, *(index + 1 for index, letter in enumerate(text) if letter == "\n")]

    def spot(offset: int) -> tuple[int, int]:
        line = bisect_right(starts, offset)
        return line, offset - starts[line - 1] + 1

    found: dict[str, Place] = {}
    for path, start, end in _fields(root, ()) if root is not None else ():
        # A block ends where the next one begins: blanks before that are not part of it.
        last = start + len(text[start:end].rstrip())
        (line, column), (end_line, end_column) = spot(start), spot(last)
        place = Place(line=line, column=column, end_line=end_line, end_column=end_column)
        found.setdefault(".".join(map(str, path)), place)
    return found


def _fields(node: Node, path: Path) -> Iterator[tuple[Path, int, int]]:
    if isinstance(node.value, list):
        for index, child in enumerate(node.value):
            yield (*path, index), child.start, child.end
            yield from _fields(child, (*path, index))
    elif isinstance(node.value, dict):
        if VALUE in node.value and path:
            yield from _fields(node.value[VALUE][1], path)
            return
        for name, (key, child) in node.value.items():
            yield (*path, name), key.start, child.end
            yield from _fields(child, (*path, name))
