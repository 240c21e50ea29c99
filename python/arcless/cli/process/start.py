"""Start of a process: threads that would wait, and memory that would be searched for garbage."""

import gc
import os
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

_ours = threading.Event()


def open_missing_streams() -> None:
    """Open the standard streams that the process was started without, so that they lead nowhere.

    Services and timed jobs close them (`2>&-`). The next file that is opened would take the number
    of the stream, and whatever a library says of errors would be written into it.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest number that is free: this one
        if getattr(sys, name) is None:
            mode = "r" if number == 0 else "w"
            setattr(sys, name, open(number, mode, encoding="utf-8", closefd=False))  # noqa: SIM115


def claim_process() -> None:
    """Say that this process is ours alone; before NumPy is imported, which starts threads.

    A thread of OpenBLAS waits busily for products, and none here is large enough for two. A number
    set by the user is kept.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    _ours.set()


@contextmanager
def permanent_objects() -> Iterator[None]:
    """Import and build objects that stay to the end; no garbage is looked for among them.

    There are hundreds of thousands of them, which Python would otherwise search again and again.
    In a process of somebody else, that process's objects would stay as well: there nothing is
    changed.
    """
    if not _ours.is_set() or not gc.isenabled():
        yield
        return
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
