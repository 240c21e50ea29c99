"""Signals by which a system, or who uses it, ends a program."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager

if sys.platform == "win32":
    # Ctrl-Break; closing the window of the terminal, signing out and shutting down come as this
    # one, too (documentation of `signal` in the C run-time library, and of `HandlerRoutine`).
    ENDING = (signal.SIGTERM, signal.SIGBREAK)
    WORDS: dict[int, str] = {signal.SIGTERM: "terminated", signal.SIGBREAK: "broken off"}
else:
    # Asked for by a batch system or `kill`; by a terminal that was closed.
    ENDING = (signal.SIGTERM, signal.SIGHUP)
    WORDS: dict[int, str] = {signal.SIGTERM: "terminated", signal.SIGHUP: "hung up"}


@contextmanager
def started_without_ctrl_c() -> Iterator[None]:
    """Let processes and threads that are started in the block not hear Ctrl-C.

    A terminal sends it to all of them, and who started them hears it.
    """
    if sys.platform == "win32":
        import ctypes

        # Without a handler: whether Ctrl-C is ignored, which new processes inherit.
        ignore = ctypes.windll.kernel32.SetConsoleCtrlHandler
        ignore(None, True)
        try:
            yield
        finally:
            ignore(None, False)
    else:
        from multiprocessing import resource_tracker

        resource_tracker.ensure_running()  # started later, it would undo what is done here
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            yield
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
