"""Text of a model file → plain data, with the line and column of every value."""

from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path as FilePath
from typing import Any

from arcless.errors import ModelError
from arcless.model.fields.part import Path
from arcless.model.files.yaml_nodes import Node, Position, compose
from arcless.units import plain, show

MAX_BYTES = 5_000_000
EXPECTED = "a text file in YAML"
KINDS: dict[type, str] = {str: "text", bool: "word"}


@dataclass(frozen=True)
class Origin:
    """Where data come from: file, folder for references, positions, and who refers to it.

    Attributes
    ----------
    within
        Whole path of the folder that no reference may lead out of; None where all are followed.
    """

    label: str | None = None
    folder: FilePath = field(default_factory=FilePath)
    positions: dict[Path, Position] = field(default_factory=dict)
    chain: tuple[FilePath, ...] = ()
    within: FilePath | None = None

    def file(self, name: str) -> FilePath:
        """Return the file that a reference names, which need not be there.

        Raises
        ------
        ModelError
            It leads out of the folder that references have to stay in.
        """
        path = self.folder / name
        if self.within is not None and not _is_inside(path, self.within):
            expected = f"a file below {self.within}"
            hint = "open a folder that has both files in it"
            raise ModelError("file outside of the folder", where=plain(name), expected=expected,
                             hint=hint)  # fmt: skip
        return path

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


def _is_inside(path: FilePath, folder: FilePath) -> bool:
    """Return whether a path stays in a folder when its links are followed."""
    try:
        return path.resolve().is_relative_to(folder)
    except (OSError, RuntimeError, ValueError):  # a loop of links, or no path at all
        return False


def read_text(path: FilePath, label: str, expected: str = EXPECTED) -> str:
    """Return the text of a file; refuse what cannot be a text before reading it all."""
    try:
        if not is_file(path) and path.exists():
            got = "a folder" if path.is_dir() else "a device or a pipe"
            raise ModelError("not a file", where=label, got=got, expected=expected)
        if not path.is_file():
            raise ModelError("no such file", where=label, expected=expected)
        check_size(path.stat().st_size, label)
        with path.open("rb") as file:
            raw = file.read(MAX_BYTES)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ModelError(f"cannot be read ({reason})", where=label, expected=expected) from None
    return decoded(raw, label, expected)


def check_size(size: int, label: str) -> None:
    """Refuse more bytes than a text may have.

    Raises
    ------
    ModelError
        They are too many.
    """
    if size > MAX_BYTES:
        got, limit = f"{size / 1e6:.1f} MB", f"at most {MAX_BYTES / 1e6:g} MB"
        raise ModelError("file too large", where=label, got=got, expected=limit)


def decoded(raw: bytes, label: str, expected: str = EXPECTED) -> str:
    """Return the text that bytes are, without a byte-order mark.

    Raises
    ------
    ModelError
        They are no text in UTF-8; the message names the line.
    """
    if raw.startswith((BOM_UTF16_LE, BOM_UTF16_BE)):
        raise ModelError("not a text file in UTF-8", where=label, got="text in UTF-16",
                         expected=expected, hint="save the file as UTF-8")  # fmt: skip
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
    root = compose(text, label)
    if root is None:
        raise ModelError(
            "empty file", where=label, expected="a model file that starts with format:"
        )
    positions: dict[Path, Position] = {}
    data = _expand(root, (), positions)
    if not isinstance(data, dict):
        where = f"{label}:{root.position.line}"
        expected = "fields such as name: and format:"
        # The kind of file, not its content: any file may be named, by a stranger too.
        got = show(data) if isinstance(data, list) else f"a {KINDS.get(type(data), 'number')}"
        raise ModelError("not a model file", where=where, got=got, expected=expected)
    return data, positions


def _expand(node: Node, path: Path, positions: dict[Path, Position]) -> Any:
    if isinstance(node.value, list):
        for index, child in enumerate(node.value):
            positions[(*path, index)] = child.position
        return [_expand(child, (*path, i), positions) for i, child in enumerate(node.value)]
    if isinstance(node.value, dict):
        for name, (key, _) in node.value.items():
            positions[(*path, name)] = key.position
        return {
            name: _expand(child, (*path, name), positions)
            for name, (_, child) in node.value.items()
        }
    return node.value
