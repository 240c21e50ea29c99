"""The folder of a project: the only place of the disk that the page reads and writes."""

import os
import sys
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from arcless.errors import OutputError
from arcless.platforms.file_names import refused_by_windows
from arcless.storage.shipped_files import FOLDERS, shipped
from arcless.units import show

_SHIPPED = "shipped:"
# Letters of a path below the folder; systems take about as many.
_LONGEST = 4096


@dataclass(frozen=True)
class Project:
    """A folder.

    Attributes
    ----------
    folder
        Its whole path, links resolved.
    """

    folder: Path

    @classmethod
    def of(cls, folder: Path) -> "Project":
        """Return the project of a folder.

        Raises
        ------
        OutputError
            It is none.
        """
        if not folder.is_dir():
            raise OutputError("no such folder", where=str(folder), expected="a folder that exists")
        return cls(folder.resolve())

    def inside(self, path: str) -> Path:
        """Return the whole path of a file below the folder, given with slashes.

        Raises
        ------
        OutputError
            It leads out of the folder, by itself or by a link, it is hidden, or no path at all.
        """
        parts = PurePosixPath(path).parts if isinstance(path, str) else ()
        is_plain = parts and "\0" not in path and "\\" not in path and len(path) <= _LONGEST
        if not is_plain or path.startswith("/") or any(part.startswith(".") for part in parts):
            raise _outside(path)
        if sys.platform == "win32" and any(refused_by_windows(part) for part in parts):
            raise _outside(path)  # a device, a stream of a file, a file by another name
        try:
            whole = (self.folder / path).resolve()
        except (OSError, RuntimeError, ValueError):
            raise _outside(path) from None
        if not whole.is_relative_to(self.folder):
            raise _outside(path)
        if any(part.startswith(".") for part in whole.relative_to(self.folder).parts):
            raise _outside(path)
        return whole

    def model_file(self, path: str) -> Path:
        """Return the file of a model: below the folder, or of `shipped:KIND/NAME`.

        Raises
        ------
        OutputError
            There is no such shipped model, or the path is none below the folder.
        """
        if not isinstance(path, str) or not path.startswith(_SHIPPED):
            return self.inside(path)
        kind, _, name = path.removeprefix(_SHIPPED).partition("/")
        found = shipped(kind).get(name) if kind in FOLDERS else None
        if found is None:
            raise OutputError("no such shipped model", got=show(path),
                              expected="shipped:KIND/NAME")  # fmt: skip
        return found

    def name_of(self, file: str | os.PathLike[str]) -> str:
        """Return the path of a file below the folder, with slashes."""
        return Path(file).relative_to(self.folder).as_posix()


def is_shipped(path: str) -> bool:
    """Return whether a path is that of a shipped model, which nobody writes."""
    return path.startswith(_SHIPPED)


def _outside(path: object) -> OutputError:
    return OutputError("no file of this folder", got=show(path),
                       expected="a path below it, without hidden parts")  # fmt: skip
