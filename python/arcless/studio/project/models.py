"""Models of the folder in a few words, kept until their files change."""

import os
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError
from arcless.model.files.yaml_reader import decoded, parse
from arcless.model.load import load_text
from arcless.storage.shipped_files import shipped
from arcless.studio.project.kinds import kind_of
from arcless.studio.project.opening import read_bytes
from arcless.studio.project.project import Project
from arcless.studio.project.tree import Stamp
from arcless.study.definition.load import load_text as load_study_text

ENDINGS = (".yaml", ".yml", ".json")
_REFERENCES = (*ENDINGS, ".csv", ".py")
Files = dict[Path, Stamp]


@dataclass
class _Known:
    """Content of a file: its text where it is a model, and the files that it names.

    `error` says why it cannot be read, as of `state`, the stamps of itself and of these files.
    """

    stamp: Stamp
    entry: dict[str, Any] | None
    text: str = ""
    names: set[Path] = field(default_factory=set)
    state: tuple[Stamp | None, ...] | None = None
    error: str | None = None


class Models:
    """Entries of model files: at a glance at once, and whether they can be read a moment later."""

    def __init__(self, project: Project) -> None:
        self._project = project
        self._known: dict[Path, _Known] = {}
        self._lock = threading.Lock()

    def entries(self, files: Files) -> list[dict[str, Any]]:
        """Return the entries of all model files among some, by their paths."""
        with self._lock:
            found = list(self._models(files))
        wrong = {path: known for path, known in found if known.error}
        return [
            known.entry
            | {"names": self._inside(known.names)}
            | ({"error": self._told(known, wrong)} if known.error else {})
            for _, known in found
            if known.entry is not None
        ]

    def _told(self, known: _Known, wrong: dict[Path, _Known]) -> str:
        """Return why a file cannot be read; of a file that it names, which says why itself, so."""
        error = (known.error or "").replace(f"{self._project.folder}/", "")
        for path in sorted(known.names & wrong.keys()):
            label = self._project.name_of(path)
            if error.startswith(f"{label}:"):
                return f"names {label}, which cannot be read"
        return error

    def _inside(self, names: set[Path]) -> list[str]:
        """Return the files of the folder among some, as the page names them."""
        whole = sorted(Path(os.path.normpath(one)) for one in names)
        folder = self._project.folder
        return [self._project.name_of(one) for one in whole if one.is_relative_to(folder)]

    def check(self, files: Files) -> bool:
        """Read models as `arcless check` does where they changed; return whether any verdict did.

        It takes some milliseconds for each; the line at rest is not looked for.
        """
        with self._lock:
            found = list(self._models(files))
        changed = False
        for path, known in found:
            state = (known.stamp, *(files.get(one) for one in sorted(known.names)))
            if known.state != state:
                error = self._error(path, known)
                changed |= error != known.error
                known.error, known.state = error, state
        return changed

    def _models(self, files: Files) -> Iterator[tuple[Path, _Known]]:
        for gone in self._known.keys() - files.keys():
            del self._known[gone]
        for path in sorted(files):
            if path.suffix.lower() in ENDINGS:
                known = self._known.get(path)
                if known is None or known.stamp != files[path]:
                    known = self._known[path] = self._read(path, files[path])
                if known.entry is not None:
                    yield path, known

    def _read(self, path: Path, stamp: Stamp) -> _Known:
        label = self._project.name_of(path)
        entry: dict[str, Any] = {"path": label, "name": path.stem, "description": ""}
        try:
            text = decoded(read_bytes(self._project, path, label), label)
        except ArclessError as error:
            # Of a text that cannot be read only the name tells that it may be a model.
            is_text = path.suffix.lower() != ".json"
            entry["kind"] = "scenario"
            return _Known(stamp, entry | {"error": str(error)} if is_text else None)
        kind = kind_of(text)
        if kind is None:
            return _Known(stamp, None)
        entry["kind"] = kind
        try:
            data, _ = parse(text, label)
        except ArclessError:
            return _Known(stamp, entry, text)
        entry["name"] = str(data.get("name") or path.stem)
        entry["description"] = str(data.get("description") or "")
        return _Known(stamp, entry, text, set(_named(data, path.parent)))

    def _error(self, path: Path, known: _Known) -> str | None:
        if known.entry is None or not known.text:
            return known.error
        load = load_study_text if known.entry["kind"] == "study" else load_text
        try:
            load(known.text, path, self._project.folder)
        except ArclessError as error:
            return str(error)
        return None


def _named(data: Any, folder: Path) -> Iterator[Path]:
    """Yield the files that values of a model may name."""
    if isinstance(data, str):
        name = data.rpartition(":")[0] if ".py:" in data else data
        if name.lower().endswith(_REFERENCES) and name not in shipped("line") and "\0" not in name:
            yield folder / name
        return
    for one in data.values() if isinstance(data, dict) else data if isinstance(data, list) else ():
        yield from _named(one, folder)
