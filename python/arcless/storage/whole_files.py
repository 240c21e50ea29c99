"""Files that are either whole or absent: written next to their place, then moved into it."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from arcless.errors import OutputError
from arcless.platforms.moving import move
from arcless.storage import hidden_files


def write_bytes(path: str | Path, content: bytes | memoryview) -> None:
    """Write a file whole or not at all.

    Parameters
    ----------
    path
        The file to write; one that exists is replaced. The folder must exist.
    content
        What to write.

    Raises
    ------
    OutputError
        The file cannot be written: folder missing or read-only, disk full.

    Notes
    -----
    Whatever ends the writing early, Ctrl-C included, leaves `path` as it was. A process that is
    killed leaves a hidden file; the next writing into the folder removes it.
    """
    target = Path(os.path.realpath(path))
    if not _is_stream(target):
        with replacing(path) as file:
            file.write(content)
        return
    try:
        target.write_bytes(content)
    except OSError as error:
        raise _not_written(path, error) from error


@contextmanager
def replacing(path: str | Path) -> Iterator[BinaryIO]:
    """Give an empty file to write and read; it takes its place when the block is done.

    Parameters
    ----------
    path
        The file to write; see `write_bytes`. No device, no pipe.

    Raises
    ------
    OutputError
        The file cannot be written.
    """
    target = Path(os.path.realpath(path))  # a link stays a link; `resolve` fails on a loop of them
    temporary = target.with_name(hidden_files.new_name())
    try:
        hidden_files.sweep(target.parent)
        with hidden_files.claimed(temporary):
            try:
                with temporary.open("x+b") as file:
                    yield file
                    file.flush()
                    os.fsync(file.fileno())
                move(temporary, target)
            finally:
                with suppress(OSError):
                    temporary.unlink(missing_ok=True)
        sync_folder(target.parent)
    except OSError as error:
        raise _not_written(path, error) from error


def _not_written(path: str | Path, error: OSError) -> OutputError:
    return OutputError.of(error, "the file cannot be written", path, "choose another place")


def check_writable(path: Path) -> None:
    """Refuse, before any computing, a file that could not be written after it.

    Raises
    ------
    OutputError
        The folder is missing or read-only, or the path is a folder.
    """
    target = Path(os.path.realpath(path))
    folder = target.parent
    if _is_stream(target):
        return
    if target.is_dir():
        got = "a folder"
    elif not folder.is_dir():
        got = f"no folder {folder}"
    elif not os.access(folder, os.W_OK):
        got = f"a read-only folder {folder}"
    else:
        return
    raise OutputError(
        "the file cannot be written",
        where=str(path),
        got=got,
        expected="a file in a folder that exists and can be written",
    )


def _is_stream(target: Path) -> bool:
    """Return whether a path is that of a device or a pipe: nothing that could be replaced."""
    return target.is_fifo() or target.is_char_device()


def sync_folder(folder: Path) -> None:
    """Make new names in a folder survive a power cut, where the file system offers that."""
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
