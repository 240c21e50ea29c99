"""Changes to the text of a model file: one place of it is rewritten, every other byte stays.

The places are those of the parser's nodes. What a patch does is found out by reading the text
again, see `edit`; here it is only made.
"""

import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from arcless.errors import ModelError
from arcless.model.fields.document import WRAPPED_IN
from arcless.model.fields.part import Path
from arcless.model.files.yaml_nodes import Node, scalar
from arcless.units import show

# A text of these, that begins and ends with none that means something to YAML, stands bare.
_BARE = re.compile(r"[A-Za-z0-9_.°µ²³][A-Za-z0-9_.°µ²³·()/+ -]*")
_ANCHOR = re.compile(r"&\S+\s*")
# A list or mapping in brackets may continue in the next line behind each of these; quoted texts
# stay whole.
_PIECE = re.compile(r"""(?:"(?:[^"\\]|\\.)*"|'[^']*'|[^"',]|,(?! ))*(?:, |$)""", re.S)
# Lines of shipped models end about here; continued ones begin so much further in. In characters.
_WIDTH = 100
_INWARDS = 4
_REST_OF_LINE = re.compile(r"[^\r\n]*(?:\r\n|\n|\r)?")


@dataclass(frozen=True)
class Patch:
    """A piece of a text, where it begins in characters, and what stands there instead."""

    start: int
    before: str
    after: str

    def apply(self, text: str) -> str:
        """Return the text with the piece replaced."""
        end = self.start + len(self.before)
        if text[self.start : end] != self.before:
            raise ModelError("the text is another one than that of the change")
        return text[: self.start] + self.after + text[end:]

    @property
    def undo(self) -> "Patch":
        """The patch that takes this one back."""
        return Patch(self.start, self.after, self.before)


@dataclass(frozen=True)
class NodePath:
    """Where a path leads: the nodes on the way, their keys, and their path in the data."""

    nodes: tuple[Node, ...]
    keys: tuple[Node | None, ...]
    place: Path
    missing: Path


def find(root: Node, path: Path) -> NodePath:
    """Follow a path through nodes as far as there are any; values with provenance are looked into.

    Raises
    ------
    ModelError
        The path leads through an alias, or into a value.
    """
    nodes, steps = [root], list[Node | None]([None])
    place: Path = ()
    for depth, part in enumerate(path):
        if part not in WRAPPED_IN:
            place = _unwrapped(nodes, steps, place)
        node = nodes[-1]
        inside = _child(node, part)
        if inside is None:
            return NodePath(tuple(nodes), tuple(steps), place, path[depth:])
        if node.is_alias:
            raise refused("the value of an alias", path[:depth], node)
        key, child, step = inside
        nodes.append(child)
        steps.append(key)
        place = (*place, step)
    return NodePath(tuple(nodes), tuple(steps), place, ())


def _unwrapped(nodes: list[Node], keys: list[Node | None], place: Path) -> Path:
    """Step into the value of a mapping that says where it comes from."""
    value = nodes[-1].value
    if not isinstance(value, dict) or "value" not in value or "format" in value:
        return place
    key, child = value["value"]
    nodes.append(child)
    keys.append(key)
    return (*place, "value")


def _child(node: Node, part: str | int) -> tuple[Node | None, Node, str | int] | None:
    if isinstance(node.value, dict) and str(part) in node.value:
        return (*node.value[str(part)], str(part))
    is_index = isinstance(part, int) or part.isdecimal()
    if isinstance(node.value, list) and is_index and int(part) < len(node.value):
        return None, node.value[int(part)], int(part)
    return None


def refused(got: str, path: Path, node: Node) -> ModelError:
    """Return the error about a place that cannot be rewritten."""
    return ModelError(
        "cannot be edited here",
        where=str(node.position.line),
        got=got,
        expected="a value that is written out",
        hint="edit it where its anchor is, or write it out",
        field=path,
    )


def replaced(text: str, found: NodePath, value: Any) -> Patch:
    """Return the patch that gives the node at the end of a path another value."""
    node, key = found.nodes[-1], found.keys[-1]
    anchor = _ANCHOR.match(text, node.start) if node.anchor else None
    start = anchor.end() if anchor else node.start
    end = max(start, len(text[: node.end].rstrip()))
    in_json = key is not None and key.style == '"'
    new = rendered(value, node.style if node.style in ("'", '"') else '"' if in_json else "")
    is_block = isinstance(node.value, list | dict) and not node.style
    if is_block and not anchor and key is not None and node.position.line > key.position.line:
        colon = text.index(":", key.end) + 1
        line_end = colon + len(_REST_OF_LINE.match(text, colon)[0].rstrip("\r\n"))  # type: ignore[index]
        return Patch(colon, text[colon:end], f" {new}{text[colon:line_end]}")
    if start == node.end and node.value is None:
        has_colon = key is None or ":" in text[key.end : start]
        before = "" if has_colon else ":"
        gap = "" if has_colon and text[start - 1 : start].isspace() else " "
        return Patch(start, "", f"{before}{gap}{new}")
    return Patch(start, text[start:end], new)


