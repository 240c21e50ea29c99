"""The version of the program, told apart by its files: releases and working copies alike."""

import hashlib
from functools import cache
from importlib.metadata import version
from pathlib import Path

_PACKAGE = Path(__file__).parents[2]


@cache
def code_version() -> str:
    """Return the version and a digest of the program's files, such as ``0.1.0+1f0c6a2b9d3e``.

    The Python modules, the compiled core and the shipped models count, each with its name.
    """
    digest = hashlib.sha256()
    # `.pyd` is the core on Windows
    for suffix in ("*.py", "*.so", "*.pyd", "*.yaml"):
        for file in sorted(_PACKAGE.rglob(suffix)):
            digest.update(f"{file.relative_to(_PACKAGE).as_posix()}\n".encode())
            digest.update(file.read_bytes())
    return f"{version('arcless')}+{digest.hexdigest()[:12]}"
