"""The folder at a glance: models, runs, studies, measured data, and the shipped library."""

import threading
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError
from arcless.model.shipped.library import library
from arcless.results.kept_runs.kept_run import KeptRun
from arcless.results.kept_runs.reading import read as read_run
from arcless.results.kept_runs.search import search
from arcless.studio.project.measured import ENDING, FOLDER
from arcless.studio.project.models import Models
from arcless.studio.project.project import Project
from arcless.studio.project.tree import Stamp, Tree, stamp_of

# Bytes of a CSV file that are looked at, for its header.
_HEAD = 4096
_FORCE = b"force"
# A run is read again where its result changed, or the assessment next to it.
_BESIDE = ("assessment.json",)
# A study is known by these; its rows are counted again where one of them changed.
_OF_STUDY = ("study.json", "journal.db", "journal.db-wal", "journal.jsonl")


class View:
    """The project as the page shows it; what was read is kept until it changes on the disk."""

    def __init__(self, project: Project) -> None:
        self.project, self.tree, self.models = project, Tree(project.folder), Models(project)
        self._lock = threading.Lock()
        self._runs: dict[Path, tuple[object, KeptRun]] = {}
        self._studies: dict[Path, tuple[object, dict[str, Any]]] = {}
        self._measured: dict[Path, tuple[Stamp, bool]] = {}

    def read(self) -> dict[str, Any]:
        """Return the view; see `ProjectView` of the page."""
        with self._lock:
            return self._read()

    def _read(self) -> dict[str, Any]:
        files = dict(self.tree.files)
        found = search(self.project.folder, self._run)
        of_runs = {one.path for one in found.runs}
        inside = {*found.studies, *of_runs}
        texts = {path: stamp for path, stamp in files.items() if not inside & {*path.parents}}
        return {
            "name": self.project.folder.name,
            "folder": str(self.project.folder),
            "version": version("arcless"),
            "is_whole": self.tree.is_whole,
            "models": self.models.entries(texts),
            "library": _library(),
            "runs": [self._named(one) for one in found.runs],
            "studies": [self._study(path) for path in found.studies],
            "measured": [
                {"path": self.project.name_of(path), "bytes": stamp.size}
                for path, stamp in sorted(texts.items())
                if self._is_measured(path, stamp)
            ],
        }

    def _named(self, run: KeptRun) -> dict[str, Any]:
        return run.to_dict() | {"path": self.project.name_of(run.path)}

    def _run(self, file: Path) -> KeptRun:
        stamps = _stamps(file.parent, file.name, *_BESIDE)
        known = self._runs.get(file)
        if known is None or known[0] != stamps:
            known = self._runs[file] = (stamps, read_run(file))
        return known[1]

    def _study(self, folder: Path) -> dict[str, Any]:
        stamps = _stamps(folder, *_OF_STUDY)
        known = self._studies.get(folder)
        if known is None or known[0] != stamps:
            known = self._studies[folder] = (stamps, _counted(folder))
        return known[1] | {"path": self.project.name_of(folder)}

    def _is_measured(self, path: Path, stamp: Stamp) -> bool:
        """Return whether a CSV file may be a measured run: it is kept as one, or has a force."""
        if path.suffix.lower() != ENDING:
            return False
        known = self._measured.get(path)
        if known is None or known[0] != stamp:
            is_one = path.parent == self.project.folder / FOLDER or _FORCE in _head(path).lower()
            known = self._measured[path] = (stamp, is_one)
        return known[1]


@cache
def _library() -> list[dict[str, Any]]:
    return [
        {"path": f"shipped:{one.kind}/{one.name}", "kind": one.kind, "name": one.name,
         "description": one.title}
        for one in library() if one.kind != "wire"
    ]  # fmt: skip


def _counted(folder: Path) -> dict[str, Any]:
    from arcless import study

    try:
        found = study.open(folder)
        state = study.status(found.study, folder)
    except ArclessError as error:
        return {"name": folder.name, "done": 0, "planned": None, "error": str(error)}
    return {"name": state.name, "done": state.done, "planned": state.total}


def _stamps(folder: Path, *names: str) -> tuple[Stamp | None, ...]:
    return tuple(stamp_of(f"{folder}/{name}") for name in names)


def _head(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            return file.read(_HEAD)
    except OSError:
        return b""
