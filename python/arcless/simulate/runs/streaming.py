"""Stream of a long run's record to disk during the run."""

from contextlib import ExitStack
from types import TracebackType
from typing import TYPE_CHECKING, Any, BinaryIO, Self

from arcless.dataset.netcdf.stream_writer import Writer
from arcless.simulate.recording import record
from arcless.simulate.setup import trajectory

if TYPE_CHECKING:
    import xarray

    from arcless.model import Scenario
    from arcless.simulate.runs.job import Job

# A record of this many steps takes some 30 MB, and writing it at the end some seconds.
LONG = 100_000


def is_long(scenario: "Scenario") -> bool:
    """Return whether the record of a scenario should go to disk while it runs."""
    return trajectory.motion(scenario).steps >= LONG


class Stream:
    """Takes the series of a run as the core hands them out, and writes them to a file."""

    def __init__(self, file: BinaryIO, job: "Job", steps: range) -> None:
        self._file, self._job = file, job
        self._rows = record.rows(steps, job.scenario, job.kept_motion)
        self._before: dict[str, Any] = {}
        self._writer: Writer | None = None
        self._stack = ExitStack()

    def __enter__(self) -> Self:
        """Begin; there is nothing to do before the first piece."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Let go of the file."""
        self._stack.close()

    def put_before(self, earlier: "xarray.Dataset") -> None:
        """Put the rows of an earlier part of the run before all others."""
        self._rows = {dim: n + earlier.sizes.get(dim, 0) for dim, n in self._rows.items()}
        self._before = {
            str(name): earlier[name].values
            for name in earlier.variables
            if earlier[name].dims[0] in record.SERIES
        }

    def take(self, raw: dict[str, Any]) -> None:
        """Write the next piece of the series."""
        job = self._job
        names = record.names(raw, job.found, job.scenario, job.kept_motion)
        labels = {dim: names.pop(dim) for dim in record.SERIES}
        if self._writer is None:
            self._writer = self._stack.enter_context(Writer(self._file, self._rows, names))
            if self._before:
                earlier = {dim: self._before.pop(dim, []) for dim in record.SERIES}
                self._writer.append(self._before, earlier)
                self._before = {}
        if any(len(times) for times in labels.values()):
            controlled = job.controllers.any
            piece = record.series(
                raw, job.found, job.scenario, controlled=controlled, motion=job.kept_motion
            )
            self._writer.append(piece, labels)

    def finish(self, static: dict[str, Any], attributes: dict[str, Any]) -> None:
        """Write the variables that are no series; see `Writer.finish`."""
        if self._writer is not None:
            self._writer.finish(static, attributes)
