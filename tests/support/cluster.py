"""A Dask scheduler and its workers as processes of their own, to be killed."""

import json
import subprocess
import sys
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Self

_STARTS_WITHIN_S = 60.0


class Cluster:
    """A scheduler with worker processes on this machine; leaving kills all of it.

    Workers run without a nanny: one that is killed stays dead.
    """

    def __init__(self, folder: Path, workers: int = 2) -> None:
        self._file = folder / "scheduler.json"
        self._wanted = workers
        self.workers: list[subprocess.Popen[bytes]] = []
        self.scheduler: subprocess.Popen[bytes] | None = None

    def __enter__(self) -> Self:
        """Start all."""
        self.repair()
        return self

    def repair(self) -> None:
        """Start whatever was killed, and wait until all is there."""
        if self.scheduler is None or self.scheduler.poll() is not None:
            self._end()
            self._start_scheduler()
        self.workers = [worker for worker in self.workers if worker.poll() is None]
        while len(self.workers) < self._wanted:
            self.add_worker()
        self._wait_for_workers()

    def _start_scheduler(self) -> None:
        self._file.unlink(missing_ok=True)
        self.scheduler = _start("dask_scheduler", "--port", "0", "--scheduler-file", self._file)
        deadline = time.monotonic() + _STARTS_WITHIN_S
        while not self._file.exists() and time.monotonic() < deadline:
            time.sleep(0.02)
        time.sleep(0.05)  # for the file to be whole
        self.address: str = json.loads(self._file.read_text())["address"]

    def kill_scheduler(self) -> None:
        """Kill the scheduler."""
        assert self.scheduler is not None
        self.scheduler.kill()

    def add_worker(self) -> None:
        """Start another worker."""
        self.workers.append(
            _start("dask_worker", self.address, "--nthreads", "1", "--no-nanny",
                   "--local-directory", self._file.parent)
        )  # fmt: skip

    def _wait_for_workers(self) -> None:
        from distributed import Client

        with Client(self.address, set_as_default=False) as client:
            client.wait_for_workers(len(self.workers), timeout=_STARTS_WITHIN_S)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Kill what is left."""
        self._end()

    def _end(self) -> None:
        for process in (*self.workers, *([self.scheduler] if self.scheduler else [])):
            process.kill()
            process.wait()
        self.workers = []


def _start(program: str, *words: Any) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-m", f"distributed.cli.{program}", *map(str, words), "--no-dashboard"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
