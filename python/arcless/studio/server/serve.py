"""A server on this machine's own address, from its start to Ctrl-C."""

import logging
import os
import signal
import socket
import sys
import threading
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from pathlib import Path

from arcless.errors import OutputError
from arcless.platforms.signals import ENDING
from arcless.studio.project.project import Project
from arcless.studio.runs import left_behind
from arcless.studio.server import page
from arcless.studio.server.app import application
from arcless.studio.server.crowd import Crowd, protocol
from arcless.studio.server.keys import Keys

HOST = "127.0.0.1"
# Time in s that answers which are being sent have when the server ends, and the user waits.
_GRACE_S = 0
# Time in s after a signal in which workers are ended; then the process leaves, whatever it does, in
# native code, say. Longer, the user waits; shorter, workers are left to end by themselves.
LEAVE_S = 0.7
# Bytes of one message of a WebSocket: questions and settings, no files.
LONGEST_MESSAGE = 64 * 1024
_ENDS = (signal.SIGINT, *ENDING)
if sys.platform == "win32":
    # A port that was used a minute ago may be taken again without asking, and `SO_REUSEADDR` would
    # let another program take one that is in use, which this option forbids.
    _OF_ADDRESS = socket.SO_EXCLUSIVEADDRUSE
else:
    _OF_ADDRESS = socket.SO_REUSEADDR  # a port that was used a minute ago may be taken again
_AFTER_SIGNAL = 128  # what a shell adds to the number of the signal that ended a program


def serve(folder: Path, port: int, ready: Callable[[str, str], None]) -> None:
    """Serve a folder until Ctrl-C, and leave the process.

    The exit code is 0 after Ctrl-C, which is how it ends; 128 and its number after another signal.

    Parameters
    ----------
    folder
        The folder of the project.
    port
        Port; 0 for any that is free.
    ready
        Told the address to print and the address for a browser that is started, once both answer.

    Raises
    ------
    OutputError
        The page is not built, there is no such folder, or the port is taken.
    """
    import uvicorn

    page.check_built()
    project = Project.of(folder)
    left_behind.sweep(project)
    logging.getLogger("uvicorn").setLevel(logging.CRITICAL)  # of bad questions nobody is told
    with _listening(port) as listener:
        keys, crowd, came = Keys(listener.getsockname()[1]), Crowd(), list[int]()
        base = f"http://{HOST}:{keys.port}/?token="

        class Server(uvicorn.Server):
            async def startup(self, sockets: list[socket.socket] | None = None) -> None:
                await super().startup(sockets)
                ready(base + keys.token, base + keys.ticket())

            @contextmanager
            def capture_signals(self) -> Generator[None, None, None]:
                with _answering(self.leave):
                    yield

            def leave(self, number: int) -> None:
                if not came:
                    came.append(number)
                    _leave_soon(_code(number))
                self.should_exit = True

        settings = uvicorn.Config(
            application(project, keys, crowd),
            lifespan="on",
            http=protocol(crowd),
            ws="websockets-sansio",
            ws_max_size=LONGEST_MESSAGE,
            ws_per_message_deflate=False,
            log_config=None,
            access_log=False,
            server_header=False,
            proxy_headers=False,
            timeout_graceful_shutdown=_GRACE_S,
        )
        Server(settings).run([listener])
    if came:
        _leave(_code(came[0]))


def _code(number: int) -> int:
    return 0 if number == signal.SIGINT else _AFTER_SIGNAL + number


@contextmanager
def _answering(leave: Callable[[int], None]) -> Generator[None, None, None]:
    """Answer the signals that end a program; those that it was started to ignore stay ignored."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {
        number: signal.signal(number, lambda came, _: leave(came))
        for number in _ENDS
        if signal.getsignal(number) is not signal.SIG_IGN
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _leave(code: int) -> None:
    """End the process at once.

    An orderly end would stop threads where they are: one that reads a result then holds the lock of
    HDF5 for ever, which HDF5 takes once more at the very end.
    """
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()
    os._exit(code)


def _leave_soon(code: int) -> None:
    timer = threading.Timer(LEAVE_S, _leave, (code,))
    timer.daemon = True
    timer.start()


def _listening(port: int) -> socket.socket:
    # By its protocol asyncio knows that it is TCP, and sends without delay: otherwise every answer
    # in two pieces waits 40 ms for the browser to confirm the first one.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.setsockopt(socket.SOL_SOCKET, _OF_ADDRESS, 1)
    try:
        listener.bind((HOST, port))
        listener.listen()
    except (OSError, OverflowError) as error:
        listener.close()
        got = getattr(error, "strerror", None) or str(error)
        raise OutputError(
            f"cannot listen on port {port}", got=got, expected="a port that is free",
            hint="without `--port` the studio takes one",
        ) from error  # fmt: skip
    return listener
