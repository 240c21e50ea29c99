"""Processes that Ctrl-C reaches, whoever started the tests."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def interruptible() -> Iterator[None]:
    """Let processes started within answer Ctrl-C.

    A shell that runs the tests in the background, or `nohup`, tells them to ignore it, and every
    process inherits that. What this process handles itself, its children start with anew.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
