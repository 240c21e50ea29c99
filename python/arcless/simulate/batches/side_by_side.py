"""Runs beside a run, side by side on all processors."""

from collections.abc import Sequence

from arcless.model import Scenario
from arcless.simulate.batches.groups import Groups, Member
from arcless.simulate.batches.workers import Crew
from arcless.simulate.certainty import Runs
from arcless.simulate.runs.job import Cancel, Job, Line, Progress
from arcless.simulate.runs.outcome import Outcome

# Between two questions whether to go on, in s.
LOOK_EVERY_S = 0.1
OWN, OTHER = "own", "other"


def in_parallel(job: Job, tell: Progress, cancel: Cancel | None, workers: int) -> Runs:
    """Return who runs scenarios side by side, on the line of a run where they share it."""

    def runs(scenarios: Sequence[Scenario]) -> list[Outcome]:
        own = job.scenario.solver
        groups = Groups(lambda scenario: OWN if scenario.solver is own else OTHER)
        for index, scenario in enumerate(scenarios):
            line = Line(job.found, job.prepared) if scenario.solver is own else None
            groups.put(Member(index, scenario, ""), line)
        groups.close()
        found: dict[int, Outcome] = {}
        with Crew(groups, "assessment", None, workers, given=job.controllers.given) as crew:
            while len(found) < len(scenarios):
                for outcome in crew.outcomes(LOOK_EVERY_S):
                    found[outcome.index] = outcome
                    tell(len(found) / len(scenarios), f"{len(found)} of {len(scenarios)} repeats")
                if cancel is not None and cancel():
                    raise KeyboardInterrupt
        return [found[index] for index in range(len(scenarios))]

    return runs
