"""The version of the program, told apart by its files: releases and working copies alike."""

import hashlib
from functools import cache
from importlib.metadata import version
from pathlib import Path

_PACKAGE = Path(__file__).parents[2]
# The core is `.so`, on Windows `.pyd`.
_COUNTED = ("*.py", "*.so", "*.pyd", "*.yaml")
# Libraries that exported FMUs carry: no run loads them, and which are there depends on the build.
_CARRIED = "fmi/libraries/"


@cache
def code_version() -> str:
    """Return the version and a digest of the program's files, such as ``0.1.0+1f0c6a2b9d3e``.

    All that a result depends on counts, each file with its name: the Python modules, the compiled
    core and the shipped models.
    """
    digest = hashlib.sha256()
    for suffix in _COUNTED:
        for file in sorted(_PACKAGE.rglob(suffix)):
            name = file.relative_to(_PACKAGE).as_posix()
            if name.startswith(_CARRIED):
                continue
            digest.update(f"{name}\n".encode())
            digest.update(file.read_bytes())
    return f"{version('arcless')}+{digest.hexdigest()[:12]}"
