"""A whole run, from scenario to result."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from arcless import _core
from arcless.model import Scenario, scenario_warnings
from arcless.results import Result, dataset_from
from arcless.simulate import equilibrium, gusts, joints, motion, record, riders
from arcless.simulate.control import ControlFunction, Controllers
from arcless.simulate.failure import replayable, stepping
from arcless.simulate.mean_force import find_forces

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]


@dataclass(frozen=True)
class Job:
    """A run that is ready to step.

    Attributes
    ----------
    scenario, found, prepared, travel, given, loads, controllers
        The scenario, its equilibrium, the factorised line, the travel, what is given over time for
        each pantograph, and for the line, who decides on forces.
    observe
        Called with the number of steps done; tells whether to go on.
    """

    scenario: Scenario
    found: equilibrium.Equilibrium
    prepared: _core.Prepared
    travel: motion.Motion
    given: list[riders.GivenData]
    loads: list[gusts.LoadData]
    controllers: Controllers
    observe: Callable[[int], bool]

    def step(self, forces: list[float], *, full: bool) -> dict[str, Any]:
        """Run all steps with the given static forces in N; `full` records everything."""
        output = self.scenario.output
        placements = self.scenario.pantographs
        mesh = self.found.mesh
        plan = {
            "contact_every": output.contact_every,
            "line_every": output.line_every if full else self.travel.steps + 1,
            "links": full and output.droppers,
            "nodes": [support.contact_node for support in mesh.supports],
            "points": list(output.points),
            "ledger": full and _keeps_ledger(self.scenario),
        }
        speed = float(self.travel.speeds[0])
        ridden = [
            riders.rider(p.model, force + p.model.lift_at(speed), given, actuator)
            for p, force, given, actuator in zip(
                placements, forces, self.given, self.controllers.actuators(), strict=True
            )
        ]
        with stepping(mesh, placements):
            return self.prepared.run(
                ridden,
                [p.distance for p in placements],
                self.travel.positions.tolist(),
                self.travel.speeds.tolist(),
                self.scenario.contact.friction_coefficient,
                self.loads,
                plan,
                self.observe,
            )


def run(
    scenario: Scenario,
    *,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    controllers: Mapping[str, ControlFunction | type] | None = None,
) -> Result:
    """Run a scenario: statics, dynamics, record.

    Parameters
    ----------
    scenario
        What to run; see `arcless.load`.
    progress
        Called now and then with the fraction done and what is being done.
    cancel
        Asked now and then; the run ends with KeyboardInterrupt when it returns True.
    controllers
        By the name of a pantograph, who decides on its controlled force: a function of a
        `ControlInput` that returns N, or a class of such, of which each run gets an instance. In
        place of `pid` and `function` of the scenario's controller; without one it is asked at
        every step. A search for the static force runs several times, each with a copy.

    Raises
    ------
    MeshError, EquilibriumError, ContactError, ControlError
        The line cannot be divided, has no equilibrium, a step cannot be solved, or a controller
        failed.
    """
    decided = Controllers(scenario, controllers)
    tell = progress or (lambda _fraction, _text: None)
    started = time.perf_counter()
    tell(0.0, "static equilibrium")
    with replayable(scenario):
        found = equilibrium.find(scenario)
    tell(0.0, "factorisation")
    prepared = prepare(found, scenario)
    x = found.elasticity_positions()
    elasticity = found.elasticity(x)
    travel = motion.motion(scenario)
    given = riders.given_motions(scenario, travel)
    observe = _observer(travel.steps, "stepping", tell, cancel)
    loads = gusts.line_loads(found, scenario, travel)
    job = Job(scenario, found, prepared, travel, given, loads, decided, observe)
    searching = replace(
        job, observe=_observer(travel.steps, "finding the static force", tell, cancel)
    )
    forces = find_forces(searching)
    setup = time.perf_counter() - started
    began = time.perf_counter()
    raw = job.step(forces, full=True)
    wall = time.perf_counter() - began
    tell(1.0, "done")
    dataset = dataset_from(
        record.dynamic_variables(raw, found, scenario, controlled=decided.any),
        record.names(raw, found, scenario, x),
        record.static_variables(found, elasticity),
        _attributes(job, raw, forces, setup=setup, wall=wall),
    )
    return Result(dataset, scenario)


def prepare(found: equilibrium.Equilibrium, scenario: Scenario) -> _core.Prepared:
    """Factorise a line for the steps of a scenario."""
    return found.core.prepare(
        found.mesh.lanes,
        motion.scheme_numbers(scenario.solver.scheme),
        scenario.time_step_s,
        motion.contact_stiffness(scenario),
        scenario.solver.kinematics == "updated",
    )


def _keeps_ledger(scenario: Scenario) -> bool:
    # The ledger costs about as much as the step itself; see docs/decisions.
    if scenario.solver.kinematics == "updated":
        return False
    wanted = scenario.output.energy
    return wanted == "always" or (wanted == "auto" and scenario.solver.scheme.name == "trapezoidal")


def _observer(
    steps: int, text: str, tell: Progress, cancel: Cancel | None
) -> Callable[[int], bool]:
    def observe(step: int) -> bool:
        if cancel is not None and cancel():
            raise KeyboardInterrupt
        tell(step / steps, text)
        return True

    return observe


def _attributes(
    job: Job, raw: dict[str, Any], forces: list[float], *, setup: float, wall: float
) -> dict[str, Any]:
    scenario, travel = job.scenario, job.travel
    names = [placement.name for placement in scenario.pantographs]
    stops = {
        placement.name: force
        for placement, force in zip(scenario.pantographs, raw["stop_max"].tolist(), strict=True)
        if joints.stops(placement.model)
    }
    return {
        "arcless_version": _core.__version__,
        "scenario": scenario.to_dict(),
        "scenario_name": scenario.name,
        "section_m": list(scenario.analysis_range()),
        "steps": raw["steps"],
        "simulated_time_s": travel.duration,
        "wall_time_s": wall,
        "setup_time_s": setup,
        "real_time_factor": travel.duration / wall,
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
            *joints.tables_left(scenario.pantographs, raw["law_ranges"].tolist()),
        ],
        "command": f"arcless run {scenario.name}",
    }


def _relative(residual: float, turnover: float) -> float | None:
    """Residual of the energy ledger over the energy turned over; None when none was kept."""
    return residual / turnover if turnover > 0.0 else None
