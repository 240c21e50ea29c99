"""Workers of a batch: threads that run members; the core releases Python's lock."""

import queue
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from arcless.assess import Assessment
from arcless.model import Scenario
from arcless.results import Result
from arcless.simulate.batches.fingerprints import shared_key
from arcless.simulate.batches.groups import Group, Groups, Member
from arcless.simulate.batches.monitored_runs import MonitoredRuns, RunStoppedError, Watching
from arcless.simulate.batches.store import Folder
from arcless.simulate.certainty import places, run_additional, sequential_runner
from arcless.simulate.runs.job import Job, lay_out
from arcless.simulate.runs.mean_force import make_runs
from arcless.simulate.runs.member import records_all, running
from arcless.simulate.runs.outcome import Keep, Outcome, told
from arcless.simulate.setup.controllers import Controllers

# Workers that are told to stop do so after some steps; nobody waits for a line in the making.
LEAVES_WITHIN_S = 0.3
# Given index and scenario of a member, returns who looks at its runs.
Watch = Callable[[int, Scenario], Watching | None]


class WorkerPool:
    """Worker threads that run the members waiting in groups."""

    def __init__(
        self,
        groups: Groups,
        keep: Keep,
        folder: Folder | None,
        workers: int,
        *,
        watch: Watch | None = None,
        given: Mapping[str, Any] | None = None,
        allow_fmu: bool = False,
    ) -> None:
        self._given, self._allow_fmu = given, allow_fmu
        self._groups, self._keep, self._folder, self._watch = groups, keep, folder, watch
        self._done: queue.SimpleQueue[Outcome | BaseException] = queue.SimpleQueue()
        self._stop = threading.Event()
        # A process that ends waits for no daemon: one may be in the midst of a long factorisation.
        self._threads = [threading.Thread(target=self._work, daemon=True) for _ in range(workers)]

    def __enter__(self) -> "WorkerPool":
        """Start the threads."""
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        """Stop the threads, in the midst of a member where there are any left."""
        self._stop.set()
        self._groups.empty()
        deadline = time.monotonic() + LEAVES_WITHIN_S
        for thread in self._threads:
            thread.join(max(0.0, deadline - time.monotonic()))

    def outcomes(self, timeout_s: float) -> Iterator[Outcome]:
        """Return the outcomes so far, waiting for the first no longer than a time in s.

        Raises
        ------
        OutputError
            What is kept of a member cannot be written.
        """
        try:
            found = self._done.get(timeout=timeout_s)
            while True:
                if isinstance(found, BaseException):
                    raise found
                yield found
                found = self._done.get_nowait()
        except queue.Empty:
            return

    def _work(self) -> None:
        try:
            while group := self._groups.choose():
                try:
                    while member := self._groups.next_of(group):
                        self._done.put(self._outcome(group, member))
                finally:
                    self._groups.leave(group)
        except BaseException as error:  # raised again where the batch was called
            if not self._stop.is_set():
                self._done.put(error)

    def _outcome(self, group: Group, member: Member) -> Outcome:
        """Return the outcome of a member; an error is one too."""
        started = time.perf_counter()
        index, name = member.index, member.scenario.name
        course: MonitoredRuns | None = None
        try:
            job = self._job(group, member)
            watching = None if self._watch is None else self._watch(index, member.scenario)
            course = MonitoredRuns(job, watching)
            done = self._done_of(job, course, started, group)
        except RunStoppedError as stopped:
            outcome = Outcome(index, name, stopped=stopped.at)
        except Exception as error:
            outcome = Outcome(index, name, error=told(error))
        else:
            outcome = self._kept(member, done, time.perf_counter() - started)
        wall_time_s = outcome.wall_time_s or time.perf_counter() - started
        outcome = replace(outcome, changes=member.scenario.changes)
        if course is None or not course.steps:
            return replace(outcome, wall_time_s=wall_time_s)
        steps, of_run = course.steps, course.of_run
        return replace(outcome, wall_time_s=wall_time_s, steps=steps, steps_of_run=of_run)

    def _done_of(
        self, job: Job, course: MonitoredRuns, started: float, group: Group
    ) -> Assessment | Result:
        """Run a member to its end, and its additional runs for certainty."""
        additional = None if job.scenario.certainty is None else self._beside(job, group)
        run, full = running(job, self._keep, started, additional), records_all(job, self._keep)
        return make_runs(run, lambda trial: course.run(trial, full=full))

    def _beside(self, job: Job, group: Group) -> Callable[[list[float]], dict[str, Any]]:
        places(job.scenario)  # without room for other starts there is no need to run it
        runs = sequential_runner(
            job, self._stop.is_set, lambda scenario: group.beside(shared_key(scenario), scenario)
        )
        return lambda forces: run_additional(job, forces, runs)

    def _job(self, group: Group, member: Member) -> Job:
        line = group.line(member.scenario)
        controllers = Controllers(member.scenario, self._given)
        return lay_out(
            member.scenario,
            controllers,
            _quiet,
            self._stop.is_set,
            line,
            allow_fmu=self._allow_fmu,
        )

    def _kept(self, member: Member, done: Assessment | Result, wall_time_s: float) -> Outcome:
        index, name = member.index, member.scenario.name
        result = done if isinstance(done, Result) else None
        assessment = done.assessment if isinstance(done, Result) else done
        if self._folder is None:
            return Outcome(index, name, assessment, result, wall_time_s=wall_time_s)
        path = self._folder.write(member.key, done, wall_time_s)
        return Outcome(index, name, assessment, path=path, wall_time_s=wall_time_s)


def _quiet(_fraction: float, _text: str) -> None:
    pass
