"""Additional runs of a run, in parallel on all processors."""

from collections.abc import Sequence

from arcless.model import Scenario
from arcless.simulate.batches.groups import Groups, Member
from arcless.simulate.batches.workers import WorkerPool
from arcless.simulate.certainty import Runs
from arcless.simulate.runs.job import Cancel, Job, Line, Progress
from arcless.simulate.runs.outcome import Outcome

# Interval in s between two questions whether to continue.
LOOK_EVERY_S = 0.1
OWN, OTHER = "own", "other"


def parallel_runner(job: Job, tell: Progress, cancel: Cancel | None, workers: int) -> Runs:
    """Return a function that runs scenarios in parallel, on the line of a run if shared."""

    def runs(scenarios: Sequence[Scenario]) -> list[Outcome]:
        own = job.scenario.solver
        groups = Groups(lambda scenario: OWN if scenario.solver is own else OTHER)
        for index, scenario in enumerate(scenarios):
            line = Line(job.found, job.model) if scenario.solver is own else None
            groups.put(Member(index, scenario, ""), line)
        groups.close()
        found: dict[int, Outcome] = {}
        with WorkerPool(
            groups, "assessment", None, workers,
            given=job.controllers.given, allow_fmu=job.allow_fmu,
        ) as crew:  # fmt: skip
            while len(found) < len(scenarios):
                for outcome in crew.outcomes(LOOK_EVERY_S):
                    found[outcome.index] = outcome
                    tell(len(found) / len(scenarios), f"{len(found)} of {len(scenarios)} repeats")
                if cancel is not None and cancel():
                    raise KeyboardInterrupt
        return [found[index] for index in range(len(scenarios))]

    return runs
