"""A pantograph of a run that is an FMU: asked before each step of the line, moved after it."""

import time
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ArclessError, FmuError
from arcless.model.fmu.checks import digest_of, factor_of
from arcless.model.fmu.mapping import ROLES, PantographFmu
from arcless.simulate.fmu import fmu_process
from arcless.simulate.fmu.admission import FmuPlace, check_fit
from arcless.simulate.fmu.heights import ExtrapolatedHeights, MeasuredHeights
from arcless.simulate.fmu.process import FmuProcess
from arcless.units import plain

Floats = NDArray[np.float64]
# Inputs that are given with each step, in the order in which they are sent.
INPUTS = ("base_height", "base_velocity", "speed", "track_position", "control_force")


class CoupledFmu:
    """An FMU in a run: its process runs from the start, it is loaded when the run begins.

    Parameters
    ----------
    fmu, place
        The FMU of the model, and its place in the run.
    static_force
        Static force in N.

    Attributes
    ----------
    largest_miss
        Largest difference in m between a height that was reached and what the step took for it.
    steps, wall_s
        Number of steps, and time in s that its answers have taken.

    Raises
    ------
    FmuError, ModelError
        It is not what the model says.
    """

    def __init__(self, fmu: PantographFmu, place: FmuPlace, static_force: float) -> None:
        self._fmu, self._place, self._static_force = fmu, place, static_force
        self._where = f"pantograph {place.name}, t = 0 s"
        self.largest_miss, self.steps, self.wall_s = 0.0, 0, 0.0
        self._imbalance: float | None = None
        # Forces of steps belong to their times of balance: a step apart, and between them linear.
        self._share = 1.5 - place.balance
        self._process = FmuProcess(Path(fmu.file), fmu.time_limit)
        try:
            self._description = check_fit(fmu, place, self._process.file)
            self._sha256 = digest_of(self._process.file)
            self._used = [name for name in INPUTS if getattr(fmu, name) is not None]
            self._to_fmu = self._factors(self._used)
            self._force_unit = self._factors(["contact_force"])
            self._height_unit = self._factors(["strip_height"])
        except BaseException:
            self.close()
            raise

    @property
    def step_s(self) -> float:
        """Time step in s."""
        return self._place.step_s

    def begin(self, heights: Floats, forces: Floats, inputs: dict[str, float]) -> None:
        """Load and initialise the FMU at the start of a run.

        Parameters
        ----------
        heights
            Heights of the strips above the rails, m.
        forces
            Their contact forces, N.
        inputs
            Values of `INPUTS`, SI.

        Raises
        ------
        FmuError
            It cannot be loaded.
        """
        self._forces = self._held = forces
        self._step, self._inputs = 0, inputs
        given = self._loading(float(heights.mean()))
        loaded = self._guarded(lambda: self._heights(np.array(self._process.load(given))))
        self._begun = heights
        # Heights of the FMU count from any level; the run begins with the strips at the wire.
        self._level = heights - loaded
        if self._fmu.strip_mass is None:
            self._strips: MeasuredHeights | ExtrapolatedHeights = MeasuredHeights(self._trial)
        else:
            yielding = self._place.step_s**2 / (2.0 * self._fmu.strip_mass)
            self._strips = ExtrapolatedHeights(yielding, heights, forces)

    def predict(
        self, step: int, position: float, inputs: dict[str, float]
    ) -> tuple[Floats, Floats]:
        """Return the heights of the strips above the rails without contact force, and compliance.

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
            Heights at the end of the step in m, and compliance in m/N; see `heights`.

        Raises
        ------
        FmuError
            The FMU failed, crashed, hangs, or gave no number.
        """
        at = step * self._place.step_s
        self._where = f"pantograph {self._place.name}, t = {at:.6g} s, {position:.2f} m"
        self._step, self._inputs = step, inputs
        self._free, self._compliance = self._guarded(lambda: self._strips.predict(self._held))
        if self._imbalance is None:
            self._imbalance = self._left_over()
        old = (1.0 - self._share) * self._forces
        return self._free - self._compliance @ old, self._share * self._compliance

    def advance(self, forces: Floats) -> Floats:
        """Take the step with the contact forces in N; return the heights reached in m.

        Raises
        ------
        FmuError
            The FMU failed, crashed, hangs, or gave no number.
        """
        self._held = self._share * forces + (1.0 - self._share) * self._forces
        self._forces = forces
        rise = self._compliance @ self._held
        expected = self._free - rise
        content = self._request(self._held[None, :])
        reached: Floats = self._guarded(lambda: self._asked(fmu_process.ADVANCE, content))[0]
        self.largest_miss = max(self.largest_miss, float(np.max(np.abs(reached - expected))))
        self._strips.reached(reached, expected, rise)
        self.steps += 1
        return reached

    def _left_over(self) -> float:
        """Return the force in N that is left on the strips at the start: S⁻¹ of their first rise.

        Without a compliance it is not known, and 0.
        """
        rise = self._free - self._compliance @ self._forces - self._begun
        stiffness = np.linalg.pinv(self._compliance, rcond=1e-9, hermitian=True)
        return float(np.sum(stiffness @ rise))

    def close(self) -> None:
        """End the process."""
        self._process.close()

    def facts(self) -> dict[str, Any]:
        """Return what a result says of the FMU."""
        return {
            "file": self._fmu.file,
            "sha256": self._sha256,
            "fmi_version": self._description.version,
            "steps": self.steps,
            "compliance_measured": self._strips.measured,
            "largest_height_difference_m": self.largest_miss,
            "start_imbalance_N": self._imbalance or 0.0,
            "wall_time_s": self.wall_s,
        }

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

    def _loading(self, height: float) -> dict[str, Any]:
        """Return what the process needs to load the FMU, at a height of its strips in m."""
        fmu, place, known = self._fmu, self._place, self._description
        given = {"static_force": self._static_force, "start_height": height}
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
            "name": place.name,
            "start": [self._references(names), values],
            "inputs": self._references([getattr(fmu, name) for name in self._used]),
            "forces": self._references(list(fmu.contact_force)),
            "heights": self._references(list(fmu.strip_height)),
            "first": [*self._sent(self._inputs), *forces.tolist()],
        }

    def _sent(self, inputs: dict[str, float]) -> list[float]:
        """Return inputs in the units and the order of the FMU."""
        values = np.array([inputs[name] for name in self._used])
        return [float(value) for value in values / self._to_fmu]

    def _request(self, forces: Floats) -> bytes:
        """Return a step with rows of forces in N as the process reads it."""
        step_s = self._place.step_s
        rows = (forces / self._force_unit).ravel().tolist()
        sent = self._sent(self._inputs)
        return fmu_process.packed([self._step * step_s, step_s, *sent, *rows])

    def _trial(self, forces: Floats) -> Floats:
        found = self._asked(fmu_process.PREDICT, self._request(forces))
        return found.reshape(forces.shape)

    def _asked(self, kind: bytes, content: bytes) -> Floats:
        """Return heights above the rails in m, row by row."""
        began = time.perf_counter()
        answer = fmu_process.doubles(self._process.ask(kind, content))
        self.wall_s += time.perf_counter() - began
        found = np.array(answer).reshape(-1, self._fmu.strips)
        heights: Floats = self._heights(found) + self._level
        return heights

    def _heights(self, found: Floats) -> Floats:
        """Return heights in m, given in the units of the FMU.

        Raises
        ------
        FmuError
            One of them is no finite number.
        """
        for name, value in zip(self._fmu.strip_height, np.atleast_2d(found).T, strict=True):
            if not np.isfinite(value).all():
                raise FmuError(
                    "the FMU gave no number",
                    where=self._where,
                    got=f"{plain(name)} = {value[~np.isfinite(value)][0]:g}",
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
