"""Signals that end a program, by Ctrl-C or by the system, while the command line works.

All of them end a run in the same way: what is unfinished is removed. Only the exit codes differ.
"""

import signal
import sys
import time

from arcless.platforms.signals import ENDING, WORDS

_BY_CTRL_C = "interrupted"
_ONE_STROKE_S = 1.0  # leaving takes less than this; Ctrl-C again during it changes nothing
_AFTER_SIGNAL = 128  # what a shell adds to the number of the signal that ended a program

_ended_by: list[int] = []


def merge_signals() -> None:
    """Take several signals within a second for one: the second must not stop the cleaning up.

    A process that was started to ignore one (`nohup`) keeps ignoring it.
    """
    answered = -_ONE_STROKE_S

    def answer(number: int, _frame: object) -> None:
        nonlocal answered
        if number != signal.SIGINT:
            _ended_by.append(number)
        now = time.monotonic()
        if now - answered >= _ONE_STROKE_S:
            answered = now
            # Finalizers of what is cut off here may complain: to nobody's use, on the screen.
            sys.unraisablehook = lambda _: None
            raise KeyboardInterrupt

    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, answer)
    for number in ENDING:
        if signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, answer)


def ended() -> bool:
    """Return whether a signal other than Ctrl-C has ended the work."""
    return bool(_ended_by)


def word() -> str:
    """Say in a word what ended the work."""
    return WORDS[_ended_by[0]] if _ended_by else _BY_CTRL_C


def exit_code(by_ctrl_c: int) -> int:
    """Return the exit code of work that was ended; Ctrl-C has one of its own."""
    return _AFTER_SIGNAL + _ended_by[0] if _ended_by else by_ctrl_c


def ignore() -> None:
    """Answer no signal more: everything is done, and the process is leaving."""
    for number in (signal.SIGINT, *ENDING):
        signal.signal(number, signal.SIG_IGN)
