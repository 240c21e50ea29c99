"""Files of a project opened without following any link, so that none can be put in between.

The path of a file was resolved before, which follows links and looks where they lead. If somebody
puts a link into it afterwards, opening it fails: no step of the way may be a link then.
"""

import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from arcless.errors import OutputError
from arcless.model.files.yaml_reader import MAX_BYTES, check_size
from arcless.studio.project.project import Project

if sys.platform == "win32":
    from arcless.platforms.opened_paths import open_in_place, path_of


def read_bytes(project: Project, file: Path, label: str) -> bytes:
    """Return the bytes of a file of the project, or of a shipped one.

    Parameters
    ----------
    project
        The project.
    file
        Whole path, links resolved.
    label
        Its path as the page knows it, for messages.

    Raises
    ------
    OutputError
        It is not there, is no regular file, or a link was put into its path.
    ModelError
        It is too large for a text.
    """
    try:
        with _opened(project, file) as descriptor:
            state = os.fstat(descriptor)
            if not stat.S_ISREG(state.st_mode):
                raise OutputError("not a file", where=label, expected="a regular file")
            check_size(state.st_size, label)
            with os.fdopen(os.dup(descriptor), "rb") as opened:
                return opened.read(MAX_BYTES)
    except OSError as error:
        got = error.strerror or str(error)
        raise OutputError("the file cannot be read", where=label, got=got) from None


@contextmanager
def _opened(project: Project, file: Path) -> Iterator[int]:
    descriptor = _open(project, file)
    try:
        yield descriptor
    finally:
        os.close(descriptor)


if sys.platform == "win32":

    def _open(_project: Project, file: Path) -> int:
        """Open a file, and look afterwards which one it is: folders are not opened there."""
        return open_in_place(file, path_of)
else:
    _FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC
    # A pipe is opened without waiting for its other end, and then refused.
    _FILE = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC

    def _open(project: Project, file: Path) -> int:
        """Open a file by the folders above it, one in the other."""
        is_own = file.is_relative_to(project.folder)
        parts = file.relative_to(project.folder).parts if is_own else (file.name,)
        here = os.open(project.folder if is_own else file.parent, os.O_RDONLY | os.O_DIRECTORY)
        try:
            for part in parts[:-1]:
                below = os.open(part, _FOLDER, dir_fd=here)
                os.close(here)
                here = below
            return os.open(parts[-1], _FILE, dir_fd=here)
        finally:
            os.close(here)
