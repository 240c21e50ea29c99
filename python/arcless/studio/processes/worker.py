"""A worker process, as the server sees it: the one way in which the studio starts processes.

It is a new interpreter: a fork of a server with threads may hang, and `multiprocessing` would
import the main program once more, and start one more process that watches over the others.
"""

import socket
import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from typing import Any, BinaryIO

from arcless.errors import ArclessError
from arcless.platforms.children import connection_of, environment, start
from arcless.platforms.ends import why_ended
from arcless.platforms.shared_files import send_file
from arcless.studio.processes.ends import Cancelled, Failed, Gone
from arcless.studio.processes.worker_process import LAST_S

Heard = Callable[[Any], object]
_Task = tuple[Future[Any], Heard | None]
_MODULE = "arcless.studio.processes.worker_process"


class Worker:
    """A process that does one task after the other.

    Parameters
    ----------
    last_s
        Time in s that its task has to end by itself when the server is gone.

    Attributes
    ----------
    process
        The process.
    used
        Memory in bytes that it has used at most, as it said after its last task; 0 where nothing
        tells it.
    """

    def __init__(self, last_s: float = LAST_S) -> None:
        self.process, self._line = start(_MODULE, [str(last_s)], environment())
        self.used = 0
        self._connection = connection_of(self._line)
        self._sending = threading.Lock()
        self._tasks: deque[_Task] = deque()
        self._cancelled: list[Future[Any]] = []
        self._leaving = self._gone = False
        threading.Thread(target=self._listen, daemon=True).start()

    @property
    def runs(self) -> bool:
        """True while the process is there and has not been asked to leave."""
        return not self._leaving and self.process.poll() is None

    def do(
        self, function: Callable[..., Any], *arguments: Any,
        heard: Heard | None = None, spool: BinaryIO | None = None,
    ) -> Future[Any]:  # fmt: skip
        """Have a task done, after those that were given before.

        Parameters
        ----------
        function, arguments
            A function of a module, called with a `Talk` and the arguments, which pickle. It asks
            `Talk.cancel` now and then and raises KeyboardInterrupt when that is true.
        heard
            Called with what the function says, in order, by a thread of this worker: while it does
            not return, the function waits as soon as its words fill the line.
        spool
            A file of `shared_files` that the function writes to.

        Returns
        -------
        Future
            What the function returns, by the same thread after its last word; or an ArclessError,
            `Failed`, `Gone`, `Cancelled`. Nobody but the worker ends it.
        """
        end: Future[Any] = Future()
        end.set_running_or_notify_cancel()
        with self._sending:
            if self._gone:
                end.set_exception(self._why())
                return end
            self._tasks.append((end, heard))
            try:
                self._connection.send(("do", (function, arguments), spool is not None))
                if spool is not None:
                    send_file(self._connection, spool, self.process.pid)
            except OSError:
                pass  # it is gone, which `_listen` tells
            except Exception:  # what does not pickle
                self._tasks.pop()
                raise
        return end

    def tell(self, order: Any) -> None:
        """Send what the task takes by `Talk.order`; waits while the line is full."""
        self._send(("order", order))

    def cancel(self, within_s: float) -> None:
        """Ask the last task to end, and end the process where it does not within a time in s."""
        self._send(("cancel",))
        self._cancelled = asked = [end for end, _ in list(self._tasks)]
        _later(within_s, lambda: self._end_unless_done(asked))

    def _end_unless_done(self, ends: list[Future[Any]]) -> None:
        if not all(end.done() for end in ends):
            self.process.kill()

    def leave(self, within_s: float = LAST_S) -> None:
        """Have it cancel its task and end, by force after a time in s; does not wait for it."""
        if self._leaving:
            return
        self._leaving = True
        with suppress(OSError):
            # The listening thread wakes up and closes; closing under it would not wake it.
            self._line.shutdown(socket.SHUT_RDWR)
        _later(within_s, self.process.kill)

    def _send(self, message: tuple[Any, ...]) -> None:
        with self._sending, suppress(OSError):
            self._connection.send(message)

    def _listen(self) -> None:
        try:
            while True:
                self._take(self._connection.recv())
        except Exception:  # nobody there any more, nothing that can be read, nobody who hears
            if not self._leaving:
                self.process.kill()
        self.process.wait()
        with self._sending:
            self._gone = True
            self._connection.close()
            self._line.close()
        for end, _ in self._tasks:
            is_cancelled = self._leaving or end in self._cancelled
            end.set_exception(Cancelled() if is_cancelled else self._why())

    def _take(self, message: tuple[Any, ...]) -> None:
        end, heard = self._tasks[0]
        match message:
            case ("said", said) if heard is not None:
                heard(said)
            case ("end", how, value, used):
                self._tasks.popleft()
                self.used = used or 0
                if how == "done":
                    end.set_result(value)
                else:
                    end.set_exception(_error(how, value))

    def _why(self) -> Gone:
        """Return why the process ended."""
        what, hint = why_ended(self.process.returncode)
        return Gone(f"the process that computed this is gone: {what}", hint)


def _error(how: str, value: Any) -> Exception:
    if how == "cancelled":
        return Cancelled()
    return value if isinstance(value, ArclessError) else Failed(*value)


def _later(wait_s: float, act: Callable[[], Any]) -> None:
    timer = threading.Timer(wait_s, act)
    timer.daemon = True
    timer.start()
