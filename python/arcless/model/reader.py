"""Text of a model file → plain data, with the line and column of every value.

YAML is read as events, so that a hostile file (deep nesting, aliases that explode, duplicate keys,
tags) is refused before anything is built from it.
"""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any, NamedTuple

from arcless.errors import ModelError
from arcless.model.documents import MAX_DEPTH
from arcless.model.fields import Path
from arcless.units import show

MAX_BYTES = 5_000_000
# Nodes after aliases are expanded; a speed profile of 50 000 points fits.
MAX_NODES = 150_000
# Files, each of at most so many characters, that are kept as read: two scenarios with their parts,
# no long tables. More would cost memory; with less, what takes 2 µs a character is done again.
MOST_KEPT, LONGEST_KEPT = 8, 50_000

_NULL = {"", "~", "null", "Null", "NULL"}
_BOOL = {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}
_HALF = re.compile("[\ud800-\udfff]")
_INT = re.compile(r"[+-]?\d{1,300}")
_FLOAT = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")


class Position(NamedTuple):
    """Line and column, both from 1."""

    line: int
    column: int


@dataclass(frozen=True)
class Origin:
    """Where data come from: file, folder for references, positions, and who refers to it."""

    label: str | None = None
    folder: FilePath = field(default_factory=FilePath)
    positions: dict[Path, Position] = field(default_factory=dict)
    chain: tuple[FilePath, ...] = ()

    def position(self, path: Path) -> Position | None:
        """Return the position of a field, or of the nearest thing around it."""
        while path and path not in self.positions:
            path = path[:-1]
        return self.positions.get(path)

    def where(self, path: Path = ()) -> str | None:
        """Return ``file:line`` of a field, or None when the data are not from a file."""
        if self.label is None:
            return None
        position = self.position(path)
        return self.label if position is None else f"{self.label}:{position.line}"

    @contextmanager
    def referring(self, path: Path) -> Iterator[None]:
        """Say of an error in a file which field named that file."""
        try:
            yield
        except ModelError as error:
            referrer = self.where(path)
            if referrer is not None:
                error.where = f"{error.where} (named in {referrer})"
            raise


