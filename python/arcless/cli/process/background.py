"""Computation in a second thread, so that Ctrl-C is answered at once.

Python hands a signal to the main thread only, and not before native code returns. Statics of a long
line take seconds in native code; meanwhile the main thread waits here and can leave.
"""

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Generic, TypeVar

Outcome = TypeVar("Outcome")
Asked = Callable[[], bool]
# A run of a second comes back some hundred times; shorter turns cost more switching than they save.
_TURN_S = 2e-4
_LOOK_EVERY_S = 0.1  # how long a wait may hold a signal back on platforms that do not wake it


class _Computation(threading.Thread, Generic[Outcome]):
    def __init__(self, work: Callable[[Asked], Outcome]) -> None:
        super().__init__(daemon=True)
        self._work = work
        self._abandoned = threading.Event()
        self._outcome: list[Outcome] = []
        self._error: BaseException | None = None

    def run(self) -> None:
        """Run the work, and keep its result for the thread that waits."""
        try:
            self._outcome.append(self._work(self._abandoned.is_set))
        except BaseException as error:
            self._error = error

    def outcome(self, meanwhile: Callable[[], object] | None = None) -> Outcome:
        """Wait, then return or raise the outcome of the work; an interrupted wait lets it stop."""
        try:
            if meanwhile is not None:
                with _short_switch_interval():
                    meanwhile()
            while self.is_alive():
                self.join(_LOOK_EVERY_S)
        finally:
            self._abandoned.set()
        if self._error is not None:
            raise self._error
        return self._outcome[0]


@contextmanager
def _short_switch_interval() -> Iterator[None]:
    """Let a computation that returns from native code continue soon, and not after 5 ms."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(_TURN_S)
    try:
        yield
    finally:
        sys.setswitchinterval(before)


def compute(
    work: Callable[[Asked], Outcome], meanwhile: Callable[[], object] | None = None
) -> Outcome:
    """Do work that may stay in native code for long; Ctrl-C leaves it unfinished.

    The work is given something to ask now and then: whether it should stop, as nobody waits.
    `meanwhile` is done by the main thread before it waits: imports that are needed afterwards, as
    native code lets Python continue.
    """
    computation = _Computation(work)
    computation.start()
    return computation.outcome(meanwhile)


def unfinished() -> bool:
    """Return whether a computation still runs that nobody waits for any more."""
    return any(isinstance(thread, _Computation) for thread in threading.enumerate())
