"""Paths of files that are open, as the system knows them: no link can be put in between."""

import os
import sys
from collections.abc import Callable
from pathlib import Path

_EXTENDED, _SERVER = "\\\\?\\", "UNC\\"


def plain_path(extended: str) -> str:
    """Return a path of Windows without what its functions for long paths put in front."""
    if not extended.startswith(_EXTENDED):
        return extended
    bare = extended.removeprefix(_EXTENDED)
    return f"\\\\{bare.removeprefix(_SERVER)}" if bare.startswith(_SERVER) else bare


if sys.platform == "win32":

    def path_of(descriptor: int) -> str:
        """Return the path of an open file, links resolved, by `GetFinalPathNameByHandleW`.

        Raises
        ------
        OSError
            The system does not say.
        """
        import ctypes
        import msvcrt
        from ctypes import wintypes

        ask = ctypes.WinDLL("kernel32", use_last_error=True).GetFinalPathNameByHandleW
        ask.argtypes = (wintypes.HANDLE, wintypes.LPWSTR, wintypes.DWORD, wintypes.DWORD)
        handle, size = msvcrt.get_osfhandle(descriptor), 512
        while True:
            text = ctypes.create_unicode_buffer(size)
            length = ask(handle, text, size, 0)
            if not length:
                raise ctypes.WinError(ctypes.get_last_error())
            if length < size:
                return plain_path(text.value)
            size = length + 1


def open_in_place(file: Path, path_of: Callable[[int], str]) -> int:
    """Open a file for reading that is where its path says; return the descriptor.

    If a link was put into the path, the file that is opened has another one.

    Parameters
    ----------
    file
        Whole path, links resolved.
    path_of
        Returns the path of an open file.

    Raises
    ------
    OSError
        It cannot be opened, or is another file.
    """
    only_here = getattr(os, "O_BINARY", 0) | getattr(os, "O_NOINHERIT", 0)
    # A pipe of POSIX is opened without waiting for its other end.
    descriptor = os.open(file, os.O_RDONLY | only_here | getattr(os, "O_NONBLOCK", 0))
    try:
        if os.path.normcase(path_of(descriptor)) != os.path.normcase(file):
            raise OSError("a link leads to another file")
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor
