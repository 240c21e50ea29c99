"""A pantograph of a run that is an FMU: asked before each step of the line, moved after it."""

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ArclessError, FmuError, ModelError
from arcless.model.fmu.checks import checked, digest_of, factor_of
from arcless.model.fmu.description import FmuDescription
from arcless.model.fmu.mapping import ROLES, PantographFmu
from arcless.simulate.fmu import fmu_process
from arcless.simulate.fmu.heights import ExtrapolatedHeights, MeasuredHeights
from arcless.simulate.fmu.process import FmuProcess

Floats = NDArray[np.float64]
# Inputs that are given with each step, in the order in which they are sent.
INPUTS = ("base_height", "base_velocity", "speed", "track_position", "control_force")
# A communication step may miss a multiple of the internal one by rounding of what is written.
_MULTIPLE = 1e-6


@dataclass(frozen=True)
class FmuStart:
    """Start of an FMU in a run.

    Attributes
    ----------
    name, field
        Name of the pantograph, and where its FMU stands in the scenario.
    step_s
        Time step in s.
    static_force
        Static force in N, which the strips share at the start.
    height
        Height of the wire above the rails at the start in m.
    inputs
        Value of each of `INPUTS` at the start, SI.
    """

    name: str
    field: str
    step_s: float
    static_force: float
    height: float
    inputs: dict[str, float]


