"""Talk of a function in a worker process with the server: progress, notes, orders; its end."""

import queue
import select
import time
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from threading import Event, Lock
from typing import Any

# Time in s between two messages of progress: faster than anyone reads, slow enough to cost nothing.
_BETWEEN_S = 0.05


@dataclass
class Talk:
    """Handed to a function in a worker process, as its first argument.

    Attributes
    ----------
    connection
        Leads to the server.
    spool
        Descriptor of the file that takes motion; None where nobody watches.
    cancelled
        Set when the task is to end.
    orders
        Orders of the server that have not been taken.
    """

    connection: Connection
    spool: int | None = None
    cancelled: Event = field(default_factory=Event)
    orders: "queue.SimpleQueue[Any]" = field(default_factory=queue.SimpleQueue)
    _next: float = 0.0
    _phase: str = ""
    _one: Lock = field(default_factory=Lock)

    def progress(self, fraction: float, doing: str) -> None:
        """Tell the fraction done and what is being done, not oftener than 20 times a second.

        Another phase is told at once: a short one would be missed, and what comes behind it has the
        name of the one before. What stands behind a comma, the time of the run, is no other phase.
        A server that does not listen, a stopped one, is told nothing: the run does not wait.
        """
        now, phase = time.monotonic(), doing.partition(",")[0]
        if (now >= self._next or phase != self._phase) and self.has_room():
            self._next, self._phase = now + _BETWEEN_S, phase
            self.say(("progress", fraction, doing))

    def note(self, text: str) -> None:
        """Tell a warning, a whole sentence."""
        self.say(("note", text))

    def say(self, said: Any) -> None:
        """Send anything that pickles to who started the task."""
        self.send(("said", said))

    def cancel(self) -> bool:
        """Return whether the task is to end, as `arcless.run` asks."""
        return self.cancelled.is_set()

    def order(self, within_s: float) -> Any:
        """Return the next order of the server, None where none comes within a time in s."""
        try:
            return self.orders.get(timeout=within_s)
        except queue.Empty:
            return None

    def shows(self) -> bool:
        """Return whether somebody may watch: motion is to be spooled."""
        return self.spool is not None

    def has_room(self) -> bool:
        """Return whether a short message would be sent at once."""
        return bool(select.select([], [self.connection], [], 0.0)[1])

    def send(self, message: Any) -> None:
        """Send a message of the worker, from any thread; a server that is gone hears nothing."""
        with self._one, suppress(OSError):
            self.connection.send(message)
