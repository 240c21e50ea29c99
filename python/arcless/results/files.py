"""Files that are either whole or absent: written beside their place, then moved into it."""

import os
import secrets
from contextlib import suppress
from pathlib import Path

from arcless.errors import OutputError


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
    Whatever ends the writing early, Ctrl-C included, leaves `path` as it was.
    """
    target = Path(path)
    temporary = target.with_name(f".{target.name[:80]}.{secrets.token_hex(4)}.part")
    try:
        temporary.write_bytes(content)
        _flush(temporary)
        temporary.replace(target)
        _flush(target.parent)
    except OSError as error:
        raise OutputError(
            "the file cannot be written",
            where=str(target),
            got=error.strerror or str(error),
            expected="a folder that exists and can be written, with room on its disk",
            hint="choose another place",
        ) from error
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


def _flush(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
