"""A server on this machine's own address, from its start to Ctrl-C."""

import socket
from collections.abc import Callable
from pathlib import Path

from arcless.errors import OutputError
from arcless.studio.project.project import Project
from arcless.studio.server import page
from arcless.studio.server.app import application
from arcless.studio.server.keys import Keys

HOST = "127.0.0.1"
# Time in s that answers which are being sent have when the server ends, and the user waits.
_GRACE_S = 0
# Bytes of one message of a WebSocket: questions and settings, no files.
_LONGEST_MESSAGE = 64 * 1024


def serve(folder: Path, port: int, ready: Callable[[str, str], None]) -> None:
    """Serve a folder until Ctrl-C.

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
    with _listening(port) as listener:
        keys = Keys(listener.getsockname()[1])
        base = f"http://{HOST}:{keys.port}/?token="

        class Server(uvicorn.Server):
            async def startup(self, sockets: list[socket.socket] | None = None) -> None:
                await super().startup(sockets)
                ready(base + keys.token, base + keys.ticket())

        settings = uvicorn.Config(
            application(project, keys),
            lifespan="on",
            http="h11",
            ws="websockets-sansio",
            ws_max_size=_LONGEST_MESSAGE,
            ws_per_message_deflate=False,
            log_config=None,
            access_log=False,
            server_header=False,
            proxy_headers=False,
            timeout_graceful_shutdown=_GRACE_S,
        )
        Server(settings).run([listener])


def _listening(port: int) -> socket.socket:
    # By its protocol asyncio knows that it is TCP, and sends without delay: otherwise every answer
    # in two pieces waits 40 ms for the browser to confirm the first one.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
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
