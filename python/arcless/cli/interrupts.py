"""What Ctrl-C does while the command line cleans up, or moves finished files to their names."""

import signal
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

_ONE_STROKE_S = 1.0  # leaving takes less than this; Ctrl-C again during it changes nothing


def answer_once() -> None:
    """Take several Ctrl-C within a second for one: the second must not stop the cleaning up.

    A process that was started to ignore Ctrl-C (`nohup`) goes on ignoring it.
    """
    if signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        return
    answered = -_ONE_STROKE_S

    def answer(_number: int, _frame: object) -> None:
        nonlocal answered
        now = time.monotonic()
        if now - answered >= _ONE_STROKE_S:
            answered = now
            # Finalizers of what is cut off here may complain: to nobody's use, on the screen.
            sys.unraisablehook = lambda _: None
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, answer)


@contextmanager
def held_back() -> Iterator[None]:
    """Answer Ctrl-C after the block, not within; the block takes milliseconds."""
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(before):
        yield
        return
    came: list[int] = []
    signal.signal(signal.SIGINT, lambda number, _frame: came.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if came:
        raise KeyboardInterrupt


def ignore() -> None:
    """Answer Ctrl-C no more: everything is done, and the process is leaving."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
