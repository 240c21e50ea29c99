"""The folder of a project: the only place of the disk that the page reads and writes."""

from dataclasses import dataclass
from pathlib import Path

from arcless.errors import OutputError


@dataclass(frozen=True)
class Project:
    """A folder.

    Attributes
    ----------
    folder
        Its whole path, links resolved.
    """

    folder: Path

    def inside(self, path: str) -> Path:
        """Return the whole path of a file below the folder, given with slashes.

        Raises
        ------
        OutputError
            It leads out of the folder, by itself or by a link.
        """
        whole = (self.folder / path).resolve()
        if not whole.is_relative_to(self.folder):
            raise OutputError("outside of the folder", got=path, expected="a path below it")
        return whole
