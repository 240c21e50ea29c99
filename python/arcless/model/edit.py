"""Change, add and remove values in the text of a model file; every other byte stays as it is.

Comments, order, quotes, spelling of numbers and units, line ends and a byte-order mark are kept:
only the text of one value is rewritten. The text is read again afterwards, and the change is
refused unless it is exactly the one that was asked for.
"""

import os
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from copy import deepcopy
from pathlib import Path as FilePath
from typing import Any

from arcless.errors import ModelError, OutputError
from arcless.model.fields.part import Path
from arcless.model.files.text_patches import (
    NodePath,
    Patch,
    added,
    find,
    folded,
    removed,
    replaced,
)
from arcless.model.files.yaml_nodes import compose
from arcless.model.files.yaml_reader import parse, read_text
from arcless.platforms.moving import move
from arcless.units import plain

_BOM = b"\xef\xbb\xbf"


def change(
    text: str, path: str, value: Any, label: str = "model file", *, is_folded: bool = False
) -> Patch:
    r"""Return the patch that gives a field a value; a field that is not there yet is added.

    Parameters
    ----------
    text
        The text of a model file.
    path
        Dotted path, items of lists numbered from 0; the number of items appends one. The value of
        ``{value: 22 kN, mark: A}`` is meant by the path of the mapping, unless a mapping with a
        `value` is given. In a variant ``set.line.contact_wire.tension`` is one entry of `set`.
    value
        A text as one would type it (``"12 kN"``), a number, true, false, None, a list or a mapping.
    label
        Name of the file, for messages.
    is_folded
        Whether a long list or mapping goes over several lines.

    Raises
    ------
    ModelError
        There is no such place, it is reached by an alias, or the text would say something else.

    Examples
    --------
    >>> text = "wire:\n  tension: 10 kN  # as drawn\n"
    >>> change(text, "wire.tension", "12 kN").apply(text)
    'wire:\n  tension: 12 kN  # as drawn\n'
    """
    root, data = _read(text, label)
    is_whole = isinstance(value, Mapping) and "value" in value
    found = _found(root, _parts(path, data), label, into_value=not is_whole)
    try:
        patch = added(text, found, value) if found.missing else replaced(text, found, value)
    except ModelError as error:
        raise _about(error, path, label) from None
    patch = folded(patch, text) if is_folded else patch
    _check(patch, text, _with(data, found, value), path, label)
    return patch


def remove(text: str, path: str, label: str = "model file") -> Patch:
    """Return the patch that takes a field, or an item of a list, away; see `change`.

    A group or list whose last entry goes is left empty, as ``{}`` or ``[]``.
    """
    root, data = _read(text, label)
    found = _found(root, _parts(path, data), label, into_value=False)
    if found.missing:
        raise ModelError(f"{plain(path)}: no such field", where=label)
    try:
        patch = removed(text, found)
    except ModelError as error:
        raise _about(error, path, label) from None
    _check(patch, text, _without(data, found.place), path, label)
    return patch


def edit_file(
    file: str | os.PathLike[str], changes: Mapping[str, Any], removing: Sequence[str] = ()
) -> list[Patch]:
    """Change and remove values in a model file, all of them or none; return the patches.

    Parameters
    ----------
    file
        The file; it is replaced as a whole.
    changes
        New values by dotted path, see `change`; done in order.
    removing
        Dotted paths of what is taken away afterwards.

    Raises
    ------
    ModelError
        The file is none, or a change is refused; the file stays as it is.
    OutputError
        The file cannot be written; it stays as it is.
    """
    label = str(file)
    text, patches = read_text(FilePath(file), label), list[Patch]()
    for path, value in changes.items():
        patches.append(change(text, path, value, label))
        text = patches[-1].apply(text)
    for path in removing:
        patches.append(remove(text, path, label))
        text = patches[-1].apply(text)
    write_text(FilePath(os.path.realpath(file)), text)
    return patches


def undo_in_file(file: str | os.PathLike[str], patches: Sequence[Patch]) -> None:
    """Take back what `edit_file` did; the file has the same bytes as before.

    Raises
    ------
    ModelError
        The file was changed since; it stays as it is.
    """
    text = read_text(FilePath(file), str(file))
    for patch in reversed(patches):
        text = patch.undo.apply(text)
    write_text(FilePath(os.path.realpath(file)), text)


def _read(text: str, label: str) -> tuple[Any, dict[str, Any]]:
    data, _ = parse(text, label)
    return compose(text, label), data


