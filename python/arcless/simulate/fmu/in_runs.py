"""FMUs of a run: started for it, called back by its steps, ended with it."""

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model import Scenario
from arcless.model.pantograph.placement import PantographPlacement
from arcless.simulate.fmu.coupled import CoupledFmu, FmuStart
from arcless.simulate.setup.pantographs import roof
from arcless.simulate.setup.trajectory import Motion

Floats = NDArray[np.float64]
# Difference in m of a height from what a step took for it that deserves a warning: on the usual
# contact of 50 kN/m it is a force of 1 N.
NOTABLE = 2e-5


class FmuInRun:
    """FMU of a pantograph as the steps of a run call it.

    Parameters
    ----------
    coupled
        The FMU.
    inputs
        Inputs at the start and at the end of each step, by their names, SI.
    """

    def __init__(self, coupled: CoupledFmu, inputs: dict[str, Floats]) -> None:
        self.coupled, self._inputs = coupled, inputs

    def predict(
        self,
        step: int,
        time: float,  # noqa: ARG002 - the FMU counts its steps
        position: float,
        speed: float,  # noqa: ARG002 - it is an input
    ) -> tuple[list[float], list[float]]:
        """Return the heights of the strips without contact force in m, and compliance in m/N.

        Inputs that change over a step are held at their mean.
        """
        held = {name: (row[step] + row[step + 1]) / 2.0 for name, row in self._inputs.items()}
        free, compliance = self.coupled.predict(step, position, held)
        return free.tolist(), compliance.ravel().tolist()

    def advance(self, forces: Sequence[float]) -> list[float]:
        """Take the step with contact forces in N; return the heights that are reached in m."""
        found: list[float] = self.coupled.advance(np.array(forces)).tolist()
        return found


@contextmanager
def fmus_of(
    scenario: Scenario, found: Equilibrium, travel: Motion, forces: Sequence[float]
) -> Iterator[list[FmuInRun | None]]:
    """Start the FMUs of a run with their static forces in N, and end them after it.

    Raises
    ------
    FmuError, ModelError
        One cannot be loaded, or is not what the model says.
    """
    with ExitStack() as stack:
        started: list[FmuInRun | None] = []
        for index, (placement, force) in enumerate(zip(scenario.pantographs, forces, strict=True)):
            if placement.model.fmu is None:
                started.append(None)
                continue
            inputs = _inputs(placement, travel)
            height = _height(placement, found, travel, force)
            start = FmuStart(
                name=placement.name,
                field=f"pantographs.{index}.model.fmu",
                step_s=travel.time_step,
                static_force=force,
                height=height,
                inputs={name: float(row[0]) for name, row in inputs.items()},
            )
            coupled = CoupledFmu(placement.model.fmu, start)
            stack.callback(coupled.close)
            started.append(FmuInRun(coupled, inputs))
        yield started


def facts(scenario: Scenario, started: Sequence[FmuInRun | None]) -> dict[str, dict[str, Any]]:
    """Return what a result says of the FMUs of a run, by the names of their pantographs."""
    return {
        placement.name: own.coupled.facts()
        for placement, own in zip(scenario.pantographs, started, strict=True)
        if own is not None
    }


def warnings_of(told: dict[str, dict[str, Any]]) -> list[str]:
    """Return a warning for each FMU that missed what its steps took for it."""
    return [
        f"pantograph {name}: heights of its FMU differ by up to"
        f" {1e3 * fact['largest_height_difference_m']:.2g} mm from what a step took for them:"
        " a shorter solver.time_step makes that smaller"
        for name, fact in told.items()
        if fact["largest_height_difference_m"] > NOTABLE
    ]


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


def _height(
    placement: PantographPlacement, found: Equilibrium, travel: Motion, force: float
) -> float:
    """Return the height in m of the wire at the start of a run, raised by a force in N.

    It is found only for an FMU that wants it.
    """
    fmu = placement.model.fmu
    if fmu is None or fmu.start_height is None:
        return 0.0
    place = np.array([float(travel.positions[0]) - placement.distance])
    raised = force * float(found.elasticity(place, force)[0])
    return float(found.lowest_heights(place)[0]) + raised
