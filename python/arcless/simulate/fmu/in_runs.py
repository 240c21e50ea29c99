"""FMUs of a run: started for it, called back by its steps, ended with it."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.display.numbers import real_minus
from arcless.model import Scenario
from arcless.model.pantograph.placement import PantographPlacement
from arcless.simulate.fmu.admission import places_of
from arcless.simulate.fmu.coupled import CoupledFmu
from arcless.simulate.setup.core_data import ActuatorData
from arcless.simulate.setup.pantographs import roof
from arcless.simulate.setup.trajectory import Motion

Floats = NDArray[np.float64]
Numbers = list[float]
# Difference in m of a height from what a step took for it that deserves a warning: on the usual
# contact of 50 kN/m it is a force of 1 N.
NOTABLE_HEIGHT = 2e-5
# Force in N that an FMU misses for its balance at the start and that deserves a warning.
NOTABLE_FORCE = 1.0


@dataclass
class FmuInRun:
    """FMU of a pantograph as the steps of a run call it.

    Attributes
    ----------
    coupled
        The FMU.
    inputs
        Inputs at the start and at the end of each step, by their names, SI.
    actuator
        Sampling, delay and law of its controlled force; None without.
    """

    coupled: CoupledFmu
    inputs: dict[str, Floats]
    actuator: ActuatorData | None = None
    controlled: Numbers = field(default_factory=list, init=False)
    _asked: Numbers = field(default_factory=list, init=False)

    def begin(self, heights: Floats, forces: Floats) -> None:
        """Load the FMU at the heights of its strips in m and their contact forces in N."""
        self._start = self._before = self._now = heights
        self._force = float(forces.sum())
        self._step_s = self.coupled.step_s
        self.coupled.begin(heights, forces, {n: float(row[0]) for n, row in self.inputs.items()})

    def predict(
        self, step: int, time: float, position: float, speed: float
    ) -> tuple[Numbers, list[Numbers]]:
        """Return the heights of the strips without contact force in m, and compliance in m/N.

        Inputs that change over a step are held at their mean.
        """
        held = {name: float(row[step] + row[step + 1]) / 2.0 for name, row in self.inputs.items()}
        held["control_force"] = self._control(step, time, position, speed)
        free, compliance = self.coupled.predict(step, position, held)
        return free.tolist(), compliance.tolist()

    def advance(self, forces: Floats) -> Numbers:
        """Take the step with contact forces in N; return the heights that are reached in m."""
        self._force, self._before = float(forces.sum()), self._now
        self._now = self.coupled.advance(forces)
        found: Numbers = self._now.tolist()
        return found

    def _control(self, step: int, time: float, position: float, speed: float) -> float:
        """Return the controlled force that acts in a step, N, sampled as the core samples."""
        if self.actuator is None:
            return 0.0
        every, delay = self.actuator.every, self.actuator.delay
        if step % every == 0:
            moved = (self._now - self._start).tolist()
            rates = ((self._now - self._before) / self._step_s).tolist()
            sample = (step // every, time, position, speed, self._force, moved, rates)
            self._asked.append(self.actuator.controller(*sample))
        acting = (step - delay) // every
        self.controlled.append(self._asked[acting] if acting >= 0 else 0.0)
        return self.controlled[-1]


@contextmanager
def fmus_of(
    scenario: Scenario,
    travel: Motion,
    forces: Sequence[float],
    actuators: Sequence[ActuatorData | None],
) -> Iterator[list[FmuInRun | None]]:
    """Start the FMUs of a run with their static forces in N, and end them after it.

    Raises
    ------
    FmuError, ModelError
        One is not what the model says.
    """
    with ExitStack() as stack:
        started: list[FmuInRun | None] = []
        for index, own in enumerate(places_of(scenario)):
            if own is None:
                started.append(None)
                continue
            coupled = CoupledFmu(*own, forces[index])
            stack.callback(coupled.close)
            inputs = _inputs(scenario.pantographs[index], travel)
            started.append(FmuInRun(coupled, inputs, actuators[index]))
        yield started


def with_controls(
    started: Sequence[FmuInRun | None], every: int
) -> Callable[[dict[str, Any]], dict[str, Any]]:
    """Return a function that puts controlled forces of FMUs into pieces of a record.

    `every` is the number of steps from one row of the record to the next.
    """
    rows = 0

    controlled = any(own is not None and own.actuator is not None for own in started)

    def put(raw: dict[str, Any]) -> dict[str, Any]:
        nonlocal rows
        if not controlled:
            return raw
        count = len(raw["time"])
        table = raw["control"].reshape(count, len(started)).copy()
        for column, own in enumerate(started):
            if own is not None and own.actuator is not None:
                table[:, column] = own.controlled[rows * every :: every][:count]
        rows += count
        return {**raw, "control": table.ravel()}

    return put


def facts(scenario: Scenario, started: Sequence[FmuInRun | None]) -> dict[str, dict[str, Any]]:
    """Return what a result says of the FMUs of a run, by the names of their pantographs."""
    return {
        placement.name: own.coupled.facts()
        for placement, own in zip(scenario.pantographs, started, strict=True)
        if own is not None
    }


def warnings_of(told: dict[str, dict[str, Any]]) -> list[str]:
    """Return a warning for each FMU that missed what its steps took for it, or its balance."""
    found = []
    for name, fact in told.items():
        miss, force = fact["largest_height_difference_m"], fact["start_imbalance_N"]
        if miss > NOTABLE_HEIGHT:
            found.append(
                f"pantograph {name}: heights of its FMU differ by up to {1e3 * miss:.2g} mm from"
                " what a step took for them; a shorter solver.time_step makes that smaller"
            )
        if abs(force) > NOTABLE_FORCE:
            left = real_minus(f"{force:+.3g}")
            found.append(
                f"pantograph {name}: its FMU does not start in balance: {left} N are left on"
                " its strips under the static force; give it static_force, or start values"
            )
    return found


def _inputs(placement: PantographPlacement, travel: Motion) -> dict[str, Floats]:
    """Return what is given to an FMU over time, at the start and after each step."""
    still = np.zeros(travel.steps + 1)
    height, rate = still, still
    if placement.roof_motion is not None:
        height, rate = roof(placement.roof_motion, travel, placement.distance)
    return {
        "base_height": height,
        "base_velocity": rate,
        "speed": travel.speeds,
        "track_position": travel.positions - placement.distance,
        "control_force": still,
    }
