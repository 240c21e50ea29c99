"""Short digests, by which a file on disk is told from another one of the same name."""

import hashlib
from pathlib import Path

# Hexadecimal digits, 48 bits: two of 1000 files meet by chance once in 5e8 times. Fewer would be
# met, more are not compared by eye.
DIGITS = 12


def short_digest(file: Path) -> str:
    """Return the first 12 hexadecimal digits of the SHA-256 of a file, as ``sha256sum`` prints it.

    Raises
    ------
    OSError
        The file cannot be read.
    """
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()[:DIGITS]
