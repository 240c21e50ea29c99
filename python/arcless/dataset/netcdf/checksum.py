"""The checksum at the end of a result file: damage is found before a library stumbles over it.

HDF5 trusts what it reads: a stretch of zeros, as a failing disk or a broken copy leaves it, may
send it round in circles for ever. It ignores what follows its own end of a file, so a line with the
SHA-256 of all that is before it stands there. A file without the line, rewritten by another
program or cut short, is read as it is; HDF5 itself notices a file that is too short.
"""

import hashlib
import os
from pathlib import Path
from typing import BinaryIO

from arcless.errors import ResultFormatError

MARK = b"\narcless-sha256:"
SIZE = len(MARK) + 64
CHUNK = 1 << 20


def sealed(content: bytes | memoryview) -> bytes:
    """Return the content of a file with the checksum behind it."""
    return b"".join([content, MARK, hashlib.sha256(content).hexdigest().encode()])


def put(file: BinaryIO) -> None:
    """Put the checksum behind the content of a file that is open for writing and reading."""
    size = file.seek(0, os.SEEK_END)
    file.seek(0)
    digest = _digest(file, size)
    file.seek(size)
    file.write(MARK + digest.encode())


def check(path: Path) -> bool:
    """Compare a file with the checksum at its end; returns whether it has one.

    Raises
    ------
    ResultFormatError
        The file is not as it was written.
    OSError
        The file cannot be read.
    """
    with path.open("rb") as file:
        inner = path.stat().st_size - SIZE
        if inner < 0:
            return False
        file.seek(inner)
        seal = file.read(SIZE)
        if not seal.startswith(MARK):
            return False
        file.seek(0)
        if _digest(file, inner).encode() != seal.removeprefix(MARK):
            raise ResultFormatError(
                "the result file is damaged",
                where=str(path),
                got="bytes that do not fit the checksum at its end",
                expected="the file as `arcless run` wrote it",
                hint="copy it again, or run the scenario again",
            )
    return True


def _digest(file: BinaryIO, size: int) -> str:
    digest = hashlib.sha256()
    while size > 0 and (part := file.read(min(CHUNK, size))):
        digest.update(part)
        size -= len(part)
    return digest.hexdigest()
