"""A server with one worker process, for tests that end the server."""

import os
import sys
import time
from contextlib import suppress
from threading import Event

from arcless.studio.processes.worker import Worker
from tests.support import studio_tasks as tasks


def main() -> None:
    """Write the number of the process once its task has begun, or at once, and wait."""
    with suppress(KeyboardInterrupt):
        worker, begun = Worker(), Event()
        if sys.argv[1] != "nothing":
            worker.do(getattr(tasks, sys.argv[1]), heard=lambda _: begun.set())
            begun.wait(tasks.LONG_S)
        os.write(sys.stdout.fileno(), f"{worker.process.pid}\n".encode())
        time.sleep(tasks.LONG_S)


if __name__ == "__main__":
    main()
