"""What a process spends before its work: threads that wait, memory that is searched for garbage."""

import gc
import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager

_ours = threading.Event()


def own_process() -> None:
    """Say that this process is ours alone; before NumPy is imported, which starts threads.

    A thread of OpenBLAS waits busily for products, and none here is large enough for two. Whoever
    sets their number gets as many.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    _ours.set()


@contextmanager
def staying() -> Iterator[None]:
    """Import and build what stays to the end; no garbage is looked for among it, then or later.

    There are hundreds of thousands of objects, which are gone through time and again otherwise.
    In a process of somebody else his own would stay as well: there nothing is changed.
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
