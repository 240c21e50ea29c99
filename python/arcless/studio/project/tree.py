"""Files of the folder, and which of them changed since one looked last.

Looking again costs a call of the system for each folder and each text: a folder is listed again
only where its time changed, as it does when something in it is made, removed or replaced. Texts are
looked at one by one, since many editors write them where they stand.
"""

import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

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
        folders = dict(self._walk(str(self._top)))
        self.is_whole = len(folders) < MOST_FOLDERS
        self._folders = folders
        found = {
            Path(name, file): stamp
            for name, folder in folders.items()
            for file, stamp in folder.files.items()
        }
        before, self.files = self.files, found
        return {path for path in {**before, **found} if before.get(path) != found.get(path)}

    def _walk(self, top: str) -> Iterator[tuple[str, _Folder]]:
        waiting, count = [top], 0
        while waiting and count < MOST_FOLDERS:
            name = waiting.pop()
            folder = self._folder(name)
            if folder is not None:
                count += 1
                yield name, folder
                waiting += [f"{name}/{one}" for one in folder.below]

    def _folder(self, name: str) -> _Folder | None:
        """Return what is in a folder; None where nobody may look, or it has just gone."""
        try:
            changed = os.stat(name).st_mtime_ns  # noqa: PTH116 - twice as fast as a `Path`
            known = self._folders.get(name)
            if known is None or known.changed != changed:
                return _listed(name, changed)
        except OSError:
            return None
        for file in known.files:
            stamp = stamp_of(f"{name}/{file}")
            if stamp is not None:
                known.files[file] = stamp
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
    return found


def stamp_of(path: str) -> Stamp | None:
    """Return the stamp of a regular file; None of anything else."""
    try:
        state = os.stat(path)  # noqa: PTH116 - twice as fast as a `Path`
    except OSError:
        return None
    return Stamp(state.st_mtime_ns, state.st_size) if stat.S_ISREG(state.st_mode) else None
