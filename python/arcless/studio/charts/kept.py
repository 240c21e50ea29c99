"""Things made of files, kept while the files stay as they are and memory allows."""

from collections import OrderedDict
from collections.abc import Callable, Hashable
from pathlib import Path
from threading import RLock
from typing import Generic, Protocol, TypeVar

from arcless.errors import OutputError

# Memory of all that is kept, in bytes: some runs of 50 km. Less, a run is read again and again
# where several are looked at in turn; more, the runs that are computed meanwhile have less.
MOST_BYTES = 512 * 2**20


class Weighed(Protocol):
    """Something that says how much memory it takes."""

    @property
    def bytes(self) -> int:
        """Bytes in memory; may grow."""


Thing = TypeVar("Thing", bound=Weighed)
# Path, and what of a file changes when it is written: its number on the disk, size, and time.
FileIdentity = tuple[str, int, int, int]
Identity = tuple[tuple[FileIdentity, ...], tuple[tuple[str, Hashable], ...]]


def identity(file: Path) -> FileIdentity:
    """Return by what a file is known to be the same as before.

    Raises
    ------
    OutputError
        There is none, or nobody may look.
    """
    try:
        found = file.stat()
    except OSError as error:
        raise OutputError("no such file", where=str(file), got=error.strerror) from error
    return str(file), found.st_ino, found.st_size, found.st_mtime_ns


class Kept(Generic[Thing]):
    """Things made of files, the one used longest ago forgotten first.

    The newest one is kept whatever it takes. Threads may ask at the same time; a thing is made
    once.

    Parameters
    ----------
    make
        Files → thing.
    most_bytes
        Memory of all things together.
    """

    def __init__(self, make: Callable[..., Thing], most_bytes: int = MOST_BYTES) -> None:
        self._make, self._most = make, most_bytes
        self._things: OrderedDict[Identity, Thing] = OrderedDict()
        self._making: dict[Identity, RLock] = {}
        self._lock = RLock()

    def of(self, *files: Path, **how: Hashable) -> Thing:
        """Return what is made of files, as they are now, and of what else its maker is told."""
        key = tuple(identity(one) for one in files), tuple(sorted(how.items()))
        with self._lock:
            mine = self._making.setdefault(key, RLock())
        with mine:
            try:
                with self._lock:
                    known = self._things.get(key)
                thing = self._make(*files, **how) if known is None else known
            finally:
                with self._lock:
                    self._making.pop(key, None)
            with self._lock:
                self._things[key] = thing
                self._things.move_to_end(key)
                self._forget(key)
        return thing

    def _forget(self, newest: Identity) -> None:
        """Forget earlier states of the newest files, then the oldest things beyond the memory."""
        paths = [one[0] for one in newest[0]]
        for key in list(self._things):
            if key != newest and [one[0] for one in key[0]] == paths:
                del self._things[key]
        while (
            len(self._things) > 1 and sum(one.bytes for one in self._things.values()) > self._most
        ):
            self._things.popitem(last=False)
