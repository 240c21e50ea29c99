"""Controllers of a run: from the scenario's data to the forces that the core asks for."""

import copy
import math
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ControlError, ResultFormatError
from arcless.model import Scenario
from arcless.model.pantograph.controller import Controller
from arcless.model.pantograph.placement import PantographPlacement
from arcless.pantograph.equation_of_motion import Numbers, unit_vector
from arcless.simulate.setup.core_data import ActuatorData
from arcless.simulate.setup.pid import Limit, PidLaw


@dataclass(frozen=True, slots=True)
class ControlInput:
    """Inputs of a controller at a sample.

    Attributes
    ----------
    time_s, position_m, speed_m_s
        Time, and position and speed of the pantograph along the track.
    contact_force_N
        Contact force of the step before.
    displacements_m, velocities_m_s
        Of the masses from base to head (or of the coordinates), displacements since the start.
    sample_number
        Number of the sample, from 0.
    """

    time_s: float
    position_m: float
    speed_m_s: float
    contact_force_N: float  # noqa: N815 - the unit is spelt as in every result
    displacements_m: tuple[float, ...]
    velocities_m_s: tuple[float, ...]
    sample_number: int


ControlFunction = Callable[[ControlInput], float]


@dataclass
class ControlLoop:
    """One controller in one run."""

    name: str
    law: Callable[[ControlInput, Limit], float]
    controller: Controller
    force: float = 0.0
    pid: PidLaw | None = None

    def __call__(self, *sample: Any) -> float:
        """Return the force in N for a sample, as the core gives it."""
        number, time, position, speed, force, displacements, velocities = sample
        seen = ControlInput(
            time, position, speed, force, tuple(displacements), tuple(velocities), number
        )
        self.force = self.law(seen, self._limit)
        return self.force

    def numbers(self) -> Numbers:
        """Return the state of the loop, without the memory of a function."""
        return [self.force, *(self.pid.numbers() if self.pid else [])]

    def put_back(self, numbers: Numbers) -> None:
        """Restore the state that `numbers` returned."""
        self.force = numbers[0]
        if self.pid:
            self.pid.put_back(numbers[1:])

    def _limit(self, wanted: float) -> float:
        controller = self.controller
        if controller.rate_limit is not None:
            most = controller.rate_limit * controller.sample_time
            wanted = min(max(wanted, self.force - most), self.force + most)
        low, high = controller.minimum_force, controller.maximum_force
        wanted = wanted if low is None else max(wanted, low)
        return wanted if high is None else min(wanted, high)


def acts_on(placement: PantographPlacement, mass: int | None) -> Numbers:
    """Return where a controlled force acts: on a mass counted from 1, or where the preload does."""
    if placement.model.matrices is not None:
        return list(placement.model.matrices.preload)
    return unit_vector(placement.model.size, (mass or 1) - 1)


def _asked(function: Any, name: str) -> Callable[[ControlInput, Limit], float]:
    """Return the law of a function of the user's, whose failures say when and where."""

    def law(seen: ControlInput, limit: Limit) -> float:
        where = f"pantograph {name}, t = {seen.time_s:.6g} s, {seen.position_m:.2f} m"
        try:
            answer = function(seen)
        except Exception as error:
            raise ControlError(
                "the controller failed", where=where, got=f"{type(error).__name__}: {error}"
            ) from error
        try:
            force = float(answer)
        except (TypeError, ValueError):
            force = math.nan
        if not math.isfinite(force):
            raise ControlError(
                "the controller gave no force", where=where, got=repr(answer), expected="N"
            )
        return limit(force)

    return law


def fresh(function: Any) -> Any:
    """Return a controller without memory of another run: an instance of a class, or a copy."""
    return function() if isinstance(function, type) else copy.deepcopy(function)


def load_function(controller: Controller, field: str) -> Any:
    """Run the Python file of a controller and return its function."""
    file, name = controller.place
    path = Path(file)
    spec = spec_from_file_location(f"arcless_controller_{path.stem}", path)
    assert spec is not None  # the model asks for the suffix .py
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look themselves up there
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        raise ControlError(
            f"{file} cannot be run", where=field, got=f"{type(error).__name__}: {error}"
        ) from error
    found = getattr(module, name, None)
    if not callable(found):
        known = [key for key, value in vars(module).items() if callable(value) and key[0] != "_"]
        raise ControlError(
            f"{file} has no function {name}",
            where=field,
            expected=f"one of: {', '.join(known)}" if known else "a function",
        )
    return found


