"""A line in a loop with the outside: a test bench, or a controller that runs elsewhere.

The steps are those of `arcless.run`; here each is taken when it is called for. Inputs are measured
when the step begins and act during it; outputs belong to its end, contact forces to its time of
balance (see docs/theory/dynamics.md).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless import _core
from arcless.errors import ModelError
from arcless.mesh import Mesh
from arcless.model import Scenario
from arcless.model.load import check_kind
from arcless.simulate.runs.failures import translated
from arcless.simulate.session.start import Start, fingerprint, names_of, start

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class RealtimeState:
    """State of a loop between two steps, for `Realtime.restore`. It can be pickled.

    Attributes
    ----------
    step
        Steps taken.
    numbers
        Everything that moves, as arrays by name, SI.
    loop
        Fingerprint of scenario, line at rest and kind of loop.
    """

    step: int
    numbers: dict[str, Floats]
    loop: str


def realtime(scenario: Scenario, *, simulated: bool = False) -> "Realtime":
    """Prepare a line, and the pantographs on it, to be stepped from outside.

    Parameters
    ----------
    scenario
        Line, where the pantographs are, speed and force at the start (`static_force`, or
        `mean_force` where contact forces are given), time step, scheme, contact, friction.
    simulated
        False: contact forces are inputs, wire heights outputs; of the pantographs only the
        distances and the reach of the collectors count. True: the pantographs are simulated;
        a controlled force of each is an input, contact forces are outputs.

    Raises
    ------
    ModelError
        What a loop cannot do: updated kinematics, gusts; contact forces on a line of several
        contact wires; with simulated pantographs a moving roof, lift tables, a `mean_force`.
    MeshError, EquilibriumError, ContactError
        The line cannot be divided, has no equilibrium, or the start is not on it.
    """
    check_kind(scenario)
    return Realtime(scenario, start(scenario, simulated=simulated))


class Realtime:
    """A line in a loop; made by `realtime`.

    The arrays below are the same at all times and hold what the last step left: copy what is to be
    kept. One value for each of `contacts`.

    Attributes
    ----------
    inputs
        Names that `step` takes a force for: collectors, or simulated pantographs.
    contacts
        Collectors; with simulated pantographs each strip on each contact wire.
    time_step_s
        Step length in s.
    contact_force_N
        Contact forces, N: the given ones where they are given.
    height_m, lateral_m
        Contact wire above the rail and across, m, NaN where there is none.
    height_rate_m_s
        Rate of the height of the wire above the collector that moves along, m/s.
    pantograph_force_N
        Contact force of each pantograph, N: sums of `contact_force_N`.
    displacement_m, velocity_m_s
        Of the masses from base to head (or of the coordinates) of all simulated pantographs, one
        after the other: displacements since the start in m, velocities in m/s.
    """

    def __init__(self, scenario: Scenario, begun: Start) -> None:
        self._core: _core.Session = begun.core
        self._mesh: Mesh = begun.mesh
        self._names = begun.inputs
        self._loop = fingerprint(scenario, begun)
        self._simulated = begun.simulated
        self.inputs: tuple[str, ...] = tuple(begun.inputs)
        self.contacts = names_of(begun)
        self.time_step_s = scenario.time_step_s
        count, coordinates = self._core.sizes()
        self._forces = np.zeros(len(begun.inputs))
        self._out = np.zeros(4 * count + 2 * coordinates)
        parts = np.split(self._out, np.cumsum([count] * 4 + [coordinates]))
        self.contact_force_N, self.height_m, self.lateral_m, self.height_rate_m_s = parts[:4]
        self.displacement_m, self.velocity_m_s = parts[4:]
        self._first, self.pantograph_force_N = begun.first, np.zeros(len(begun.first))
        self._steps, self._position, self._speed = self._core.place()
        self._read()

    def __repr__(self) -> str:
        """Say where the loop is and what it asks for."""
        return (
            f"<Realtime step {self.step_number}, {self.time_s:.6g} s, {self.position_m:.6g} m;"
            f" takes {', '.join(self.inputs)}; {1e3 * self.time_step_s:g} ms a step>"
        )

    @property
    def step_number(self) -> int:
        """Number of steps taken."""
        return self._steps

    @property
    def time_s(self) -> float:
        """Time since the start, s."""
        return self._steps * self.time_step_s

    @property
    def position_m(self) -> float:
        """Position of the first pantograph along the track, m."""
        return self._position

    @property
    def speed_m_s(self) -> float:
        """Speed, m/s."""
        return self._speed

    def step(
        self,
        force_N: float | Sequence[float] | Floats,
        *,
        position_m: float | None = None,
        speed_m_s: float | None = None,
    ) -> Floats:
        """Take one step.

        Parameters
        ----------
        force_N
            For each of `inputs` in N, a number where there is one: the contact force measured; or,
            with simulated pantographs, the controlled force, upwards positive.
        position_m, speed_m_s
            Where the first pantograph is at the end of the step, and its speed then. Either follows
            from the other; without both the speed stays.

        Returns
        -------
        Heights of the contact wire in m, `height_m`; with simulated pantographs their contact
        forces in N, `pantograph_force_N`. The array is overwritten by the next step.

        Raises
        ------
        ModelError
            Not one number for each of `inputs`, or one that is not finite.
        ContactError
            A collector leaves the wire, or the step cannot be solved. The loop stands where it
            stood before, unless the motion has grown beyond all bounds.
        """
        self._take_forces(force_N)
        h, speed = self.time_step_s, self._speed
        if position_m is None:
            end = speed if speed_m_s is None else speed_m_s
            position = self._position + 0.5 * h * (speed + end)
        else:
            position = position_m
            end = (position - self._position) / h if speed_m_s is None else speed_m_s
        try:
            self._core.step(self._forces, position, end, self._out)
        except _core.NativeError as error:
            raise self._refusal(error) from error
        self._steps, self._position, self._speed = self._steps + 1, position, end
        np.add.reduceat(self.contact_force_N, self._first, out=self.pantograph_force_N)
        return self.pantograph_force_N if self._simulated else self.height_m

    def line_displacement_m(self) -> Floats:
        """Return the displacements of the line's nodes from rest, in m.

        Returns
        -------
        A row for each node of the mesh: along the track, to the left (in space only), up. A copy,
        made when it is asked for, which takes as long as some steps.
        """
        return self._core.displacements().reshape(-1, self._mesh.dimension)

    def save(self) -> RealtimeState:
        """Return the state between two steps."""
        step, numbers = self._core.take_down()
        return RealtimeState(step, numbers, self._loop)

    def restore(self, state: RealtimeState) -> None:
        """Restore a state: the steps that follow are those that followed it, bit for bit.

        Raises
        ------
        ModelError
            The state is of another loop, or damaged; the loop then stays as it is.
        """
        if state.loop != self._loop:
            raise ModelError(
                "the state is of another loop",
                expected="one of the same scenario and kind, from the same version",
            )
        try:
            self._core.put_back((state.step, state.numbers))
        except _core.NativeError as error:
            raise ModelError("the state is damaged", got=error.args[1]) from error
        self._steps, self._position, self._speed = self._core.place()
        self._read()

    def _read(self) -> None:
        self._core.read(self._out)
        np.add.reduceat(self.contact_force_N, self._first, out=self.pantograph_force_N)

    def _take_forces(self, given: float | Sequence[float] | Floats) -> None:
        forces, count = self._forces, len(self._forces)
        if count == 1 and isinstance(given, int | float):
            forces[0] = given
            return
        try:
            if np.ndim(given) == 1 and len(given) == count:  # type: ignore[arg-type]
                forces[:] = given
                return
        except (TypeError, ValueError):
            pass
        raise ModelError(
            "forces of a step",
            where="force_N",
            got=repr(given)[:80],
            expected=f"a number in N for each of: {', '.join(self.inputs)}",
        )

    def _refusal(self, error: _core.NativeError) -> Exception:
        kind, message, details = error.args
        if kind == "input":
            return ModelError(
                "a step of the loop", where=details["array"], got=message, expected="finite numbers"
            )
        return translated(self._mesh, self._names, kind, message, details)
