"""Signals that wait until finished files are moved, or unfinished ones removed."""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from arcless.platforms.signals import ENDING


@contextmanager
def deferred_signals() -> Iterator[None]:
    """Answer signals after the block, not within; the block takes milliseconds."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before: dict[int, Callable[..., object]] = {}
    came: list[tuple[int, object]] = []
    for number in (signal.SIGINT, *ENDING):
        handler = signal.getsignal(number)
        if callable(handler) and not isinstance(handler, signal.Handlers):
            before[number] = handler
            signal.signal(number, lambda number, frame: came.append((number, frame)))
    try:
        yield
    finally:
        for held, handler in before.items():
            signal.signal(held, handler)
    for held, frame in came:
        before[held](held, frame)
