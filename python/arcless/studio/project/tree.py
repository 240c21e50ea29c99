"""Files of the folder, and which of them changed since one looked last.

Looking again costs a call of the system for each folder and each text: a folder is listed again
only where its time changed, as it does when something in it is made, removed or replaced. Texts are
looked at one by one, since many editors write them where they stand; files of runs are only ever
replaced.
"""

import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from arcless.results.kept_runs.places import RESULT_NAME

# Folders that are looked into. Fewer, and models of a large project are missing; more, and a studio
# that was opened on a whole disk looks through it for minutes.
MOST_FOLDERS = 3000
# Folders of other programs, with thousands of files of their own.
_OTHERS = {"node_modules", "__pycache__", "site-packages", "venv"}
WATCHED = (".yaml", ".yml", ".json", ".csv", ".nc", ".db", ".db-wal")


class Stamp(NamedTuple):
    """Time of change in ns, and size in bytes: another file has another one."""

    changed: int
    size: int


@dataclass
class _Folder:
    changed: int
    below: list[str] = field(default_factory=list)
    files: dict[str, Stamp] = field(default_factory=dict)
    is_run: bool = False


class Tree:
    """Watched files below a folder.

    Parameters
    ----------
    top
        The folder, whole path.

    Attributes
    ----------
    files
        Stamps of the files by their whole paths.
    is_whole
        False where there are more folders than are looked into.
    """

    def __init__(self, top: Path) -> None:
        self._top = top
        self._folders: dict[str, _Folder] = {}
        self.files: dict[Path, Stamp] = {}
        self.is_whole = True

    def look(self) -> set[Path]:
        """Look again, and return the files that are new, changed or gone."""
        before, changes = self._folders, dict[Path, Stamp | None]()
        self._folders = dict(self._walk(str(self._top), changes))
        self.is_whole = len(self._folders) < MOST_FOLDERS
        for name in before.keys() - self._folders.keys():
            changes.update({Path(name, file): None for file in before[name].files})
        files = {**self.files, **changes}
        self.files = {path: stamp for path, stamp in files.items() if stamp is not None}
        return set(changes)

    def _walk(self, top: str, changes: dict[Path, Stamp | None]) -> Iterator[tuple[str, _Folder]]:
        waiting, count, before = [top], 0, self._folders
        while waiting and count < MOST_FOLDERS:
            name = waiting.pop()
            folder = _looked_at(name, before.get(name), changes)
            if folder is not None:
                count += 1
                yield name, folder
                waiting += [f"{name}/{one}" for one in folder.below]


def _looked_at(
    name: str, known: _Folder | None, changes: dict[Path, Stamp | None]
) -> _Folder | None:
    """Return what is in a folder; None where nobody may look, or it has just gone."""
    try:
        changed = os.stat(name).st_mtime_ns  # noqa: PTH116 - twice as fast as a `Path`
        if known is None or known.changed != changed:
            found = _listed(name, changed)
            before = {} if known is None else known.files
            for file in {**before, **found.files}:
                if before.get(file) != found.files.get(file):
                    changes[Path(name, file)] = found.files.get(file)
            return found
    except OSError:
        return None
    for file, before_ in [] if known.is_run else list(known.files.items()):
        stamp = stamp_of(f"{name}/{file}")
        if stamp is not None and stamp != before_:
            changes[Path(name, file)] = known.files[file] = stamp
    return known


def _listed(name: str, changed: int) -> _Folder:
    found = _Folder(changed)
    with os.scandir(name) as entries:
        for one in entries:
            if one.name.startswith("."):
                continue
            if one.is_dir(follow_symlinks=False):
                if one.name not in _OTHERS:
                    found.below.append(one.name)
            elif one.name.lower().endswith(WATCHED) and (stamp := stamp_of(one.path)) is not None:
                found.files[one.name] = stamp
    found.below.sort(reverse=True)  # the last one is looked into first
    found.is_run = RESULT_NAME in found.files
    return found


def stamp_of(path: str) -> Stamp | None:
    """Return the stamp of a regular file; None of anything else."""
    try:
        state = os.stat(path)  # noqa: PTH116 - twice as fast as a `Path`
    except OSError:
        return None
    return Stamp(state.st_mtime_ns, state.st_size) if stat.S_ISREG(state.st_mode) else None
