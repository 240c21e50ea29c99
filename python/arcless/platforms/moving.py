"""A file moved to its place, also where other programs look at new files for a moment."""

import sys
import time
from pathlib import Path

# Time in s that a search index or a virus scanner of Windows may have a new file open. Shorter, a
# finished result is lost to it; longer, who has the file open in a program waits for the refusal.
PATIENCE_S = 2.0
_BETWEEN_S = 0.05


def move(source: Path, target: Path, patience_s: float | None = None) -> None:
    """Move a file to its place; one that is there is replaced.

    Windows replaces no file that a program has open, and moves none: it is tried again for a while.

    Parameters
    ----------
    source, target
        The file, and where it goes, in the same file system.
    patience_s
        Time in s in which a refusal may pass; the usual one of the system without.

    Raises
    ------
    OSError
        It cannot be moved. It is still where it was.
    """
    if patience_s is None:
        patience_s = PATIENCE_S if sys.platform == "win32" else 0.0
    end = time.monotonic() + patience_s
    while True:
        try:
            source.replace(target)
            return
        except PermissionError:
            if time.monotonic() >= end:
                raise
        time.sleep(_BETWEEN_S)
