"""Texts of model files: read, and saved whole or not at all, unless somebody else was faster."""

import codecs
import hashlib
import os
import stat
import sys
import threading
from pathlib import Path
from typing import Any

from arcless.errors import OutputError
from arcless.model.files.yaml_reader import decoded
from arcless.storage.whole_files import replacing
from arcless.studio.answers.answers import Refused
from arcless.studio.project.kinds import kind_of
from arcless.studio.project.opening import read_bytes
from arcless.studio.project.project import Project, is_shipped
from arcless.units import show

ENDINGS = (".yaml", ".yml", ".json")
_BAD_REQUEST, _CONFLICT = 400, 409
# Two tabs save one after the other, and the second one sees what the first one did.
_SAVING = threading.Lock()


def read(project: Project, path: str) -> dict[str, Any]:
    """Return a text, its kind, and its version, the SHA-256 of its bytes."""
    content = read_bytes(project, model_file(project, path), path)
    text = decoded(content, path)
    return {
        "path": path,
        "kind": kind_of(text),
        "text": text,
        "version": version_of(content),
        "writable": not is_shipped(path),
    }


def write(project: Project, path: object, text: object, version: object) -> dict[str, str]:
    """Save a text whole or not at all; line ends, byte-order mark and rights of the file stay.

    Parameters
    ----------
    project
        The project.
    path
        Path below the folder.
    text
        The text. Where the file has Windows line ends and the text has none, it is given them.
    version
        Version that the text was made from; None for a new file.

    Raises
    ------
    Refused
        The file on the disk has another version; the answer holds it.
    OutputError
        It cannot be written: shipped, no folder, read-only, disk full.
    """
    if not (isinstance(path, str) and isinstance(text, str)):
        raise Refused(_BAD_REQUEST, "A file is saved by its path and its text")
    if is_shipped(path):
        raise OutputError("a shipped model cannot be written", got=show(path),
                          hint="make a model of your own of it")  # fmt: skip
    file = model_file(project, path)
    with _SAVING:
        before = read_bytes(project, file, path) if os.path.lexists(file) else None
        if (None if before is None else version_of(before)) != version:
            raise _conflict(path, before)
        content = _as_before(text, before or b"", path)
        _replace(file, content, is_new=before is None)
    return {"version": version_of(content)}


def model_file(project: Project, path: str) -> Path:
    """Return the file of a model; refuse one that does not end as a model file does."""
    file = project.model_file(path)
    if file.suffix.lower() not in ENDINGS:
        raise OutputError("no model file", got=show(path), expected=", ".join(ENDINGS))
    return file


def version_of(content: bytes) -> str:
    """Return the version of a file: the SHA-256 of its bytes."""
    return hashlib.sha256(content).hexdigest()


def _conflict(path: str, before: bytes | None) -> Refused:
    if before is None:
        return Refused(_CONFLICT, f"{path} is not there any more", current=None)
    current = {"text": decoded(before, path), "version": version_of(before)}
    return Refused(_CONFLICT, f"{path} was changed by another program", current=current)


def _as_before(text: str, before: bytes, path: str) -> bytes:
    """Return the bytes of a text with the line ends and the byte-order mark of the file."""
    if b"\r\n" in before and "\r" not in text:
        text = text.replace("\n", "\r\n")
    try:
        content = text.encode()
    except UnicodeEncodeError:
        raise Refused(_BAD_REQUEST, f"{path}: the text holds half a character") from None
    return codecs.BOM_UTF8 + content if before.startswith(codecs.BOM_UTF8) else content


def _replace(file: Path, content: bytes, *, is_new: bool) -> None:
    with replacing(file) as new:
        new.write(content)
        # On Windows a file has one right of this kind, to be written, and this one had it.
        if not is_new and sys.platform != "win32":
            os.fchmod(new.fileno(), stat.S_IMODE(file.stat().st_mode))
