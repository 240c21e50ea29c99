"""`arcless.run` and `arcless.resume`: a whole run, or a part of one to continue later."""

import time
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from arcless.model import Scenario
from arcless.model.load import check_kind
from arcless.platforms.processors import processors
from arcless.results import Result
from arcless.simulate.fmu.admission import check_saved
from arcless.simulate.runs import checkpoint
from arcless.simulate.runs.job import SEARCHING, Cancel, Job, Progress, lay_out, observer
from arcless.simulate.runs.mean_force import find_forces
from arcless.simulate.runs.run_result import Part
from arcless.simulate.runs.viewer import Viewer, Watch
from arcless.simulate.setup.controllers import ControlFunction, Controllers


def run(
    scenario: Scenario,
    *,
    until: str | float | None = None,
    to: str | Path | None = None,
    command: str | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    controllers: Mapping[str, ControlFunction | type] | None = None,
    certainty: int | None = None,
    watch: Watch | None = None,
    allow_fmu: bool = False,
) -> Result:
    """Run a scenario: statics, dynamics, record.

    Parameters
    ----------
    scenario
        Scenario to run; see `arcless.load`.
    until
        Stop early, at a place of the first pantograph ("600 m", or a number in m) or a time
        ("5 s"): the result then holds the state there, and `resume` continues from it.
    to
        A file to write the result to while the run steps, for long runs: no more than a piece of
        the record is in memory until the result is read from the file at the end. The file is
        there whole or not at all.
    command
        The command that runs this again, for the record.
    progress
        Called now and then with the fraction done and what is being done.
    cancel
        Asked now and then; the run ends with KeyboardInterrupt when it returns True.
    controllers
        By the name of a pantograph, the controller of its force: a function of a
        `ControlInput` that returns N, or a class of such, of which each run gets an instance. In
        place of `pid` and `function` of the scenario's controller; without one it is asked at
        every step. A search for the static force runs several times, each with a copy.
    certainty
        How many starts within a span say how sure the assessed numbers are, the run's own among
        them: `certainty` of the scenario. A run that stops early says it when it has been
        resumed to its end.
    watch
        Called while the run steps with a `MotionPiece`: the motion of the line near the
        pantographs, as `output.motion` records it; the result holds it only where that is set. It
        is called in the thread that steps, and what it raises ends the run.
    allow_fmu
        Whether pantographs that are FMUs may run: their code has all rights that you have.
        Without it the environment variable ARCLESS_ALLOW_FMU=1 allows them.

    Raises
    ------
    ModelError
        There is no room for other starts.
    FmuError
        A pantograph is an FMU that may not run, cannot be loaded, fails, crashes or hangs.
    MeshError, EquilibriumError, ContactError, ControlError
        The line cannot be divided, has no equilibrium, a step cannot be solved, a controller
        failed, or it is a function whose memory cannot be saved and the run is to stop early.
    OutputError
        The file cannot be written.
    """
    check_kind(scenario)
    if certainty is not None:
        scenario = with_certainty(scenario, certainty)
    decided = Controllers(scenario, controllers)
    if until is not None:
        decided.check_saved()
        check_saved(scenario)
    _check_starts(scenario)
    tell = progress or (lambda _fraction, _text: None)
    started = time.perf_counter()
    job = lay_out(scenario, decided, tell, cancel, allow_fmu=allow_fmu)
    if watch is not None:
        asked = any(placement.mean_force is not None for placement in scenario.pantographs)
        job = replace(job, viewer=Viewer(watch, searching=asked))
    last = checkpoint.stop_step(job.travel, until)
    searching = observer(job.travel.steps, SEARCHING, tell, cancel)
    # The last run of a search is the run that is asked for, unless that stops early or is streamed.
    full = last == job.travel.steps and to is None
    search = find_forces(replace(job, observe=searching), full=full)
    if job.viewer is not None:
        job.viewer.searching = False
    sure = partial(_sure, job, search.forces, tell, cancel)
    part = Part(job, search.forces, started, command or f"arcless run {scenario.name}", sure)
    if to is None:
        return part.in_memory((search.record if full else None) or part.step(None, last), tell)
    return part.to_file(Path(to), None, last, tell)


def resume(
    result: Result,
    *,
    until: str | float | None = None,
    to: str | Path | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Result:
    """Continue a run that stopped early; the result is that of the whole run, bit for bit.

    Parameters
    ----------
    result
        Of `run` or `resume` with `until`, or `arcless.open` of its file.
    until
        Stop early again, see `run`.
    to, progress, cancel
        See `run`.

    Raises
    ------
    ResultFormatError
        The result is complete, its state is damaged or of another version, or the scenario or the
        line at rest is another one than when the run began.
    ContactError, ControlError
        A step cannot be solved, or a controller failed.
    """
    saved = checkpoint.read(result)
    _check_starts(result.scenario)
    tell = progress or (lambda _fraction, _text: None)
    started = time.perf_counter()
    decided = Controllers(result.scenario)
    job = lay_out(result.scenario, decided, tell, cancel)
    checkpoint.check_identity(result, checkpoint.identity(job.scenario, job.found, job.travel))
    last = checkpoint.stop_step(job.travel, until, after=saved.step)
    forces = checkpoint.take_forces(saved, len(job.scenario.pantographs))
    sure = partial(_sure, job, forces, tell, cancel)
    part = Part(job, forces, started, result.metadata["command"], sure, result)
    if to is None:
        return part.in_memory(part.step(saved, last), tell)
    return part.to_file(Path(to), saved, last, tell)


def with_certainty(scenario: Scenario, starts: Any) -> Scenario:
    """Return a scenario that asks how sure its numbers are, by so many starts.

    Raises
    ------
    ModelError
        That is no number of starts.
    """
    kept = {} if scenario.certainty is None else scenario.certainty.model_dump()
    return scenario.with_(certainty={**kept, "starts": starts})


def _check_starts(scenario: Scenario) -> None:
    """Refuse what would fail only after the run."""
    if scenario.certainty is not None:
        from arcless.simulate.certainty import places

        places(scenario)


def _sure(job: Job, forces: list[float], tell: Progress, cancel: Cancel | None) -> dict[str, Any]:
    """Run what says how sure the numbers of a run are, on all processors."""
    from arcless.simulate.batches.parallel_runs import parallel_runner
    from arcless.simulate.certainty import run_additional

    workers = processors()
    return run_additional(job, forces, parallel_runner(job, tell, cancel, workers))