class Controllers:
    """Controllers of a scenario, new for each run of it."""

    def __init__(self, scenario: Scenario, given: Mapping[str, Any] | None = None) -> None:
        self._scenario, self._given = scenario, dict(given or {})
        names = [placement.name for placement in scenario.pantographs]
        for name, function in self._given.items():
            if name not in names:
                raise ControlError(
                    "controller of an unknown pantograph",
                    got=repr(name),
                    expected=f"one of: {', '.join(names)}",
                )
            if not callable(function):
                raise ControlError(
                    f"the controller of {name} cannot be called",
                    got=repr(function),
                    expected="a function of one ControlInput",
                )
        self.actuators()  # wrong files are told before the line is computed

    @property
    def given(self) -> Mapping[str, Any]:
        """Controllers given from Python, by the name of a pantograph."""
        return self._given

    @property
    def any(self) -> bool:
        """True when a pantograph is controlled."""
        placed = any(item.controller is not None for item in self._scenario.pantographs)
        return placed or bool(self._given)

    def attribute(self) -> dict[str, dict[str, str]]:
        """Return the attribute of the result for controllers that the scenario does not name."""
        if not self._given:
            return {}
        names = {name: getattr(f, "__name__", type(f).__name__) for name, f in self._given.items()}
        return {"controllers": names}

    def actuators(self) -> list[ActuatorData | None]:
        """Return new controllers as the core takes them; None where there is none."""
        return [self._actuator(i, p) for i, p in enumerate(self._scenario.pantographs)]

    def check_saved(self) -> None:
        """Refuse functions: what they remember cannot be saved.

        Raises
        ------
        ControlError
            A pantograph is controlled by a function.
        """
        for index, placement in enumerate(self._scenario.pantographs):
            controller = placement.controller
            if placement.name in self._given or (controller and controller.function):
                raise ControlError(
                    "a run with a controller in Python cannot stop early and continue later",
                    where=f"pantographs.{index}.controller",
                    got="a function, whose memory cannot be saved",
                    expected="`pid`, or none",
                    hint="run it in one piece, without `until`",
                )

    def numbers(self, actuators: list[ActuatorData | None]) -> dict[str, NDArray[np.float64]]:
        """Return the states of the controllers, by names of a state."""
        loops = {f"controller_{i}": data.controller for i, data in enumerate(actuators) if data}
        return {name: np.array(loop.numbers()) for name, loop in loops.items()}

    def put_back(
        self, actuators: list[ActuatorData | None], numbers: dict[str, NDArray[np.float64]]
    ) -> None:
        """Restore the states of the controllers from the numbers of a state."""
        for index, data in enumerate(actuators):
            if data:
                saved = numbers.pop(f"controller_{index}", np.zeros(0))
                loop: ControlLoop = data.controller
                if len(saved) != len(loop.numbers()):
                    raise ResultFormatError(
                        "the state in the result is damaged", where=f"controller of {loop.name}"
                    )
                loop.put_back(saved.tolist())

    def _actuator(self, index: int, placement: PantographPlacement) -> ActuatorData | None:
        step, name = self._scenario.time_step_s, placement.name
        controller = placement.controller
        if controller is None:
            if name not in self._given:
                return None
            controller = Controller(sample_time=step)
        pid = None
        if controller.pid is not None and name not in self._given:
            pid = PidLaw(controller.pid, controller.sample_time)
        loop = ControlLoop(name, self._law(index, placement, controller, pid), controller, pid=pid)
        direction = acts_on(placement, controller.mass)
        every, delay = round(controller.sample_time / step), round(controller.delay / step)
        return ActuatorData(direction, every=every, delay=delay, controller=loop)

    def _law(
        self,
        index: int,
        placement: PantographPlacement,
        controller: Controller,
        pid: PidLaw | None,
    ) -> Callable[[ControlInput, Limit], float]:
        name, field = placement.name, f"pantographs.{index}.controller"
        if name in self._given:
            return _asked(fresh(self._given[name]), name)
        if pid is not None:
            return lambda seen, limit: pid(seen.contact_force_N, limit)
        if controller.function is None:
            raise ControlError(
                "nothing decides on the force",
                where=field,
                expected=f'pid, function, or run(scenario, controllers={{"{name}": function}})',
            )
        return _asked(fresh(load_function(controller, f"{field}.function")), name)