def added(text: str, found: NodePath, value: Any) -> Patch:
    """Return the patch that puts what is missing at the end of a path into its last node."""
    node, (name, *inner) = found.nodes[-1], found.missing
    if node.is_alias:
        raise refused("the value of an alias", found.place, node)
    for part in reversed(inner):
        value = {str(part): value}
    if node.value is None:
        return replaced(text, found, {str(name): value})
    if isinstance(node.value, list):
        if str(name) != str(len(node.value)):
            expected = f"a number from 0 to {len(node.value)}"
            raise ModelError("unknown item", got=show(str(name)), expected=expected)
        entry, last = "", node.value[-1] if node.value else None
        quote = ""
    elif isinstance(node.value, dict):
        keys = list(node.value.values())
        quote = '"' if keys and keys[-1][0].style == '"' else ""
        entry, last = f"{rendered(str(name), quote)}: ", keys[-1][1] if keys else None
    else:
        got = "a text" if isinstance(node.value, str) else show(node.value)
        raise ModelError("not a group of fields", got=got, expected="a group or a list")
    entry += rendered(value, quote)
    if last is None:
        start = text.index(node.style or "{", node.start) + 1
        return Patch(start, "", entry)
    end = len(text[: max(last.end, last.start)].rstrip()) if last.value is not None else last.end
    if node.style:
        return Patch(end, "", f", {entry}")
    return _new_line(text, node, end, entry)


def _new_line(text: str, node: Node, end: int, entry: str) -> Patch:
    """Return the patch that puts an entry of a block below the last one."""
    if isinstance(node.value, list):
        column = _dash(text, node.value[0]) - _line_start(text, _dash(text, node.value[0]))
        entry = f"- {entry}"
    else:
        column = next(iter(node.value.values()))[0].position.column - 1
    rest = _REST_OF_LINE.match(text, end)
    assert rest is not None
    line_end = "\r\n" if "\r\n" in text else "\n"
    new = " " * column + entry
    if rest[0].endswith(("\n", "\r")):
        return Patch(rest.end(), "", f"{new}{line_end}")
    return Patch(rest.end(), "", f"{line_end}{new}")


def folded(patch: Patch, text: str) -> Patch:
    """Return a patch whose new text, a value in brackets, goes over several lines if it is long."""
    line = _line_start(text, patch.start)
    column = patch.start - line
    before = (text[line : patch.start] + patch.after).lstrip("\r\n")
    inwards = " " * (len(before) - len(before.lstrip(" ")) + _INWARDS)
    line_end = "\r\n" if "\r\n" in text else "\n"
    made = list[str]()
    for piece in _PIECE.findall(patch.after):
        if made and made[-1].endswith(", ") and column + len(piece.rstrip()) > _WIDTH:
            made[-1] = made[-1][:-1]
            made.append(line_end + inwards)
            column = len(inwards)
        made.append(piece)
        column += len(piece)
    return Patch(patch.start, patch.before, "".join(made))


def removed(text: str, found: NodePath, *, others_come: bool = False) -> Patch:
    """Return the patch that takes the node at the end of a path away, with its key.

    The only entry of a group leaves ``{}`` or ``[]``, unless others come in its place.
    """
    node, parent, key = found.nodes[-1], found.nodes[-2], found.keys[-1]
    if parent.is_alias:
        raise refused("the value of an alias", found.place, node)
    entries = [
        (first.start if first is not None else _item_start(text, parent, item), item)
        for first, item in _entries(parent)
    ]
    place = next(index for index, (_, item) in enumerate(entries) if item is node)
    if len(entries) == 1 and not others_come:
        upper = NodePath(found.nodes[:-1], found.keys[:-1], found.place[:-1], ())
        return replaced(text, upper, [] if key is None else {})
    start, end = entries[place][0], len(text[: max(node.end, node.start)].rstrip())
    if node.value is None and key is not None:
        end = max(end, text.index(":", key.end) + 1 if node.start > key.end else key.end)
    if parent.style:
        if place + 1 < len(entries):
            return _cut(text, start, entries[place + 1][0])
        previous = entries[place - 1][1]
        return _cut(text, max(previous.end, entries[place - 1][0]), end)
    line = _line_start(text, start)
    if text[line:start].strip():  # the first of an item: `- type: a`
        return _cut(text, start, entries[place + 1][0])
    rest = _REST_OF_LINE.match(text, end)
    assert rest is not None
    return _cut(text, line, rest.end())


def _cut(text: str, start: int, end: int) -> Patch:
    return Patch(start, text[start:end], "")


def _entries(parent: Node) -> list[tuple[Node | None, Node]]:
    if isinstance(parent.value, list):
        return [(None, item) for item in parent.value]
    return list(parent.value.values())


def _item_start(text: str, parent: Node, item: Node) -> int:
    return item.start if parent.style else _dash(text, item)


def _dash(text: str, item: Node) -> int:
    """Return where the dash of an item of a list in a block is."""
    return text.rindex("-", 0, max(item.start, 1))


def _line_start(text: str, place: int) -> int:
    return max(text.rfind("\n", 0, place), text.rfind("\r", 0, place)) + 1


def rendered(value: Any, quote: str = "") -> str:
    """Return a value in one line of YAML, texts in the quotes asked for, or bare where that reads.

    Raises
    ------
    ModelError
        Neither text, number, true, false, nothing, list nor mapping; or not finite.
    """
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, str):
        if quote == "'" and not re.search(r"[\r\n\t]", value) and value.isprintable():
            return "'" + value.replace("'", "''") + "'"
        is_bare = _BARE.fullmatch(value) and value == value.strip() and scalar(value) == value
        return (
            value
            if is_bare and not quote
            else json.dumps(value, ensure_ascii=not value.isprintable())
        )
    if isinstance(value, int) or (isinstance(value, float) and math.isfinite(value)):
        return repr(value)
    if isinstance(value, Mapping):
        inside = (f"{rendered(str(key), quote)}: {rendered(v, quote)}" for key, v in value.items())
        return f"{{{', '.join(inside)}}}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(rendered(item, quote) for item in value)}]"
    expected = "a text, a finite number, true, false, nothing, a list or a mapping"
    raise ModelError("value", got=show(value), expected=expected)