def is_file(path: FilePath) -> bool:
    """Return whether a path is a regular file; False, too, for names that no system accepts."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def read_text(path: FilePath, label: str) -> str:
    """Return the text of a model file; refuse what cannot be one before reading it all."""
    expected = "a text file in YAML"
    try:
        if not is_file(path) and path.exists():
            got = "a folder" if path.is_dir() else "a device or a pipe"
            raise ModelError("not a file", where=label, got=got, expected=expected)
        if not path.is_file():
            raise ModelError("no such file", where=label, expected=expected)
        size = path.stat().st_size
        if size > MAX_BYTES:
            got, limit = f"{size / 1e6:.1f} MB", f"at most {MAX_BYTES / 1e6:g} MB"
            raise ModelError("file too large", where=label, got=got, expected=limit)
        with path.open("rb") as file:
            raw = file.read(MAX_BYTES)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ModelError(f"cannot be read ({reason})", where=label, expected=expected) from None
    if b"\0" in raw:
        raise ModelError("not a text file", where=label, got="binary data", expected=expected)
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        got = f"byte 0x{raw[error.start]:02x}, which is not UTF-8"
        hint = "save the file as UTF-8"
        where = f"{label}:{line}"
        raise ModelError(
            "not a text file", where=where, got=got, expected=expected, hint=hint
        ) from None


def parse(text: str, label: str) -> tuple[dict[str, Any], dict[Path, Position]]:
    """Return the data of a YAML text and the position of each field.

    Raises
    ------
    ModelError
        Empty, not YAML, not a mapping, duplicate keys, tags, too deep, or too many nodes.
    """
    root = _kept(text, label) if len(text) <= LONGEST_KEPT else _composed(text, label)
    if root is None:
        raise ModelError(
            "empty file", where=label, expected="a model file that starts with format:"
        )
    positions: dict[Path, Position] = {}
    data = _expand(root, (), positions)
    if not isinstance(data, dict):
        where = f"{label}:{root.position.line}"
        expected = "fields such as name: and format:"
        raise ModelError("not a model file", where=where, got=show(data), expected=expected)
    return data, positions


def scalar(text: str) -> object:
    """Return the value of an unquoted scalar: null, true, false, a number or a text."""
    if text in _NULL:
        return None
    if text in _BOOL:
        return _BOOL[text]
    if _INT.fullmatch(text):
        return int(text)
    if _FLOAT.fullmatch(text):
        return float(
            text.replace(".inf", "inf")
            .replace(".Inf", "inf")
            .replace(".INF", "inf")
            .replace(".nan", "nan")
            .replace(".NaN", "nan")
            .replace(".NAN", "nan")
        )
    return text


@dataclass
class _Node:
    """A scalar, list or mapping; `size` counts it and everything below it."""

    position: Position
    value: Any
    size: int


def _composed(text: str, label: str) -> _Node | None:
    return _Composer(_events(text, label), label).document()


# A run looks at its shipped scenario again, for published ranges; nobody changes a node.
_kept = lru_cache(MOST_KEPT)(_composed)


def _events(text: str, label: str) -> Iterator[Any]:
    from ruamel.yaml import YAML
    from ruamel.yaml.error import MarkedYAMLError, YAMLError

    try:
        yield from YAML(typ="safe", pure=True).parse(text)
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        where = label if mark is None else f"{label}:{mark.line + 1}"
        problem = error.problem or error.context or "syntax error"
        hint = "check indentation, colons, brackets and quotes near this line"
        raise ModelError(f"not valid YAML: {problem}", where=where, hint=hint) from None
    except YAMLError as error:
        problem = str(error).split("\n", maxsplit=1)[0]
        raise ModelError(f"not valid YAML: {problem}", where=label) from None


class _Composer:
    """Build nodes from events, counting them as if every alias were written out."""

    def __init__(self, events: Iterator[Any], label: str) -> None:
        self._events = events
        self._label = label
        self._anchors: dict[str, _Node | None] = {}
        self._count = 0

    def document(self) -> _Node | None:
        """Return the only document of the stream, or None when there is none."""
        root: _Node | None = None
        for event in self._events:
            kind = type(event).__name__
            if kind == "DocumentStartEvent":
                if root is not None:
                    raise self._refused(event, "a second document", "one document in a file")
                root = self._node(next(self._events), depth=0)
        return root if root is None or root.value is not None else None

    def _node(self, event: Any, depth: int) -> _Node:
        kind = type(event).__name__
        if kind == "AliasEvent":
            return self._alias(event)
        position = _position(event)
        if event.tag is not None:
            raise self._refused(event, f"the tag {show(str(event.tag))}", "plain YAML without tags")
        if depth > MAX_DEPTH:
            raise self._refused(event, "deeper nesting", f"at most {MAX_DEPTH} levels")
        self._add(event, 1)
        anchor = event.anchor
        if anchor is not None:
            self._anchors[anchor] = None
        node = _Node(position, None, 1)
        if kind == "ScalarEvent":
            text = self._text(event)
            node.value = scalar(text) if event.implicit[0] else text
        elif kind == "SequenceStartEvent":
            node.value = []
            for child in self._children("SequenceEndEvent"):
                node.value.append(self._node(child, depth + 1))
            node.size += sum(child.size for child in node.value)
        else:
            node.value = self._mapping(depth)
            node.size += sum(child.size for _, child in node.value.values())
        if anchor is not None:
            self._anchors[anchor] = node
        return node

    def _mapping(self, depth: int) -> dict[str, tuple[Position, _Node]]:
        entries: dict[str, tuple[Position, _Node]] = {}
        for key in self._children("MappingEndEvent"):
            if type(key).__name__ != "ScalarEvent" or key.tag is not None:
                raise self._refused(key, "a key that is not plain text", "a field name")
            name = self._text(key)
            if name in entries:
                first = entries[name][0].line
                got = f"{show(name)} again; it stands in line {first}"
                raise self._refused(key, got, "each field once")
            if name == "<<":
                raise self._refused(key, "a merge key", "fields written out, or an alias as value")
            entries[name] = (_position(key), self._node(next(self._events), depth + 1))
        return entries

    def _text(self, event: Any) -> str:
        """Return the text of a scalar; JSON writes rare characters as two halves."""
        text: str = event.value
        if not _HALF.search(text):
            return text
        try:
            return text.encode("utf-16", "surrogatepass").decode("utf-16")
        except UnicodeDecodeError:
            got = "half of a character, \\ud800 to \\udfff, without the other"
            raise self._refused(event, got, "whole characters") from None

    def _children(self, end: str) -> Iterator[Any]:
        for event in self._events:
            if type(event).__name__ == end:
                return
            yield event

    def _alias(self, event: Any) -> _Node:
        node = self._anchors.get(event.anchor)
        if node is None:
            known = event.anchor in self._anchors
            got = f"the alias *{event.anchor}" + (" inside its own anchor" if known else "")
            raise self._refused(event, got, "an alias of an anchor above it")
        self._add(event, node.size)
        return _Node(_position(event), node.value, node.size)

    def _add(self, event: Any, nodes: int) -> None:
        self._count += nodes
        if self._count > MAX_NODES:
            got = f"more than {MAX_NODES} values, aliases written out"
            raise self._refused(event, got, f"at most {MAX_NODES}")

    def _refused(self, event: Any, got: str, expected: str) -> ModelError:
        where = f"{self._label}:{_position(event).line}"
        return ModelError("not a model file", where=where, got=got, expected=expected)


def _position(event: Any) -> Position:
    return Position(event.start_mark.line + 1, event.start_mark.column + 1)


def _expand(node: _Node, path: Path, positions: dict[Path, Position]) -> Any:
    if isinstance(node.value, list):
        for index, child in enumerate(node.value):
            positions[(*path, index)] = child.position
        return [_expand(child, (*path, i), positions) for i, child in enumerate(node.value)]
    if isinstance(node.value, dict):
        for key, (position, _) in node.value.items():
            positions[(*path, key)] = position
        return {
            key: _expand(child, (*path, key), positions) for key, (_, child) in node.value.items()
        }
    return node.value