class CoupledFmu:
    """An FMU in a run.

    Attributes
    ----------
    largest_miss
        Largest difference in m between a height that was reached and what the step took for it.
    steps, wall_s
        Number of steps, and time in s that its answers have taken.

    Raises
    ------
    FmuError, ModelError
        It cannot be loaded, or is not what the model says.
    """

    def __init__(self, fmu: PantographFmu, start: FmuStart) -> None:
        self._fmu, self._start = fmu, start
        self._forces = np.full(fmu.strips, start.static_force / fmu.strips)
        self._where = f"pantograph {start.name}, t = 0 s"
        self.largest_miss, self.steps, self.wall_s = 0.0, 0, 0.0
        self._process = FmuProcess(Path(fmu.file), fmu.time_limit)
        try:
            self._description = self._checked()
            self._used = [name for name in INPUTS if getattr(fmu, name) is not None]
            self._to_fmu = self._factors(self._used)
            self._force_unit = self._factors(["contact_force"])
            self._height_unit = self._factors(["strip_height"])
            loaded = self._guarded(lambda: self._process.load(self._loading()))
            self._datum = self._heights(np.array(loaded))
        except BaseException:
            self.close()
            raise
        self._now = np.zeros(fmu.strips)
        self._inputs = start.inputs
        self._step = 0
        self._expected = self._rise = self._now
        self._strips = self._strip_law()

    def _strip_law(self) -> MeasuredHeights | ExtrapolatedHeights:
        if self._fmu.strip_mass is None:
            return MeasuredHeights(self._trial)
        yielding = self._start.step_s**2 / (2.0 * self._fmu.strip_mass)
        return ExtrapolatedHeights(yielding, self._now, self._forces)

    @property
    def sha256(self) -> str:
        """SHA-256 of the file that runs."""
        return self._sha256

    @property
    def version(self) -> int:
        """Version of FMI."""
        return self._description.version

    @property
    def measured(self) -> int:
        """Number of steps in which the compliance was measured."""
        return self._strips.measured

    def predict(
        self, step: int, position: float, inputs: dict[str, float]
    ) -> tuple[Floats, Floats]:
        """Return the heights of the strips without contact force, and their compliance.

        Parameters
        ----------
        step
            Number of the step, from 0.
        position
            Position of the pantograph along the line in m, for messages.
        inputs
            Values of `INPUTS` in the step, SI.

        Returns
        -------
        tuple of array
            Displacement of each strip since the start in m, and compliance in m/N; see `heights`.

        Raises
        ------
        FmuError
            The FMU failed, crashed, hangs, or gave no number.
        """
        at = step * self._start.step_s
        self._where = f"pantograph {self._start.name}, t = {at:.6g} s, {position:.2f} m"
        self._step, self._inputs = step, inputs
        free, compliance = self._guarded(lambda: self._strips.predict(self._forces))
        self._free, self._compliance = free, compliance
        return free, compliance

    def advance(self, forces: Floats) -> Floats:
        """Take the step with the contact forces in N; return the displacements reached in m.

        Raises
        ------
        FmuError
            The FMU failed, crashed, hangs, or gave no number.
        """
        self._forces = np.array(forces, dtype=np.float64)
        rise = self._compliance @ self._forces
        expected = self._free - rise
        content = self._request(self._forces[None, :])
        found = self._guarded(lambda: self._asked(fmu_process.ADVANCE, content))
        self._now = self._heights(found) - self._datum
        self.largest_miss = max(self.largest_miss, float(np.max(np.abs(self._now - expected))))
        self._strips.reached(self._now, expected, rise)
        self.steps += 1
        return self._now

    def close(self) -> None:
        """End the process."""
        self._process.close()

    def facts(self) -> dict[str, Any]:
        """Return what a result says of the FMU."""
        return {
            "file": self._fmu.file,
            "sha256": self._sha256,
            "fmi_version": self.version,
            "steps": self.steps,
            "compliance_measured": self.measured,
            "largest_height_difference_m": self.largest_miss,
            "wall_time_s": self.wall_s,
        }

    def _checked(self) -> FmuDescription:
        """Check the copy that runs; return its description."""
        try:
            description = checked(self._fmu, self._process.file)
        except ModelError as error:
            error.where = f"{self._start.field}.{'.'.join(str(part) for part in error.field)}"
            raise
        self._sha256 = digest_of(self._process.file)
        internal = description.internal_step_s
        if internal:
            ratio = self._start.step_s / internal
            if round(ratio) < 1 or abs(ratio - round(ratio)) > _MULTIPLE * ratio:
                raise ModelError(
                    "a time step that the FMU cannot take",
                    where="solver.time_step",
                    got=f"{1e3 * self._start.step_s:g} ms",
                    expected=f"a multiple of {1e3 * internal:g} ms, the internal step of the FMU"
                    f" of {self._start.name}",
                )
        return description

    def _factors(self, roles: list[str]) -> Floats:
        """Return the SI value of 1 in the unit of each variable of some roles."""
        factors = [
            factor_of(self._description.variables[name], role.unit)
            for wanted in roles
            for field, role, name in self._fmu.used()
            if field == wanted
        ]
        return np.array(factors)

    def _references(self, names: list[str]) -> list[int]:
        return [self._description.variables[name].reference for name in names]

    def _loading(self) -> dict[str, Any]:
        """Return what the process needs to load the FMU."""
        fmu, start, known = self._fmu, self._start, self._description
        given = {"static_force": start.static_force, "start_height": start.height}
        names, values = list(fmu.parameters), list(fmu.parameters.values())
        for role, value in given.items():
            name = getattr(fmu, role)
            if name is not None:
                names.append(name)
                values.append(value / factor_of(known.variables[name], ROLES[role].unit))
        forces = self._forces / self._force_unit
        return {
            "version": known.version,
            "model": known.model,
            "token": known.token,
            "name": start.name,
            "start": [self._references(names), values],
            "inputs": self._references([getattr(fmu, name) for name in self._used]),
            "forces": self._references(list(fmu.contact_force)),
            "heights": self._references(list(fmu.strip_height)),
            "first": [*self._sent(start.inputs), *forces.tolist()],
        }

    def _sent(self, inputs: dict[str, float]) -> list[float]:
        """Return inputs in the units and the order of the FMU."""
        values = np.array([inputs[name] for name in self._used])
        return [float(value) for value in values / self._to_fmu]

    def _request(self, forces: Floats) -> bytes:
        """Return a step with rows of forces in N as the process reads it."""
        start = self._step * self._start.step_s
        rows = (forces / self._force_unit).ravel().tolist()
        return fmu_process.packed([start, self._start.step_s, *self._sent(self._inputs), *rows])

    def _trial(self, forces: Floats) -> Floats:
        found = self._asked(fmu_process.PREDICT, self._request(forces))
        return self._heights(found.reshape(forces.shape)) - self._datum

    def _asked(self, kind: bytes, content: bytes) -> Floats:
        began = time.perf_counter()
        answer = fmu_process.doubles(self._process.ask(kind, content))
        self.wall_s += time.perf_counter() - began
        return np.array(answer)

    def _heights(self, found: Floats) -> Floats:
        """Return heights in m, given in the units of the FMU.

        Raises
        ------
        FmuError
            One of them is no finite number.
        """
        for name, value in zip(self._fmu.strip_height, found.T, strict=True):
            if not np.isfinite(value).all():
                raise FmuError(
                    "the FMU gave no number",
                    where=self._where,
                    got=f"{name} = {np.atleast_1d(value)[0]:g}",
                    expected="a finite height",
                )
        return found * self._height_unit

    def _guarded(self, act: Any) -> Any:
        """Do something with the FMU; a failure says when and where it was."""
        try:
            return act()
        except ArclessError as error:
            if error.where is None:
                error.where = self._where
            raise
