"""Test of a folder for a write-ahead log: memory that all processes on it share.

Processes on two machines share no memory, so a folder on a network has none, though trying it from
one machine shows nothing wrong. Source: SQLite, "Write-Ahead Logging", disadvantages.
"""

import os
import re
import shutil
import sqlite3
import sys
from contextlib import closing
from pathlib import Path

from arcless.storage import hidden_files
from arcless.study.journal.database import connect

_MOUNTS = Path("/proc/self/mountinfo")
# Kinds of file systems on disks of this machine. One that is not named is taken for a network.
_LOCAL = {
    "bcachefs", "btrfs", "exfat", "ext2", "ext3", "ext4", "f2fs", "fuseblk", "jfs", "ntfs3",
    "overlay", "ramfs", "reiserfs", "tmpfs", "vfat", "xfs", "zfs",
}  # fmt: skip
_OCTAL = re.compile(r"\\([0-7]{3})")


def carries_wal(folder: Path) -> bool:
    """Return whether a folder carries a write-ahead log."""
    return is_local(folder) and _works(folder)


def is_local(folder: Path) -> bool:
    """Return whether a folder is on this machine; where nobody can tell, it is taken for it."""
    place = os.path.realpath(folder)
    if sys.platform == "win32":
        return not place.startswith("\\\\")  # letters of network drives are resolved, too
    kind = _kind(place)
    return kind is None or kind in _LOCAL


def _kind(place: str) -> str | None:
    """Return the kind of the file system of a folder; None where the system does not say."""
    try:
        mounts = _MOUNTS.read_text("utf-8", "surrogateescape").splitlines()
    except OSError:
        return None
    found, longest = None, -1
    for mount in mounts:
        before, _, after = mount.partition(" - ")
        point = _OCTAL.sub(lambda digits: chr(int(digits[1], 8)), before.split()[4])
        inside = place == point or place.startswith(point.rstrip("/") + "/")
        if inside and len(point) >= longest:  # of two on one place the later one is seen
            found, longest = after.split()[0], len(point)
    return found


def _works(folder: Path) -> bool:
    """Try a write-ahead log next to the journal: a failure there would make it unreadable."""
    hidden = folder / hidden_files.new_name()
    try:
        claim = hidden_files.create_folder(hidden)
    except OSError:
        return False
    try:
        with closing(connect(hidden / "trial.db")) as base:
            base.execute("PRAGMA synchronous = OFF")  # nothing in it is worth a power cut
            (mode,) = base.execute("PRAGMA journal_mode = WAL").fetchone()
            base.execute("CREATE TABLE trial (number INTEGER)")
            return bool(mode == b"wal")
    except sqlite3.Error:
        return False
    finally:
        shutil.rmtree(hidden, ignore_errors=True)
        claim.close()
