"""A whole run, from scenario to result; or a part of one, to go on from later."""

import os
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from arcless import _core
from arcless.dataset.netcdf.store import open_plain
from arcless.dataset.plain_dataset import Plain
from arcless.equilibrium.initial_configuration import wave_speed_of
from arcless.model import Scenario, scenario_warnings
from arcless.model.load import check_kind
from arcless.model.scenario.as_typed import typed_in
from arcless.results import Result
from arcless.simulate.recording import record
from arcless.simulate.runs import checkpoint
from arcless.simulate.runs.job import SEARCHING, Cancel, Job, Progress, Take, lay_out, observer
from arcless.simulate.runs.mean_force import find_forces
from arcless.simulate.runs.streaming import Stream
from arcless.simulate.setup import stops_and_friction
from arcless.simulate.setup.controllers import ControlFunction, Controllers
from arcless.storage.whole_files import replacing


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
) -> Result:
    """Run a scenario: statics, dynamics, record.

    Parameters
    ----------
    scenario
        What to run; see `arcless.load`.
    until
        Stop early, at a place of the first pantograph ("600 m", or a number in m) or a time
        ("5 s"): the result then holds the state there, and `resume` goes on from it.
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
        By the name of a pantograph, who decides on its controlled force: a function of a
        `ControlInput` that returns N, or a class of such, of which each run gets an instance. In
        place of `pid` and `function` of the scenario's controller; without one it is asked at
        every step. A search for the static force runs several times, each with a copy.
    certainty
        How many starts within a span say how sure the assessed numbers are, the run's own among
        them: `certainty` of the scenario. A run that stops early says it when it has gone on to
        its end.

    Raises
    ------
    ModelError
        There is no room for other starts.
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
    _check_starts(scenario)
    tell = progress or (lambda _fraction, _text: None)
    started = time.perf_counter()
    job = lay_out(scenario, decided, tell, cancel)
    last = checkpoint.stop_step(job.travel, until)
    searching = observer(job.travel.steps, SEARCHING, tell, cancel)
    # The last run of a search is the run that is asked for, unless that stops early or is streamed.
    full = last == job.travel.steps and to is None
    search = find_forces(replace(job, observe=searching), full=full)
    sure = partial(_sure, job, search.forces, tell, cancel)
    part = _Part(job, search.forces, started, command or f"arcless run {scenario.name}", sure)
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
    """Go on with a run that stopped early; the result is that of the whole run, bit for bit.

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
    part = _Part(job, forces, started, result.metadata["command"], sure, result)
    if to is None:
        return part.in_memory(part.step(saved, last), tell)
    return part.to_file(Path(to), saved, last, tell)


