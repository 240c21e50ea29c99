"""Text in YAML → nodes, each with its line, its column and its place in the text.

YAML is read as events, so that a hostile file (deep nesting, aliases that explode, duplicate keys,
tags) is refused before anything is built from it. The events are those of libyaml where PyYAML has
it, else of PyYAML's own parser, which is slower and reads the same.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

from arcless.errors import ModelError
from arcless.model.fields.document import MAX_DEPTH
from arcless.units import show

# Nodes after aliases are expanded; a speed profile of 50 000 points fits.
MAX_NODES = 150_000

_NULL = {"", "~", "null", "Null", "NULL"}
_BOOL = {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}
_INT = re.compile(r"[+-]?\d{1,300}")
_FLOAT = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")
# JSON writes rare characters as the escapes of two halves, which libyaml refuses.
_ESCAPED_HALF = re.compile(r"(?<!\\)((?:\\\\)*)\\(u|U0000)([dD][89a-fA-F][0-9a-fA-F]{2})")
_PRIVATE = re.compile(r"[\ue000-\uf8ff]|\\(?:u|U0000)([eEfF][0-9a-fA-F]{3})")
_PLACEHOLDERS = range(0xE000, 0xF900)
# libyaml has a limit of its own since 0.2.6, 1 000 brackets, and reads ahead to it.
_LIBYAML_TOO_DEEP = "exceeded maximum nesting depth"


class Position(NamedTuple):
    """Line and column, both from 1."""

    line: int
    column: int


@dataclass(slots=True)
class Node:
    """A scalar, list or mapping of a text.

    Attributes
    ----------
    value
        A value, a list of nodes, or for each name its key and its value, both nodes.
    start, end
        Where it begins and ends in the text, in characters; an anchor is part of it.
    style
        ``"`` or ``'`` of a quoted scalar, ``|`` or ``>`` of a block, ``[`` or ``{`` of a
        collection in brackets; empty otherwise.
    size
        Number of nodes that it is, with all below it.
    anchor, is_alias
        Name of its anchor, and whether it stands for a node above it.
    """

    position: Position
    start: int
    end: int
    value: Any = None
    style: str = ""
    size: int = 1
    anchor: str | None = None
    is_alias: bool = False


def compose(text: str, label: str) -> Node | None:
    """Return the only document of a text, or None when there is nothing in it.

    Raises
    ------
    ModelError
        Not YAML, duplicate keys, merge keys, tags, too deep, too many nodes, several documents.
    """
    return _Composer(text, label).document()


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


def _events(text: str, label: str) -> Iterator[Any]:
    import yaml

    loader = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
    try:
        yield from yaml.parse(text, Loader=loader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        where = label if mark is None else f"{label}:{mark.line + 1}"
        problem = error.problem or error.context or "syntax error"
        if problem == _LIBYAML_TOO_DEEP:
            raise _too_deep(where) from None
        hint = "check indentation, colons, brackets and quotes near this line"
        if mark is not None and text[mark.index : mark.index + 1] == "\t":
            hint = "indent with blanks; there is a tab"
        raise ModelError(f"not valid YAML: {problem}", where=where, hint=hint) from None
    except yaml.reader.ReaderError as error:
        # libyaml counts bytes, the other parser characters.
        before = text.encode()[: error.position].decode(errors="ignore")
        before = before if error.encoding == "?" else text[: error.position]
        line = before.count("\n") + 1
        got = f"the character U+{error.character:04X}"
        raise ModelError(
            "not valid YAML", where=f"{label}:{line}", got=got, expected="characters that print"
        ) from None
    except ValueError:  # PyYAML's own parser: an escape of no character, as \U00110000
        raise ModelError("not valid YAML: invalid Unicode escape code", where=label) from None


def _too_deep(where: str) -> ModelError:
    got, expected = "deeper nesting", f"at most {MAX_DEPTH} levels"
    return ModelError("not a model file", where=where, got=got, expected=expected)


class _Composer:
    """Build nodes from events, counting them as if every alias were written out."""

    def __init__(self, text: str, label: str) -> None:
        self._text, self._label = text, label
        self._has_halves = _ESCAPED_HALF.search(text) is not None
        self._placeholder = ""
        self._events = _events(self._without_halves() if self._has_halves else text, label)
        self._anchors: dict[str, Node | None] = {}
        self._count = 0

    def document(self) -> Node | None:
        """Return the only document of the stream, or None when there is none."""
        root: Node | None = None
        for event in self._events:
            if type(event).__name__ == "DocumentStartEvent":
                if root is not None:
                    raise self._refused(event, "a second document", "one document in a file")
                root = self._node(next(self._events), depth=0)
        return root if root is None or root.value is not None else None

    def _node(self, event: Any, depth: int) -> Node:
        kind = type(event).__name__
        if kind == "AliasEvent":
            return self._alias(event)
        if event.tag is not None:
            raise self._refused(event, f"the tag {show(str(event.tag))}", "plain YAML without tags")
        if depth > MAX_DEPTH:
            raise _too_deep(f"{self._label}:{event.start_mark.line + 1}")
        self._add(event, 1)
        anchor = event.anchor
        if anchor is not None:
            self._anchors[anchor] = None
        if kind == "ScalarEvent":
            node = self._scalar(event)
        elif kind == "SequenceStartEvent":
            node = self._sequence(event, depth)
        else:
            node = self._mapping(event, depth)
        if anchor is not None:
            node.anchor = anchor
            self._anchors[anchor] = node
        return node

    def _scalar(self, event: Any) -> Node:
        text: str = event.value
        start, end = event.start_mark, event.end_mark
        if self._has_halves:
            text = self._with_halves(event)
        return Node(
            Position(start.line + 1, start.column + 1),
            start.index,
            end.index,
            scalar(text) if event.implicit[0] else text,
            event.style or "",
        )

    def _sequence(self, event: Any, depth: int) -> Node:
        node = self._collection(event, "[")
        node.value = []
        for child in self._children(node, "SequenceEndEvent"):
            item = self._node(child, depth + 1)
            node.value.append(item)
            node.size += item.size
            node.end = max(node.end, item.end)
        return node

    def _mapping(self, event: Any, depth: int) -> Node:
        node = self._collection(event, "{")
        entries: dict[str, tuple[Node, Node]] = {}
        for child in self._children(node, "MappingEndEvent"):
            if type(child).__name__ != "ScalarEvent" or child.tag is not None:
                raise self._refused(child, "a key that is not plain text", "a field name")
            key = self._scalar(child)
            name: str = self._with_halves(child) if self._has_halves else child.value
            if name in entries:
                first = entries[name][0].position.line
                got = f"{show(name)} again; it is in line {first}"
                raise self._refused(child, got, "each field once")
            if name == "<<":
                expected = "fields written out, or an alias as value"
                raise self._refused(child, "a merge key", expected)
            item = self._node(next(self._events), depth + 1)
            entries[name] = (key, item)
            node.size += item.size
            node.end = max(node.end, item.end)
        node.value = entries
        return node

    def _collection(self, event: Any, bracket: str) -> Node:
        start, end = event.start_mark, event.end_mark
        style = bracket if event.flow_style else ""
        return Node(Position(start.line + 1, start.column + 1), start.index, end.index, None, style)

    def _children(self, node: Node, end: str) -> Iterator[Any]:
        for event in self._events:
            if type(event).__name__ == end:
                if node.style:  # a block ends with its last child, not where the next thing begins
                    node.end = event.end_mark.index
                return
            yield event

    def _alias(self, event: Any) -> Node:
        node = self._anchors.get(event.anchor)
        if node is None:
            known = event.anchor in self._anchors
            got = f"the alias *{event.anchor[:20]}" + (" inside its own anchor" if known else "")
            raise self._refused(event, got, "an alias of an anchor above it")
        self._add(event, node.size)
        start, end = event.start_mark, event.end_mark
        place = Position(start.line + 1, start.column + 1)
        return Node(place, start.index, end.index, node.value, "", node.size, is_alias=True)

    def _add(self, event: Any, nodes: int) -> None:
        self._count += nodes
        if self._count > MAX_NODES:
            got = f"more than {MAX_NODES} values, aliases written out"
            raise self._refused(event, got, f"at most {MAX_NODES}")

    def _without_halves(self) -> str:
        """Return the text with an escape of the same length for every escape of a half."""
        used = {found[1] or found[0] for found in _PRIVATE.finditer(self._text)}
        used = {ord(one) if len(one) == 1 else int(one, 16) for one in used}
        code = next((code for code in _PLACEHOLDERS if code not in used), None)
        if code is None:
            return self._text  # nobody writes all of them; the parser refuses the first half
        self._placeholder = chr(code)
        return _ESCAPED_HALF.sub(lambda found: rf"{found[1]}\{found[2]}{code:04x}", self._text)

    def _with_halves(self, event: Any) -> str:
        """Return the text of a scalar with its halves in their places again, and joined."""
        text: str = event.value
        if not self._placeholder:
            return text
        source = self._text[event.start_mark.index : event.end_mark.index]
        escapes = iter(_ESCAPED_HALF.findall(source))
        if event.style == '"':
            parts = text.split(self._placeholder)
            halves = (chr(int(code, 16)) for _, _, code in escapes)
            text = parts[0] + "".join(map("".join, zip(halves, parts[1:], strict=False)))
        else:
            there = rf"\\(?:u|U0000){ord(self._placeholder):04x}"
            text = re.sub(there, lambda _: "\\{1}{2}".format(*next(escapes)), text)
        try:
            return text.encode("utf-16", "surrogatepass").decode("utf-16")
        except UnicodeDecodeError:
            got = "half of a character, \\ud800 to \\udfff, without the other"
            raise self._refused(event, got, "whole characters") from None

    def _refused(self, event: Any, got: str, expected: str) -> ModelError:
        where = f"{self._label}:{event.start_mark.line + 1}"
        return ModelError("not a model file", where=where, got=got, expected=expected)
