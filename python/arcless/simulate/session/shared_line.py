"""Many sessions on one line: prepared once, begun anywhere, stepped together by one call.

The steps are those of `arcless.run`, as in `realtime`. What sessions share, the line at rest and
its factor, no step changes; so each leaves the same bits whichever others are stepped with it, and
on however many threads.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless import _core
from arcless.errors import ArclessError, ModelError
from arcless.model import Scenario
from arcless.platforms.processors import processors
from arcless.simulate.certainty.other_starts import carried_forces
from arcless.simulate.runs.failures import stepping, translated
from arcless.simulate.runs.job import lay_out, ready_line
from arcless.simulate.runs.mean_force import find_forces
from arcless.simulate.session.start import check, pantograph_at
from arcless.simulate.setup.controllers import Controllers
from arcless.simulate.setup.core_data import SessionStart

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]
# Spacing in m of the places at which static forces are found; between them they are interpolated.
# Longer misses how the elasticity rises at a dropper, shorter costs time: 1 m is 0.01 N of 170 N.
FORCE_SPACING = 1.0


@dataclass
class Placed:
    """A session on a shared line.

    Attributes
    ----------
    core
        The session.
    start_m, steps
        Where the first pantograph began, and the number of steps taken.
    static_force_N
        Static force of each pantograph there, N.
    start_force_N
        Contact force of each pantograph at the start, N.
    """

    core: _core.Session
    start_m: float
    static_force_N: Floats  # noqa: N815 - the unit is spelt as in every result
    start_force_N: Floats  # noqa: N815
    steps: int = 0


@dataclass(frozen=True)
class Advanced:
    """Outcome of steps taken together: a row for each session, in it one for each step.

    Attributes
    ----------
    contact_force_N
        Contact force of each pantograph, N.
    displacement_m, velocity_m_s
        Of the coordinates of all pantographs, one after the other, as `Realtime` has them.
    failures
        Of each session its error, None where all of its steps were taken.
    """

    contact_force_N: Floats  # noqa: N815
    displacement_m: Floats
    velocity_m_s: Floats
    failures: list[ArclessError | None]


class SharedLine:
    """A line at rest and factorised, on which sessions with simulated pantographs begin.

    Parameters
    ----------
    scenario
        Line, pantographs, constant speed, time step. A `mean_force` is taken as that of the run
        without control, and its static force is found by such a run; begun elsewhere the same
        pantograph has another static force, see `arcless.simulate.certainty`.

    Attributes
    ----------
    scenario
        The scenario, with the static forces found.
    speed_m_s, time_step_s
        Speed in m/s and step length in s.

    Raises
    ------
    ModelError
        What a session cannot do, see `realtime`; or a speed that changes.
    MeshError, EquilibriumError, ContactError
        The line cannot be divided, has no equilibrium, or the mean force is not reached.
    """

    def __init__(self, scenario: Scenario) -> None:
        if scenario.speed is None:
            raise ModelError(
                "a speed that changes",
                where="speed_profile",
                expected="`speed`: sessions on a shared line begin anywhere, at one speed",
            )
        self.speed_m_s, self.time_step_s = scenario.speed, scenario.time_step_s
        free = scenario.with_(
            **{f"pantographs.{i}.controller": None for i in range(len(scenario.pantographs))}
        )
        line = ready_line(free, _quiet)
        job = lay_out(free, Controllers(free), _quiet, None, line)
        forces = find_forces(job).forces
        self.scenario = scenario.with_(**_static(scenario, forces))
        check(self.scenario, simulated=True)
        self._model, self._mesh = line.model, line.found.mesh
        placements = self.scenario.pantographs
        self._names = [placement.name for placement in placements]
        self._distances = [placement.distance for placement in placements]
        self._data = [pantograph_at(placement, self.speed_m_s) for placement in placements]
        self._lift = np.array([p.model.lift_at(self.speed_m_s) for p in placements])
        first, last = scenario.travel_range()
        count = max(2, round((last - first) / FORCE_SPACING) + 1)
        self._places = np.linspace(first, last, count)
        speeds = [self.speed_m_s] * count
        self._forces = np.array(carried_forces(job, forces, self._places.tolist(), speeds))
        trial = self.begin(first).core
        contacts, coordinates = trial.sizes()
        owners = [pantograph for pantograph, _, _ in trial.contacts()]
        self._first = np.searchsorted(owners, np.arange(len(placements)))
        self._contacts, self._width = contacts, 4 * contacts + 2 * coordinates

    def begin(self, place_m: float) -> Placed:
        """Begin a session with the first pantograph at a place, in equilibrium.

        Raises
        ------
        ModelError
            The place is not between start and end of the travel.
        ContactError, EquilibriumError
            There is no wire, or no equilibrium.
        """
        first, last = float(self._places[0]), float(self._places[-1])
        if not first <= place_m <= last:
            raise ModelError(
                "a start outside the travel",
                got=f"{place_m:g} m",
                expected=f"{first:g} to {last:g} m",
            )
        columns = self._forces.T
        forces = np.array([np.interp(place_m, self._places, column) for column in columns])
        start = forces + self._lift
        data = [
            one._replace(start_force=float(force))
            for one, force in zip(self._data, start, strict=True)
        ]
        friction = self.scenario.contact.friction_coefficient
        with stepping(self._mesh, self.scenario.pantographs):
            core = _core.Session.with_pantographs(
                line=self._model,
                pantographs=data,
                distances=self._distances,
                start=SessionStart(place_m, self.speed_m_s, friction),
            )
        return Placed(core, place_m, forces, start)

    def advance(
        self, sessions: Sequence[Placed], forces_N: Floats, workers: int | None = None
    ) -> Advanced:
        """Take steps with sessions; one that fails stops there, the others take all.

        Parameters
        ----------
        sessions
            Sessions of this line, each once.
        forces_N
            Controlled force for each session, step and pantograph in N, upwards positive.
        workers
            Threads; as many as there are processors without it.

        Returns
        -------
        What each step leaves. Rows behind a failure mean nothing.
        """
        forces = np.ascontiguousarray(forces_N, dtype=np.float64)
        count, steps, _ = forces.shape
        out = np.empty((count, steps, self._width))
        taken = _core.advance(
            sessions=[session.core for session in sessions],
            forces=forces,
            positions=self._positions(sessions, steps),
            speeds=np.full(count, self.speed_m_s),
            out=out,
            workers=workers or processors(),
        )
        failures: list[ArclessError | None] = []
        for session, (done, error) in zip(sessions, taken, strict=True):
            session.steps += done
            failures.append(None if error is None else self._failure(session, error))
        contacts = self._contacts
        moved = out[:, :, 4 * contacts :]
        displacement, velocity = np.split(moved, 2, axis=2)
        pressed = np.add.reduceat(out[:, :, :contacts], self._first, axis=2)
        return Advanced(pressed, displacement, velocity, failures)

    def _positions(self, sessions: Sequence[Placed], steps: int) -> Floats:
        """Return where each step ends, by the formula of a run, which has the same bits."""
        h, speed = self.time_step_s, self.speed_m_s
        numbers = np.array([session.steps for session in sessions])[:, None]
        times = h * (numbers + np.arange(1, steps + 1)).astype(np.float64)
        starts = np.array([session.start_m for session in sessions])[:, None]
        return np.asarray(starts + speed * times)

    def _failure(self, session: Placed, error: _core.NativeError) -> ArclessError:
        kind, message, details = error.args
        time = session.steps * self.time_step_s
        failure = translated(self._mesh, self._names, kind, message, {"time": time, **details})
        place = session.start_m + self.speed_m_s * time
        failure.where = f"{failure.where or 'a step'}, first pantograph at {place:.2f} m"
        return failure


def _static(scenario: Scenario, forces: Sequence[float]) -> dict[str, float | None]:
    changes: dict[str, float | None] = {}
    for index, force in enumerate(forces):
        if scenario.pantographs[index].mean_force is not None:
            changes[f"pantographs.{index}.mean_force"] = None
            changes[f"pantographs.{index}.static_force"] = force
    return changes


def _quiet(_fraction: float, _text: str) -> None:
    """Say nothing."""
