"""Texts of model files: read, and saved whole or not at all, unless somebody else was faster."""

import hashlib
from pathlib import Path
from typing import Any

from arcless.errors import OutputError
from arcless.model.files.yaml_reader import read_text
from arcless.storage.whole_files import write_bytes
from arcless.studio.answers.answers import Refused
from arcless.studio.project.kinds import kind_of
from arcless.studio.project.project import Project, is_shipped
from arcless.units import show

ENDINGS = (".yaml", ".yml", ".json")


def read(project: Project, path: str) -> dict[str, Any]:
    """Return a text, its kind, and its version, the SHA-256 of its bytes."""
    file = model_file(project, path)
    text = read_text(file, path)
    return {
        "path": path,
        "kind": kind_of(text),
        "text": text,
        "version": version_of(file.read_bytes()),
        "writable": not is_shipped(path),
    }


def write(project: Project, path: str, text: str, version: str | None) -> dict[str, str]:
    """Save a text; refuse where the file on the disk has another version."""
    file = model_file(project, path)
    current = version_of(file.read_bytes()) if file.exists() else None
    if current != version:
        now = None if current is None else {"text": read_text(file, path), "version": current}
        raise Refused(409, f"{path} was changed by another program", current=now)
    write_bytes(file, text.encode())
    return {"version": version_of(text.encode())}


def model_file(project: Project, path: str) -> Path:
    """Return the file of a model; refuse one that does not end as a model file does."""
    file = project.model_file(path)
    if file.suffix.lower() not in ENDINGS:
        raise OutputError("no model file", got=show(path), expected=", ".join(ENDINGS))
    return file


def version_of(content: bytes) -> str:
    """Return the version of a file: the SHA-256 of its bytes."""
    return hashlib.sha256(content).hexdigest()
