"""Chunks of a study on their way through a Dask cluster, and the retries of lost ones."""

import time
from collections.abc import Iterator
from concurrent.futures import CancelledError
from itertools import islice
from typing import TYPE_CHECKING

from arcless.errors import ExecutorError, OutputError
from arcless.study.evaluation.evaluate import Cancel, Take, Task, evaluate, failed
from arcless.study.evaluation.messages import Note
from arcless.study.evaluation.variants import Variant
from arcless.study.journal.row import Row

if TYPE_CHECKING:
    from distributed import Client, Future

# A chunk goes to one worker: large enough to share a line, small enough to be lost. Every worker
# gets this many at least, so that none is idle while another has the last chunk.
LARGEST_CHUNK, CHUNKS_EACH = 8, 4
# Chunks that wait at each worker, so that it does not while rows travel.
AHEAD = 2
_POLL_INTERVAL_S = 0.02
# Some kilobytes take no longer, or they do not come: their chunk is sent again.
_TRANSFER_TIMEOUT_S = 5.0
_COUNT_INTERVAL_S = 1.0
# Without a worker for so long, a user is told that the study waits.
_NO_WORKER_NOTE_AFTER_S = 5.0


def compute_chunk(task: Task, variants: list[Variant]) -> list[Row]:
    """Compute a chunk in a worker, in one thread: every worker of a cluster has its own core."""
    rows: list[Row] = []
    evaluate(task, variants, rows.append, workers=1)
    return rows


class Chunks:
    """Sends chunks to workers and takes their rows.

    Parameters
    ----------
    client
        Connected to a scheduler.
    task, variants, count
        What to compute, and how many variants that is.
    note
        Told what a user should know.
    """

    def __init__(
        self, client: "Client", task: Task, variants: Iterator[Variant], count: int, note: Note
    ) -> None:
        from distributed import as_completed

        self._client, self._task, self._variants, self._note = client, task, variants, note
        self._retry: list[list[Variant]] = []
        self._sent: dict[Future, list[Variant]] = {}
        self._completed = as_completed(loop=client.loop, with_results=False)
        self._workers, self._counted = 0, -_COUNT_INTERVAL_S
        self._last_worker_at = time.monotonic()
        each = count // (CHUNKS_EACH * max(self._count_workers(), 1))
        self._size = max(1, min(LARGEST_CHUNK, each))

    def compute(self, take: Take, cancel: Cancel) -> None:
        """Send chunks while there are any, and take the rows of those that end.

        Raises
        ------
        KeyboardInterrupt
            `cancel` returned True.
        ExecutorError
            The scheduler went away, or workers cannot compute.
        OutputError
            A worker cannot keep a result.
        """
        try:
            while self._send() or self._sent:
                if cancel():
                    raise KeyboardInterrupt
                self._count_workers()
                while self._completed.has_ready():
                    for row in self._rows(next(self._completed)):
                        take(row)
                time.sleep(_POLL_INTERVAL_S)
        finally:
            if self._client.status == "running":
                self._client.cancel(list(self._sent))

    def _send(self) -> bool:
        """Send chunks until enough wait; return whether there may be more."""
        while len(self._sent) < AHEAD * max(self._count_workers(), 1):
            chunk = self._retry.pop() if self._retry else list(islice(self._variants, self._size))
            if not chunk:
                return False
            future = self._client.submit(compute_chunk, self._task, chunk, pure=False)
            self._sent[future] = chunk
            self._completed.add(future)
        return True

    def _rows(self, future: "Future") -> list[Row]:
        """Return the rows of a chunk that ended; none where it has to be sent again."""
        from distributed import KilledWorker

        chunk, error = self._sent.pop(future), None
        try:
            if future.status == "finished":
                rows: list[Row] = future.result(timeout=_TRANSFER_TIMEOUT_S)
                return rows
            if future.status == "error":
                error = future.exception(timeout=_TRANSFER_TIMEOUT_S)
        except (OSError, TimeoutError, CancelledError):
            error = None  # the worker died with the rows before they were here
        if isinstance(error, KilledWorker):
            if len(chunk) == 1:
                return [failed(chunk[0], "every worker that computed it died")]
            self._retry += [[variant] for variant in chunk]  # one of them may be the reason
            return []
        if isinstance(error, OutputError):
            raise error
        if error is not None:
            raise ExecutorError(
                "a worker cannot compute",
                got=f"{type(error).__name__}: {error}"[:300],
                expected="workers with the same version of Arcless as here",
            )
        if self._client.status != "running":
            raise _gone()
        self._retry.append(chunk)
        return []

    def _count_workers(self) -> int:
        """Return how many chunks can be computed at once; ask for it now and then."""
        now = time.monotonic()
        if now - self._counted < _COUNT_INTERVAL_S:
            return self._workers
        try:
            self._workers = sum(self._client.nthreads().values())
        except (OSError, TimeoutError, ValueError, RuntimeError):
            raise _gone() from None
        self._counted = time.monotonic()
        if self._workers:
            self._last_worker_at = now
        elif now - self._last_worker_at > _NO_WORKER_NOTE_AFTER_S:
            self._note("no worker is connected to the scheduler; the study waits for one")
            self._last_worker_at = float("inf")
        return self._workers


def _gone() -> ExecutorError:
    return ExecutorError(
        "the Dask scheduler went away",
        expected="a scheduler that runs until the study is done",
        hint="start it again, then `arcless study resume`: no row that came is lost",
    )
