"""A file for the HDF5 library that never fails it.

HDF5 may end the whole process when it cannot write. So what goes wrong on the disk is kept here,
and raised as soon as Python has its say again.
"""

import os
from typing import BinaryIO


class ErrorKeepingFile:
    """File object for h5py, over a file that is open for writing and reading."""

    def __init__(self, file: BinaryIO) -> None:
        self.file = file
        self._place = self._size = 0
        self._error: OSError | ValueError | None = None

    def check(self) -> None:
        """Raise the first error of the disk.

        Raises
        ------
        OSError
            The disk is full, or whatever else the system says.
        """
        if self._error is not None:
            raise self._error

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        """Move to a place, counted from the start, from here or from the end."""
        self._place = offset + (0, self._place, self._size)[whence]
        return self._place

    def tell(self) -> int:
        """Return the place."""
        return self._place

    def read(self, size: int) -> bytes:
        """Read from the place on; zeros where the disk has failed."""
        content = b""
        try:
            self.file.seek(self._place)
            content = self.file.read(size)
        except (OSError, ValueError) as error:
            self._keep(error)
        self._place += size
        return content.ljust(size, b"\0")

    def write(self, content: memoryview) -> int:
        """Write to the place, as long as nothing has failed."""
        if self._error is None:
            try:
                self.file.seek(self._place)
                self.file.write(content)
            except (OSError, ValueError) as error:
                self._keep(error)
        self._place += len(content)
        self._size = max(self._size, self._place)
        return len(content)

    def truncate(self, size: int) -> int:
        """Make the file as long as this."""
        try:
            self.file.truncate(size)
        except (OSError, ValueError) as error:
            self._keep(error)
        self._size = size
        return size

    def flush(self) -> None:
        """Do nothing: the owner of the file flushes it."""

    def _keep(self, error: OSError | ValueError) -> None:
        # ValueError: the file was closed, as when a run is interrupted.
        self._error = self._error or error
