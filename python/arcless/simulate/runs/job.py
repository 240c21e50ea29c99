"""A run laid out and ready to step."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial
from threading import Lock
from typing import Any

from arcless import _core
from arcless.equilibrium import equilibrium
from arcless.errors import ArclessError
from arcless.model import Scenario
from arcless.model.scenario.coarse_copy import coarse
from arcless.model.settings.schemes import EXPLICIT
from arcless.simulate.fmu.admission import check_admitted
from arcless.simulate.fmu.in_runs import facts, fmus_of, with_controls
from arcless.simulate.recording.motion import MotionLayout, layout_of
from arcless.simulate.recording.recording_window import Nearby, nearby
from arcless.simulate.runs.checkpoint import State
from arcless.simulate.runs.failures import preparing, stepping
from arcless.simulate.runs.viewer import Audience, Take, Viewer
from arcless.simulate.setup import gust_loads, pantographs, trajectory
from arcless.simulate.setup.controllers import Controllers
from arcless.simulate.setup.core_data import (
    Excitation,
    LoadData,
    RecordPlan,
    SteppingData,
    SupportParts,
)

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]
# Numbers of a piece of the series: 8 MB.
PIECE = 1 << 20
# Steps between two in which explicit ones measure what wires store and dissipate, which takes as
# long as ten others. With fewer the ledger would cost more; with more its rows are far apart.
MEASURED_EVERY = 500
# Progress texts of the steps of a run, and of those that search for a static force.
STEPPING, SEARCHING = "stepping", "finding the static force"


@dataclass(frozen=True)
class Job:
    """A run that is ready to step.

    Attributes
    ----------
    scenario, found, model, travel, excitations, loads, controllers
        The scenario, its equilibrium, the factorised line, the travel, forces and base motion over
        time of each pantograph, loads over time of the line, controllers of actuators.
    observe
        Called with the number of steps done; tells whether to continue.
    copy
        Lays out a coarse copy of the run, on which a static force is searched for first; returns
        None where none serves.
    viewer
        Handed the motion of the line while a full run steps; None where nobody looks.
    allow_fmu
        Whether the code of FMUs may run.
    """

    scenario: Scenario
    found: equilibrium.Equilibrium
    model: _core.WireModel
    travel: trajectory.Motion
    excitations: list[Excitation]
    loads: list[LoadData]
    controllers: Controllers
    observe: Callable[[int], bool]
    copy: Callable[[], "Job | None"] = lambda: None
    viewer: Viewer | None = None
    allow_fmu: bool = False

    def step(
        self,
        forces: list[float],
        *,
        full: bool,
        state: State | None = None,
        until: int | None = None,
        take: Take | None = None,
        piece: int | None = None,
    ) -> dict[str, Any]:
        """Run steps with the given static forces in N; `full` records everything.

        From the start or a state, to the end or until so many steps from the start are done. What
        the core returns has the state there, as a `State`, and the wall time in s. With `take` the
        series are handed to it in pieces of at least so many numbers, 8 MB without, and what is
        returned has the last one; `arcless.simulate.recording.record.joined` puts them together.
        """
        placements, mesh = self.scenario.pantographs, self.found.mesh
        speed = float(self.travel.speeds[0])
        actuators = self.controllers.actuators()
        numbers = {} if state is None else dict(state.numbers)
        if state is not None:
            self.controllers.put_back(actuators, numbers)
        audience = self._audience(take) if full else None
        if audience is not None:
            take, piece = audience.take, 1
        began = time.perf_counter()
        with (
            fmus_of(self.scenario, self.travel, forces, actuators) as fmus,
            stepping(mesh, placements, self.travel),
        ):
            pantograph_data = [
                pantographs.data(p.model, force + p.model.lift_at(speed), excitation, actuator, fmu)
                for p, force, excitation, actuator, fmu in zip(
                    placements, forces, self.excitations, actuators, fmus, strict=True
                )
            ]
            put = with_controls(fmus, self.scenario.output.contact_every)
            raw = self.model.run(
                pantographs=pantograph_data,
                distances=[p.distance for p in placements],
                positions=self.travel.positions,
                speeds=self.travel.speeds,
                friction=self.scenario.contact.friction_coefficient,
                loads=self.loads,
                plan=self._plan(full=full),
                observe=self.observe,
                state=None if state is None else (state.step, numbers),
                until=until,
                take=None if take is None else (piece or PIECE, _after(put, take)),
            )
        raw = put(raw)
        if audience is not None:
            raw = audience.whole(raw)
        raw["wall_s"] = time.perf_counter() - began
        raw["fmus"] = facts(self.scenario, fmus)
        step, after = raw["state"]
        raw["state"] = State(step, {**after, **self.controllers.numbers(actuators)})
        return raw

    def _audience(self, take: Take | None) -> Audience | None:
        """Return the receiver of the pieces of a run that is watched; None of one that is not."""
        if self.viewer is None or self.motion is None:
            return None
        kept = self.kept_motion is not None
        return self.viewer.audience(self.scenario, self.found, self.motion, take, kept=kept)

    def _plan(self, *, full: bool) -> RecordPlan:
        output = self.scenario.output
        return RecordPlan(
            contact_every=output.contact_every,
            line_every=output.line_every if full else self.travel.steps + 1,
            links=full and output.droppers,
            nodes=[support.contact_node for support in self.found.mesh.supports],
            supports=self._support_parts() if full and output.supports else [],
            points=list(output.points),
            ledger=keeps_ledger(self.scenario) and (full or measured_every(self.scenario) > 1),
            ledger_every=measured_every(self.scenario),
            near=None if self.nearby is None else self.nearby.plan(self.found.mesh),
            motion=self.motion.plan(self.found) if full and self.motion is not None else None,
        )

    def _support_parts(self) -> list[SupportParts]:
        """Return what holds the wires at supports, in the order in which rows hold them."""
        supports = self.found.mesh.supports
        if self.nearby is not None:
            supports = [supports[i] for i in self.nearby.supports]
        return [
            SupportParts(place.messenger_spring, place.lateral_spring, place.steady_arm)
            for place in supports
        ]

    @cached_property
    def nearby(self) -> Nearby | None:
        """Recording window; None for the whole line."""
        return nearby(self.scenario, self.found.mesh, self.travel.steps)

    @cached_property
    def motion(self) -> MotionLayout | None:
        """Layout of the motion that is recorded, for the result or for a viewer."""
        if self.viewer is None and self.scenario.output.motion is None:
            return None
        return layout_of(self.found, self.scenario)

    @property
    def kept_motion(self) -> MotionLayout | None:
        """Layout of the motion that the result holds."""
        return None if self.scenario.output.motion is None else self.motion


def _after(put: Callable[[dict[str, Any]], dict[str, Any]], take: Take) -> Take:
    """Return what takes a piece of the series after something was put into it."""
    return lambda raw: take(put(raw))


@dataclass(frozen=True)
class Line:
    """A line at rest and factorised for a time step: what runs may share."""

    found: equilibrium.Equilibrium
    model: _core.WireModel
    _lock: Lock = field(default_factory=Lock, compare=False, repr=False)
    _coarse: "list[Line | None]" = field(default_factory=list, compare=False, repr=False)

    def of_copies(self, copied: Scenario, tell: Progress) -> "Line | None":
        """Return the line of the coarse copies of runs that share this one.

        It is made for the first who asks, given a copy; None where it cannot be made.
        """
        with self._lock:
            if not self._coarse:
                try:
                    self._coarse.append(ready_line(copied, tell))
                except ArclessError:
                    self._coarse.append(None)
            return self._coarse[0]


def ready_line(scenario: Scenario, tell: Progress) -> Line:
    """Find the line of a scenario at rest, and factorise it."""
    tell(0.0, "finding the line at rest")
    found = equilibrium.find(scenario)
    tell(0.0, "preparing the steps")
    return Line(found, prepare(found, scenario))


def lay_out(
    scenario: Scenario,
    controllers: Controllers,
    tell: Progress,
    cancel: Cancel | None,
    line: Line | None = None,
    *,
    doing: str = STEPPING,
    allow_fmu: bool = False,
) -> Job:
    """Lay out a run on its line: the travel, and what is given over time.

    `doing` is what is told of its steps; `allow_fmu` whether the code of FMUs may run.

    Raises
    ------
    FmuError, ModelError
        A pantograph is an FMU, and may not run or does not fit.
    """
    check_admitted(scenario, allow_fmu=allow_fmu)
    line = line or ready_line(scenario, tell)
    travel = trajectory.motion(scenario)
    excitations = pantographs.excitations(scenario, travel)
    loads = gust_loads.line_loads(line.found, scenario, travel)
    step_s = scenario.time_step_s if doing == STEPPING else None
    observe = observer(travel.steps, doing, tell, cancel, step_s)
    copy = partial(_coarse_copy, scenario, controllers, tell, cancel, line, allow_fmu=allow_fmu)
    return Job(
        scenario,
        line.found,
        line.model,
        travel,
        excitations,
        loads,
        controllers,
        observe,
        copy,
        allow_fmu=allow_fmu,
    )


def _coarse_copy(
    scenario: Scenario,
    controllers: Controllers,
    tell: Progress,
    cancel: Cancel | None,
    line: Line,
    *,
    allow_fmu: bool,
) -> Job | None:
    """Lay out a coarse copy of a run; None where none serves.

    A controller is sampled in steps of the run, and may remember what it was asked.
    """
    copied = None if controllers.any else coarse(scenario)
    coarser = None if copied is None else line.of_copies(copied, tell)
    if copied is None or coarser is None:
        return None
    try:
        decided = Controllers(copied)
        return lay_out(copied, decided, tell, cancel, coarser, doing=SEARCHING, allow_fmu=allow_fmu)
    except ArclessError:
        return None


def prepare(found: equilibrium.Equilibrium, scenario: Scenario) -> _core.WireModel:
    """Factorise a line for the steps of a scenario, or lay it out for explicit ones.

    Raises
    ------
    ModelError
        The line cannot be stepped as `solver` asks.
    EquilibriumError
        The equations of a step cannot be solved.
    """
    with preparing(found.mesh, scenario):
        return found.core.prepare(lanes=found.mesh.lanes, **stepping_of(scenario)._asdict())


def stepping_of(scenario: Scenario) -> SteppingData:
    """Return how a scenario wants its line to be stepped."""
    return SteppingData(
        scheme=trajectory.scheme_numbers(scenario.stepping.scheme),
        step=scenario.time_step_s,
        contact_stiffness=trajectory.contact_stiffness(scenario),
        updated=scenario.solver.kinematics == "updated",
        period_correction=scenario.solver.period_correction,
    )


def observer(
    steps: int,
    text: str,
    tell: Progress,
    cancel: Cancel | None,
    step_s: float | None = None,
) -> Callable[[int], bool]:
    """Return the callback that is called with the number of steps done.

    With the time step in s it tells the time, behind a comma: ``stepping, 3.2 of 8.0 s``.
    """

    def observe(step: int) -> bool:
        if cancel is not None and cancel():
            raise KeyboardInterrupt
        time = "" if step_s is None else f", {step * step_s:.1f} of {steps * step_s:.1f} s"
        tell(step / steps, f"{text}{time}")
        return True

    return observe


def keeps_ledger(scenario: Scenario) -> bool:
    """Return whether energies are booked in a run of a scenario."""
    # With a matrix the ledger costs about as much as the step itself; see docs/decisions.
    # A ledger books work against one stiffness: with updated kinematics there is none.
    if scenario.solver.kinematics == "updated":
        return False
    wanted, scheme = scenario.output.energy, scenario.stepping.scheme.name
    return wanted == "always" or (wanted == "auto" and scheme in ("trapezoidal", EXPLICIT))


def measured_every(scenario: Scenario) -> int:
    """Return the interval in steps of measuring the wires' dissipation, where a ledger is kept."""
    if scenario.stepping.scheme.name != EXPLICIT or scenario.output.energy == "always":
        return 1
    rows = scenario.output.line_every
    return rows * -(-MEASURED_EVERY // rows)