@dataclass(frozen=True)
class _Part:
    """A part of a run, after what an earlier result has of it."""

    job: Job
    forces: list[float]
    started: float
    command: str
    sure: Callable[[], dict[str, Any]] | None = None
    earlier: Result | None = None

    def step(
        self, saved: checkpoint.State | None, last: int, take: Take | None = None
    ) -> dict[str, Any]:
        """Take the steps to the last one; returns what the core does."""
        return self.job.step(self.forces, full=True, state=saved, until=last, take=take)

    def in_memory(self, raw: dict[str, Any], tell: Progress) -> Result:
        """Return all that was recorded so far."""
        job, controlled = self.job, self.job.controllers.any
        moving = record.dynamic_variables(raw, job.found, job.scenario, controlled=controlled)
        names = record.names(raw, job.found, job.scenario)
        if self.earlier is not None:
            record.put_behind(self.earlier.dataset, moving, names)
        dataset = Plain.of(moving, names, *self._rest(raw))
        tell(1.0, "done")
        return Result(dataset, job.scenario)

    def to_file(
        self, to: Path, saved: checkpoint.State | None, last: int, tell: Progress
    ) -> Result:
        """Take the steps to the last one, and write meanwhile all that was recorded so far."""
        first = 0 if saved is None else saved.step
        with replacing(to) as file, Stream(file, self.job, range(first, last)) as stream:
            if self.earlier is not None:
                stream.put_before(self.earlier.dataset)
            raw = self.step(saved, last, stream.take)
            stream.take(raw)
            static, attributes = self._rest(raw)
            stream.finish(static | record.extremes(raw, self.job.found), attributes)
        tell(1.0, "done")
        return Result(open_plain(to), self.job.scenario)

    def _rest(self, raw: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return what is no series: the line at rest, the state of a part; and attributes."""
        raw["setup_s"] = time.perf_counter() - self.started - raw["wall_s"]
        job, found, scenario = self.job, self.job.found, self.job.scenario
        static = record.static_variables(found, found.elasticity(found.elasticity_positions()))
        if job.nearby is not None:
            static |= job.nearby.variables
        attributes = attributes_of(job, raw, self.forces, self.earlier)
        attributes["command"] = self.command
        if raw["steps"] == job.travel.steps and scenario.certainty is not None and self.sure:
            attributes["certainty"] = self.sure()
        if raw["steps"] < job.travel.steps:
            numbers = {**raw["state"].numbers, checkpoint.STATIC_FORCE: np.array(self.forces)}
            stopped = checkpoint.State(raw["steps"], numbers)
            place = float(job.travel.positions[stopped.step])
            of = checkpoint.identity(scenario, found, job.travel)
            static["state"], attributes["state"] = checkpoint.stored(stopped, place, of)
        return static, attributes


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
    from arcless.simulate.certainty import found_beside, in_parallel

    workers = len(os.sched_getaffinity(0))
    return found_beside(job, forces, in_parallel(job, tell, cancel, workers))


def whole(
    job: Job,
    forces: list[float],
    raw: dict[str, Any],
    started: float,
    *,
    command: str,
    sure: dict[str, Any] | None = None,
) -> Result:
    """Return the result of a run that went to its end, in memory.

    With the static forces in N, what the core returned, the clock at the start in s, and what was
    run beside it.
    """
    part = _Part(job, forces, started, command, None if sure is None else lambda: sure)
    return part.in_memory(raw, lambda _fraction, _text: None)


def attributes_of(
    job: Job, raw: dict[str, Any], forces: list[float], earlier: Result | None = None
) -> dict[str, Any]:
    """Return what a result says of a run but for its arrays; `raw` has wall_s and setup_s."""
    scenario = job.scenario
    before = {} if earlier is None else earlier.metadata
    duration = raw["steps"] * job.travel.time_step
    wall = raw["wall_s"] + (before.get("wall_time_s") or 0.0)
    names = [placement.name for placement in scenario.pantographs]
    stops = {
        placement.name: force
        for placement, force in zip(scenario.pantographs, raw["stop_max"].tolist(), strict=True)
        if stops_and_friction.stops(placement.model)
    }
    return {
        "arcless_version": _core.__version__,
        "scenario": scenario.to_dict(),
        "as_typed": typed_in(scenario),
        "scenario_name": scenario.name,
        "section_m": list(scenario.analysis_range()),
        "scheme": scenario.stepping.scheme.name,
        "why_matrix": scenario.choice.why,
        "time_step_s": scenario.time_step_s,
        "wire_model": scenario.stepping.wires,
        "contact_wire_element_m": scenario.stepping.contact_wire_element_m,
        "messenger_wire_element_m": scenario.stepping.messenger_wire_element_m,
        "wave_speed_m_s": wave_speed_of(scenario, job.found),
        "steps": raw["steps"],
        "simulated_time_s": duration,
        "wall_time_s": wall,
        "setup_time_s": raw["setup_s"] + (before.get("setup_time_s") or 0.0),
        "real_time_factor": duration / wall,
        "energy_residual_relative": _relative(raw["energy_residual"], raw["energy_turnover"]),
        "slack_droppers_max": raw["slack_max"],
        "lcp_pivots_total": raw["pivots"],
        "lcp_pivots_max": raw["pivots_max"],
        "lcp_pivots_mean": raw["pivots"] / raw["steps"],
        "lcp_pivots_per_step": list(raw["pivot_counts"]),
        "static_force_found": dict(zip(names, np.round(forces, 6).tolist(), strict=True)),
        **({"stop_force_max": stops} if stops else {}),
        **job.controllers.attribute(),
        "warnings": [
            *scenario_warnings(scenario),
            *stops_and_friction.tables_left(scenario.pantographs, raw["law_ranges"].tolist()),
        ],
    }


def _relative(residual: float, turnover: float) -> float | None:
    """Residual of the energy ledger over the energy turned over; None when none was kept."""
    return residual / turnover if turnover > 0.0 else None
