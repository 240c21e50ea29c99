"""A server with one worker process, for tests that end the server: `… studio_worker TASK`."""

import os
import sys
import time
from contextlib import suppress

from arcless.studio.processes.worker import Worker
from tests.support import studio_tasks as tasks


def main() -> None:
    """Write the number of the process once its task has begun, and wait."""
    worker = Worker()

    def heard(_: object) -> None:
        os.write(sys.stdout.fileno(), f"{worker.process.pid}\n".encode())

    with suppress(KeyboardInterrupt):
        worker.do(getattr(tasks, sys.argv[1]), heard=heard)
        time.sleep(tasks.LONG_S)


if __name__ == "__main__":
    main()