def _parts(path: str, data: Mapping[str, Any]) -> Path:
    """Return the keys of a path; a field in the `set` of a variant is one key with its dots."""
    first, _, rest = path.partition(".")
    if not (first == "set" and rest and "base" in data):
        return tuple(path.split("."))
    there = data.get("set")
    names = there if isinstance(there, Mapping) else ()
    known = [key for key in names if rest == key or rest.startswith(f"{key}.")]
    key = max(known, key=len, default=rest)
    inside = rest[len(key) + 1 :]
    return (first, key, *(inside.split(".") if inside else ()))


def _found(root: Any, parts: Path, label: str, *, into_value: bool) -> NodePath:
    path = ".".join(map(str, parts))
    try:
        found = find(root, parts)
        # Found with the value of a mapping that has one.
        inner = find(found.nodes[-1], ("value",)) if into_value and not found.missing else None
    except ModelError as error:
        raise _about(error, path, label) from None
    node = found.nodes[-1]
    is_wrapper = isinstance(node.value, dict) and "value" in node.value
    if inner is None or not is_wrapper or "format" in node.value:
        return found
    return NodePath(
        (*found.nodes, *inner.nodes[1:]),
        (*found.keys, *inner.keys[1:]),
        (*found.place, "value"),
        (),
    )


def _about(error: ModelError, path: str, label: str) -> ModelError:
    where = label if error.where is None else f"{label}:{error.where}"
    return ModelError(
        f"{plain(path)}: {error.what}",
        where=where,
        got=error.got,
        expected=error.expected,
        hint=error.hint,
    )


def _check(patch: Patch, text: str, expected: dict[str, Any], path: str, label: str) -> None:
    """Refuse a patch after which the text says something else than was asked for."""
    try:
        found: Any = parse(patch.apply(text), label)[0]
    except ModelError:
        found = None
    if found is None or not _same(found, expected):
        raise ModelError(
            f"{plain(path)}: cannot be edited in place",
            where=label,
            expected="a change of this value alone",
            hint="is it used again by an alias? edit the file by hand",
        )


def _same(one: Any, other: Any) -> bool:
    """Return whether data are equal, true and 1 and 1.0 being different."""
    if isinstance(one, dict) and isinstance(other, dict):
        return list(one) == list(other) and all(_same(one[key], other[key]) for key in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_same, one, other))
    return type(one) is type(other) and repr(one) == repr(other)  # not a number equals itself


def _plain_data(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(key): _plain_data(item) for key, item in value.items()}
    return [_plain_data(item) for item in value] if isinstance(value, list | tuple) else value


def _with(data: dict[str, Any], found: NodePath, value: Any) -> dict[str, Any]:
    """Return the data as they must be after a change."""
    whole: dict[str, Any] = deepcopy(data)
    value = _plain_data(value)
    place = found.place
    if found.missing:
        name, *inner = found.missing
        for part in reversed(inner):
            value = {str(part): value}
        if found.nodes[-1].value is None:
            value = {str(name): value}
        else:
            place = (*place, name)
    around: Any = whole
    for part in place[:-1]:
        around = around[part]
    if isinstance(around, list) and int(place[-1]) == len(around):
        around.append(value)
    elif isinstance(around, list):
        around[int(place[-1])] = value
    else:
        around[place[-1]] = value
    return whole


def _without(data: dict[str, Any], place: Path) -> dict[str, Any]:
    """Return the data as they must be after something was taken away."""
    whole: dict[str, Any] = deepcopy(data)
    around: Any = whole
    for part in place[:-1]:
        around = around[part]
    del around[place[-1]]
    return whole


def write_text(file: FilePath, text: str) -> None:
    """Replace a file as a whole; its rights and its byte-order mark stay."""
    temporary: str | None = None
    try:
        with file.open("rb") as before:
            mark = _BOM if before.read(len(_BOM)) == _BOM else b""
        handle, temporary = tempfile.mkstemp(prefix=".arcless-edit-", dir=file.parent)
        with os.fdopen(handle, "wb") as new:
            new.write(mark + text.encode())
            new.flush()
            os.fsync(new.fileno())
        FilePath(temporary).chmod(file.stat().st_mode & 0o7777)
        move(FilePath(temporary), file)
    except OSError as error:
        raise OutputError.of(error, "the file cannot be written", file) from error
    finally:
        if temporary is not None:
            with suppress(OSError):
                FilePath(temporary).unlink(missing_ok=True)
