"""Outcome of a member of a batch."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from arcless.assess import Assessment
from arcless.errors import ArclessError
from arcless.results import Result
from arcless.units import plain

Keep = Literal["assessment", "result"]


@dataclass(frozen=True, slots=True)
class Stopped:
    """Stop of a run by its observer: place in m, time since its start in s, and the reason.

    The place is that of the first pantograph.
    """

    position_m: float
    time_s: float
    why: str


@dataclass(frozen=True, slots=True)
class Outcome:
    """Outcome of a member of a batch.

    Attributes
    ----------
    index
        Its place in the batch, from 0.
    name
        Name of its scenario.
    assessment
        Its assessment; None where it failed.
    result
        Its result, where results are kept in memory.
    path
        File of its result or assessment, where a folder was given.
    error
        Why it failed: the error that `arcless.run` would have raised; None where it did not.
    wall_time_s
        Time from its start to its end in s. Members run side by side, so these do not add up.
    was_there
        Whether an earlier, interrupted batch had done it.
    stopped
        Where it was stopped, and why; None where it was not.
    steps, steps_of_run
        Where it was looked at: the steps of all runs of a search for a static force (of a coarse
        copy as many as cost the same), and those of one run to its end.
    changes
        Fields that were set for it, by dotted path, values as typed: see `Scenario.changes`. They
        tell members with one name apart.
    """

    index: int
    name: str
    assessment: Assessment | None = None
    result: Result | None = None
    path: Path | None = None
    error: ArclessError | None = None
    wall_time_s: float = 0.0
    was_there: bool = False
    stopped: Stopped | None = None
    steps: int = 0
    steps_of_run: int = 0
    changes: dict[str, str] = field(default_factory=dict)

    def __repr__(self) -> str:
        told = self.error or self.stopped or self.assessment
        about = "done" if told is None else f"{told!r:.80}"
        return f"<Outcome {self.index} {plain(self.name)}: {about}>"


def told(error: Exception) -> ArclessError:
    """Return the error of a member; an unforeseen one must not lose the others either."""
    if isinstance(error, ArclessError):
        return error
    told = ArclessError(
        "the run failed in an unforeseen way",
        got=f"{type(error).__name__}: {error}",
        hint="run it alone with `arcless.run`, and report what it says",
    )
    told.__cause__ = error
    return told
