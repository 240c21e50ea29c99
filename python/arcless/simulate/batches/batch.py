"""Batch of runs: shared parts are made once, and a failed run stops no other one."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from operator import length_hint
from pathlib import Path

from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.model.load import check_kind
from arcless.platforms.processors import processors
from arcless.simulate.batches.fingerprints import SharedKeys, member_key
from arcless.simulate.batches.groups import Groups, Member
from arcless.simulate.batches.monitored_runs import Look, Watching
from arcless.simulate.batches.store import Folder, Listed
from arcless.simulate.batches.workers import Watch, WorkerPool
from arcless.simulate.runs.job import Cancel, Progress
from arcless.simulate.runs.outcome import Keep, Outcome, Stopped
from arcless.units import show

__all__ = ["Keep", "Look", "Outcome", "Stopped", "Watching", "batch"]

# Members looked at before they are run, to find those that share a line, for each worker.
AHEAD = 64
# Interval in s between two questions whether to continue.
LOOK_EVERY_S = 0.1


def batch(
    scenarios: Iterable[Scenario],
    *,
    keep: Keep = "assessment",
    folder: str | Path | None = None,
    workers: int | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    take: Callable[[Outcome], None] | None = None,
    watch: Watch | None = None,
    allow_fmu: bool = False,
) -> list[Outcome]:
    """Run many scenarios.

    Each gives the result of `arcless.run` for it alone, bit for bit (except times). Members
    with the same line, solver, time step and contact stiffness share statics and factorisation;
    others are grouped by what they share. A member that fails is an outcome with its error.

    Parameters
    ----------
    scenarios
        Members to run. It may be a generator: members are made when needed, and forgotten.
    keep
        "assessment": the assessment of each member, and no records; memory does not grow with the
        length of the runs. "result": the whole result of each, as `arcless.run` returns it.
    folder
        A folder to write the kept data of each member to, a file each. Members with a file from an
        earlier batch are not run again: so an interrupted batch is continued. A member that was
        changed is run, and so is one that failed.
    workers
        Threads; as many as there are processors without it.
    progress
        Called now and then with the fraction done and what is being done.
    cancel
        Asked now and then; the batch ends with KeyboardInterrupt when it returns True.
    take
        Called with each outcome as it comes, in any order, in the thread of the caller. What is
        returned at the end then has neither assessments nor results: however many members there
        are, memory holds few.
    watch
        Given index and scenario of a member, returns the observer of its runs while they step, see
        `Watching`, or None. A member that is stopped is an outcome that says so, with neither
        assessment nor result. A member that is not stopped is, bit for bit, as without it.
    allow_fmu
        Whether pantographs that are FMUs may run, see `arcless.run`.

    Returns
    -------
    list of Outcome
        In the order of the scenarios.

    Raises
    ------
    ModelError
        `workers` is below one, or `keep` is unknown.
    OutputError
        The folder cannot be written. What is in it stays.
    """
    _check(keep, workers)
    stored = None if folder is None else Folder(folder, keep)
    source = _Source(scenarios, stored)
    groups = Groups(SharedKeys().of)
    outcomes: dict[int, Outcome] = {}
    count = workers or processors()
    tell = _ProgressText(progress, length_hint(scenarios, 0))

    def handed(outcome: Outcome) -> None:
        if take is not None:
            take(outcome)
            outcome = replace(outcome, assessment=None, result=None)
        outcomes[outcome.index] = outcome
        tell.done(outcome)

    try:
        with WorkerPool(groups, keep, stored, count, watch=watch, allow_fmu=allow_fmu) as crew:
            while source.goes_on or len(outcomes) < source.begun:
                for outcome in source.refill(groups, source.begun - len(outcomes), AHEAD * count):
                    handed(outcome)
                for outcome in crew.outcomes(LOOK_EVERY_S):
                    handed(outcome)
                if cancel is not None and cancel():
                    raise KeyboardInterrupt
    finally:
        if stored is not None:
            stored.write_list(source.listed)
    return [outcomes[index] for index in sorted(outcomes)]


class _Source:
    """Members as they are needed; those that are done already are outcomes at once."""

    def __init__(self, scenarios: Iterable[Scenario], folder: Folder | None) -> None:
        self._scenarios, self._folder = iter(scenarios), folder
        self.begun, self.goes_on = 0, True
        self.listed: list[Listed] = []

    def refill(self, groups: Groups, waiting: int, enough: int) -> Iterator[Outcome]:
        """Let members wait until there are enough; give those that are done."""
        while self.goes_on and waiting < enough:
            scenario = next(self._scenarios, None)
            if scenario is None:
                self.goes_on = False
                groups.close()
                return
            check_kind(scenario)
            member = self._member(scenario)
            found = self._found(member)
            if found is None:
                groups.put(member)
                waiting += 1
            else:
                yield found

    def _member(self, scenario: Scenario) -> Member:
        key = "" if self._folder is None else member_key(scenario)
        member = Member(self.begun, scenario, key)
        self.begun += 1
        if self._folder is not None:
            changes = "; ".join(f"{path}={text}" for path, text in scenario.changes.items())
            self.listed.append((member.index, scenario.name, key, changes))
        return member

    def _found(self, member: Member) -> Outcome | None:
        found = None if self._folder is None else self._folder.read(member.key)
        if found is None or self._folder is None:
            return None
        assessment, wall = found
        return Outcome(
            member.index,
            member.scenario.name,
            assessment,
            path=self._folder.file(member.key),
            wall_time_s=wall,
            was_there=True,
            changes=member.scenario.changes,
        )


class _ProgressText:
    """Progress of a batch, in words."""

    def __init__(self, progress: Progress | None, members: int) -> None:
        self._progress, self._members = progress, members
        self._done = self._failed = 0

    def done(self, outcome: Outcome) -> None:
        self._done += 1
        self._failed += outcome.error is not None
        if self._progress is None:
            return
        of = f" of {self._members}" if self._members else ""
        failed = f", {self._failed} failed" if self._failed else ""
        fraction = min(1.0, self._done / self._members) if self._members else 0.0
        self._progress(fraction, f"{self._done}{of} runs{failed}")


def _check(keep: str, workers: int | None) -> None:
    if keep not in ("assessment", "result"):
        raise ModelError("keep", got=show(keep), expected="assessment or result")
    if workers is not None and workers < 1:
        raise ModelError("workers", got=str(workers), expected="at least 1")
