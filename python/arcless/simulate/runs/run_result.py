"""Result of a run, or of a part of one: in memory or written while it steps."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from arcless import _core
from arcless.dataset.netcdf.store import open_plain
from arcless.dataset.plain_dataset import Plain
from arcless.equilibrium.initial_configuration import wave_speed_of
from arcless.model import scenario_warnings
from arcless.model.scenario.as_typed import typed_in
from arcless.results import Result
from arcless.simulate.fmu.in_runs import warnings_of
from arcless.simulate.recording import record
from arcless.simulate.runs import checkpoint
from arcless.simulate.runs.job import Job, Progress
from arcless.simulate.runs.streaming import Stream
from arcless.simulate.runs.viewer import Take
from arcless.simulate.setup import stops_and_friction
from arcless.storage.whole_files import replacing


@dataclass(frozen=True)
class Part:
    """A part of a run, after what an earlier result has of it.

    Attributes
    ----------
    job, forces, started, command
        The run laid out, its static forces in N, the clock at its start in s, the command that
        runs it again.
    sure
        Runs what says how sure the numbers of the whole run are; None where nobody asked.
    earlier
        The result of the parts before this one.
    """

    job: Job
    forces: list[float]
    started: float
    command: str
    sure: Callable[[], dict[str, Any]] | None = None
    earlier: Result | None = None

    def step(
        self, saved: checkpoint.State | None, last: int, take: Take | None = None
    ) -> dict[str, Any]:
        """Take the steps to the last one; return the record of the core."""
        return self.job.step(self.forces, full=True, state=saved, until=last, take=take)

    def in_memory(self, raw: dict[str, Any], tell: Progress) -> Result:
        """Return all that was recorded so far."""
        job, controlled = self.job, self.job.controllers.any
        moving = record.dynamic_variables(
            raw, job.found, job.scenario, controlled=controlled, motion=job.kept_motion
        )
        names = record.names(raw, job.found, job.scenario, job.kept_motion)
        if self.earlier is not None:
            record.put_behind(self.earlier.dataset, moving, names)
        dataset = Plain.of(moving, names, *self._rest(raw, tell))
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
            static, attributes = self._rest(raw, tell)
            stream.finish(static | record.extremes(raw, self.job.found), attributes)
        tell(1.0, "done")
        return Result(open_plain(to), self.job.scenario)

    def _rest(self, raw: dict[str, Any], tell: Progress) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the variables that are no series: the line at rest, the state; and attributes."""
        raw["setup_s"] = time.perf_counter() - self.started - raw["wall_s"]
        job, found, scenario = self.job, self.job.found, self.job.scenario
        done = raw["steps"] / job.travel.steps
        tell(done, "finding the elasticity of the line")
        static = record.static_variables(found, found.elasticity(found.elasticity_positions()))
        if job.nearby is not None:
            static |= job.nearby.variables
        if job.kept_motion is not None:
            static |= job.kept_motion.variables
        attributes = attributes_of(job, raw, self.forces, self.earlier)
        attributes["command"] = self.command
        if raw["steps"] == job.travel.steps and scenario.certainty is not None and self.sure:
            tell(done, "finding how sure the numbers are")
            attributes["certainty"] = self.sure()
        if raw["steps"] < job.travel.steps:
            numbers = {**raw["state"].numbers, checkpoint.STATIC_FORCE: np.array(self.forces)}
            stopped = checkpoint.State(raw["steps"], numbers)
            place = float(job.travel.positions[stopped.step])
            of = checkpoint.identity(scenario, found, job.travel)
            static["state"], attributes["state"] = checkpoint.stored(stopped, place, of)
        return static, attributes


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

    With the static forces in N, what the core returned, the clock at the start in s, and the
    additional runs.
    """
    part = Part(job, forces, started, command, None if sure is None else lambda: sure)
    return part.in_memory(raw, lambda _fraction, _text: None)


def attributes_of(
    job: Job, raw: dict[str, Any], forces: list[float], earlier: Result | None = None
) -> dict[str, Any]:
    """Return the attributes of a result; `raw` has wall_s and setup_s."""
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
        **({"fmus": raw["fmus"]} if raw.get("fmus") else {}),
        "warnings": [
            *scenario_warnings(scenario),
            *stops_and_friction.tables_left(scenario.pantographs, raw["law_ranges"].tolist()),
            *warnings_of(raw.get("fmus", {})),
        ],
    }


def _relative(residual: float, turnover: float) -> float | None:
    """Return the residual of the energy balance over the energy turned over; None without one."""
    return residual / turnover if turnover > 0.0 else None
