"""Additional runs that say how sure the numbers of a run are, and the part a result keeps of them.

They go the way of a batch: the line at rest and its factor are those of the run, nothing is
recorded but what an assessment reads, and the static force is not searched for again.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from arcless.assess.assessment import draw_of
from arcless.errors import ArclessError
from arcless.model import Scenario
from arcless.model.scenario.other_family import other_family, steps_on_chains
from arcless.simulate.certainty import other_starts
from arcless.simulate.runs.job import Cancel, Job, Line, lay_out
from arcless.simulate.runs.member import assessed_alone
from arcless.simulate.runs.outcome import Outcome, told
from arcless.simulate.setup.controllers import Controllers

# Runs scenarios, some on the line of a run, the others on lines of their own.
Runs = Callable[[Sequence[Scenario]], list[Outcome]]
LineOf = Callable[[Scenario], Line]


def run_additional(job: Job, forces: list[float], runs: Runs) -> dict[str, Any]:
    """Run the additional runs of a run, and return the numbers that its result keeps of them.

    Parameters
    ----------
    job
        The run, which was made.
    forces
        Its static forces in N.
    runs
        Who runs the others.
    """
    asked = job.scenario.certainty
    assert asked is not None
    began = time.perf_counter()
    places = other_starts.places(job.scenario)
    scenarios = other_starts.started_at(job, forces, places[1:])
    if asked.other_family:
        # First: it takes longest; threads that are done before continue with the starts.
        scenarios.insert(0, _refined(job, forces))
    outcomes = runs(scenarios)
    refined = outcomes.pop(0) if asked.other_family else None
    if refined is not None and refined.error is not None:
        scenarios[0], refined = _tried_again(job, forces, scenarios[0], refined, runs)
    done = [outcome for outcome in outcomes if outcome.assessment is not None]
    return {
        "starts_m": places,
        "static_force_N": [forces, *(_forces(s) for s in scenarios[-len(outcomes) :])],
        "draws": [_draw(outcome) for outcome in done],
        "refined": None if refined is None or refined.assessment is None else _draw(refined),
        "other_family": _words(scenarios[0]) if asked.other_family else None,
        "wall_time_s": {
            "starts": sum(outcome.wall_time_s for outcome in outcomes),
            "other_family": None if refined is None else refined.wall_time_s,
            "elapsed": time.perf_counter() - began,
        },
        "notes": [*_failures(outcomes), *_failure_of(refined)],
    }


@dataclass(frozen=True)
class _SequentialRuns:
    """Runner of scenarios one after the other in the calling thread, as for a batch member."""

    job: Job
    cancel: Cancel
    line_of: LineOf

    def __call__(self, scenarios: Sequence[Scenario]) -> list[Outcome]:
        return [self._run(index, scenario) for index, scenario in enumerate(scenarios)]

    def _run(self, index: int, scenario: Scenario) -> Outcome:
        began, job = time.perf_counter(), self.job
        assessment, error = None, None
        try:
            is_own = scenario.solver is job.scenario.solver
            line = Line(job.found, job.model) if is_own else self.line_of(scenario)
            controllers = Controllers(scenario, job.controllers.given)
            own = lay_out(scenario, controllers, _quiet, self.cancel, line, allow_fmu=job.allow_fmu)
            assessment = assessed_alone(own, began)
        except Exception as failure:
            error = told(failure)
        wall_s = time.perf_counter() - began
        return Outcome(index, scenario.name, assessment, error=error, wall_time_s=wall_s)


def sequential_runner(job: Job, cancel: Cancel, line_of: LineOf) -> Runs:
    """Return a function that runs the additional scenarios of a batch member in its thread.

    `line_of` makes the line of a scenario that has another one than the member.
    """
    return _SequentialRuns(job, cancel, line_of)


def _refined(job: Job, forces: list[float], *, chains: bool = True) -> Scenario:
    """Return the run by the other family of elements, from the same start with the same forces."""
    return other_family(_same(job, forces), chains=chains)


def _same(job: Job, forces: list[float]) -> Scenario:
    """Return the run with static forces that are known."""
    placements = tuple(
        placement.model_copy(update={"mean_force": None, "static_force": force})
        for placement, force in zip(job.scenario.pantographs, forces, strict=True)
    )
    return job.scenario.model_copy(update={"pantographs": placements, "certainty": None})


def _tried_again(
    job: Job, forces: list[float], tried: Scenario, failed: Outcome, runs: Runs
) -> tuple[Scenario, Outcome]:
    """Refine cubic elements where a line refuses chains."""
    if not steps_on_chains(tried.solver):
        return tried, failed
    cubic = _refined(job, forces, chains=False)
    return cubic, runs([cubic])[0]


def _forces(scenario: Scenario) -> list[float]:
    return [placement.static_force or 0.0 for placement in scenario.pantographs]


def _draw(outcome: Outcome) -> dict[str, Any]:
    assert outcome.assessment is not None
    return draw_of(outcome.assessment).to_dict()


def _words(scenario: Scenario) -> dict[str, Any]:
    """Return the sentences about the other family."""
    solver = scenario.solver
    return {
        "scheme": solver.scheme.name,
        "wire_model": solver.wires,
        "contact_wire_element_m": solver.contact_wire_element_m,
        "messenger_wire_element_m": solver.messenger_wire_element_m,
        "time_step_s": scenario.time_step_s,
    }


def _failures(outcomes: Sequence[Outcome]) -> list[str]:
    failed = [outcome.error for outcome in outcomes if outcome.error is not None]
    if not failed:
        return []
    count = f"{len(failed)} of {len(outcomes)} runs from other starts failed"
    return [f"{count}, and the spread is that of the others: {_reason(failed[0])}"]


def _failure_of(refined: Outcome | None) -> list[str]:
    if refined is None or refined.error is None:
        return []
    why = "the error of discretisation is not known, as the run by the other family failed"
    return [f"{why}: {_reason(refined.error)}"]


def _reason(error: ArclessError) -> str:
    """Return what went wrong without the hint: it may name files of the machine that ran it."""
    error.hint = None
    return str(error)


def _quiet(_fraction: float, _text: str) -> None:
    pass
