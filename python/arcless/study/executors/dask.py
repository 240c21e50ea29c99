"""Dask: worker processes of this machine, or a cluster behind a scheduler that runs already."""

import logging
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING

from arcless.errors import ExecutorError
from arcless.platforms.processors import processors
from arcless.platforms.signals import started_without_ctrl_c
from arcless.study.definition.study import Execution
from arcless.study.evaluation.evaluate import Cancel, Take, Task
from arcless.study.evaluation.messages import Note
from arcless.study.evaluation.variants import Variant
from arcless.study.executors.dask_chunks import Chunks
from arcless.study.folder.table import needs

if TYPE_CHECKING:
    from distributed import Client

# A scheduler that runs answers in milliseconds; a user is told within 10 s that none does.
_CONNECT_TIMEOUT_S = 5.0


class Dask:
    """Computes in the workers of Dask.

    Parameters
    ----------
    how
        With the address of a scheduler, or with a number of worker processes to start here.
    note
        Told what a user should know.

    Raises
    ------
    StudyError
        Dask is not installed.
    ExecutorError
        The scheduler does not answer.
    """

    def __init__(self, how: Execution, note: Note) -> None:
        needs("distributed", "the executor dask")
        self._how, self._note = how, note
        self._client: Client | None = None
        self._open = ExitStack()
        _silence_logging()
        if how.scheduler is not None:
            self._connect(how.scheduler).close()

    def compute(
        self, task: Task, variants: Iterator[Variant], count: int, take: Take, cancel: Cancel
    ) -> None:
        """Compute variants; see `Executor`."""
        if self._client is None:
            # Once for all rounds of an optimisation: worker processes take seconds to start.
            where = self._how.scheduler
            found = _local(self._how.workers) if where is None else self._connect(where)
            self._client = self._open.enter_context(found)
        Chunks(self._client, task, variants, count, self._note).compute(take, cancel)

    def close(self) -> None:
        """Stop what was started; see `Executor`."""
        self._open.close()

    @staticmethod
    def _connect(address: str) -> "Client":
        from distributed import Client

        try:
            return Client(address, timeout=_CONNECT_TIMEOUT_S, set_as_default=False)
        except (OSError, TimeoutError, ValueError) as error:
            raise ExecutorError(
                "no Dask scheduler answers",
                where=address,
                got=str(error).partition("\n")[0][:200] or type(error).__name__,
                expected=f"an answer within {_CONNECT_TIMEOUT_S:g} s",
                hint="start one with `dask scheduler`, and workers with `dask worker ADDRESS`",
            ) from None


def _silence_logging() -> None:
    """Keep Dask from saying in pages what is said here in a sentence."""
    import distributed  # sets levels of its own when it is imported

    for name in (distributed.__name__, "distributed.client"):
        logging.getLogger(name).setLevel(logging.CRITICAL)


@contextmanager
def _local(workers: int | None) -> "Iterator[Client]":
    """Start worker processes on this machine, and stop them in the end."""
    from distributed import Client, LocalCluster

    count = workers or processors()
    with ExitStack() as stack:
        with started_without_ctrl_c():
            cluster = LocalCluster(
                n_workers=count,
                threads_per_worker=1,
                processes=True,
                dashboard_address="127.0.0.1:0",  # a fixed port may be taken, and is warned of
                silence_logs=logging.CRITICAL,
            )
        stack.enter_context(cluster)
        client = stack.enter_context(Client(cluster, set_as_default=False))
        yield client
