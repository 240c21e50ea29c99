"""A session: a scenario stepped on and on, with forces that change between two steps."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium import equilibrium
from arcless.errors import ModelError
from arcless.mesh import PLANAR
from arcless.model import Scenario
from arcless.simulate import realtime
from arcless.simulate.setup.trajectory import motion
from arcless.studio.at_rest.of_equilibrium import geometry_at_rest, nodes_of
from arcless.studio.at_rest.plain_geometry import Geometry
from arcless.studio.hands_on.gusts import STATED_LIFT, Gust, has_lift, number

Floats = NDArray[np.float64]

# Offset of a static force in N. Twice what any pantograph presses with; more lifts the line off.
MOST_OFFSET = 300.0


@dataclass(frozen=True)
class Moment:
    """State of a session between two steps, as it is sent.

    Attributes
    ----------
    time_s, position_m
        Since the session began, and of the first pantograph along the track.
    pantographs
        A row each: position m, contact force N, height of the wire m, added force N, and the
        displacement of each mass in m, from the base to the head.
    wires
        By number of the wire in the geometry: number of the first node, displacements in m (up;
        and across, None in the plane) of the nodes near the pantographs.
    """

    time_s: float
    position_m: float
    pantographs: list[Floats]
    wires: list[tuple[int, Floats, Floats | None]]


class Session:
    """A line, its pantographs, and the forces that are added to their static forces.

    Parameters
    ----------
    scenario
        What is stepped. A mean force is found by whole runs, so it is taken as the static force and
        lift with which the session begins; `notes` says so.

    Attributes
    ----------
    notes
        What a user should know, whole sentences.
    pantographs
        Names.
    offset_N
        Added to the static force of each pantograph, N.
    laps
        How often the end of the travel was reached.

    Raises
    ------
    ModelError
        What a real-time loop cannot do, see `arcless.realtime`.
    """

    def __init__(self, scenario: Scenario) -> None:
        self.notes: list[str] = []
        self._scenario = self._with_static_forces(scenario)
        self._travel = motion(self._scenario)
        self._loop = realtime(self._scenario, simulated=True)
        self._start = self._loop.save()
        self._found = equilibrium.find(self._scenario)
        self._wires = [
            np.array(nodes) for _, pieces, _ in nodes_of(self._found.mesh) for nodes in pieces
            if nodes
        ]  # fmt: skip
        self.pantographs = [placement.name for placement in self._scenario.pantographs]
        self.offset_N = np.zeros(len(self.pantographs))
        self._gusts: list[tuple[float, Gust]] = []
        self._steps = self.laps = 0
        self._coordinates = _coordinates(self._scenario, len(self._loop.displacement_m))
        for placement in self._scenario.pantographs:
            if not has_lift(placement.model):
                self.notes.append(
                    f"{placement.model.name} has no law of lift: a gust adds a stated"
                    f" {STATED_LIFT:g} N at its peak"
                )

    @property
    def geometry(self) -> Geometry:
        """The line at rest, for the drawing."""
        return geometry_at_rest(self._found, self._scenario.line)

    @property
    def time_s(self) -> float:
        """Time since the session began, s."""
        return self._steps * self._travel.time_step

    @property
    def static_force_N(self) -> list[float]:  # noqa: N802 - the unit is spelt as in every result
        """Force of each pantograph at the start without lift, N."""
        return [placement.start_force or 0.0 for placement in self._scenario.pantographs]

    @property
    def steps_of_travel(self) -> int:
        """Number of steps from the start of the travel to its end."""
        return self._travel.steps

    @property
    def is_spatial(self) -> bool:
        """True of a line in space; in the plane nothing moves across the track."""
        return self._found.mesh.dimension != PLANAR

    @property
    def speed_m_s(self) -> float:
        """Speed now, m/s."""
        return self._loop.speed_m_s

    def offset(self, pantograph: object, force_N: object) -> None:
        """Set what is added to the static force of a pantograph, by its number from 0, in N.

        Raises
        ------
        ModelError
            There is no such pantograph, or it is no force.
        """
        count = len(self.pantographs)
        if not isinstance(pantograph, int) or isinstance(pantograph, bool) or not (
            0 <= pantograph < count
        ):  # fmt: skip
            raise ModelError("number of a pantograph", expected=f"from 0 to {count - 1}")
        self.offset_N[pantograph] = number("offset", force_N, "N", -MOST_OFFSET, MOST_OFFSET)

    def gust(self, gust: Gust) -> None:
        """Begin a gust, on all pantographs at once."""
        self._gusts.append((self.time_s, gust))

    def added_N(self) -> Floats:  # noqa: N802 - as above
        """Return what is added to the static force of each pantograph now, N."""
        now, speed = self.time_s, self._loop.speed_m_s
        added = self.offset_N.copy()
        self._gusts = [(begun, one) for begun, one in self._gusts if now < begun + one.duration_s]
        for begun, one in self._gusts:
            added += [
                one.lift(placement.model, speed, now - begun)
                for placement in self._scenario.pantographs
            ]
        return added

    def step(self) -> None:
        """Take one step; at the end of the travel the line and the train return to the start.

        Raises
        ------
        ContactError
            A collector leaves the wire, or the step cannot be solved; `begin_anew` mends it.
        """
        following = self._loop.step_number + 1
        if following > self._travel.steps:
            self.begin_anew()
            following = 1
        position, speed = self._travel.positions[following], self._travel.speeds[following]
        self._loop.step(self.added_N(), position_m=float(position), speed_m_s=float(speed))
        self._steps += 1

    def begin_anew(self) -> None:
        """Put line and train back to the start; forces and gusts stay."""
        self._loop.restore(self._start)
        self.laps += 1

    def moment(self, reach_m: float) -> Moment:
        """Return the state now, with the wires up to `reach_m` around the pantographs."""
        loop, added = self._loop, self.added_N()
        places = [loop.position_m - one.distance for one in self._scenario.pantographs]
        heights = self._heights()
        rows = [
            np.concatenate([[places[at], loop.pantograph_force_N[at], heights[at], added[at]], own])
            for at, own in enumerate(np.split(loop.displacement_m, self._coordinates))
        ]
        window = (min(places) - reach_m, max(places) + reach_m)
        return Moment(self.time_s, loop.position_m, rows, list(self._moved(window)))

    def _heights(self) -> Sequence[float]:
        """Return the height of the wire at each pantograph, m: the lowest of its contacts."""
        loop, found = self._loop, dict[str, float]()
        for contact, height in zip(loop.contacts, loop.height_m, strict=True):
            name = max((one for one in self.pantographs if contact.startswith(one)), key=len)
            if not np.isnan(height):
                found[name] = min(height, found.get(name, np.inf))
        return [found.get(name, np.nan) for name in self.pantographs]

    def _moved(self, window: tuple[float, float]) -> list[tuple[int, Floats, Floats | None]]:
        displacement = self._loop.line_displacement_m()
        across = displacement[:, 1] if self.is_spatial else None
        moved = []
        for nodes in self._wires:
            first, end = np.searchsorted(self._found.positions[nodes, 0], window)
            near = nodes[first:end]
            moved.append(
                (int(first), displacement[near, -1], None if across is None else across[near])
            )
        return moved

    def _with_static_forces(self, scenario: Scenario) -> Scenario:
        changes: dict[str, object] = {}
        for at, placement in enumerate(scenario.pantographs):
            if placement.mean_force is not None:
                force = placement.mean_force - placement.model.lift_at(motion(scenario).speeds[0])
                changes[f"pantographs.{at}.mean_force"] = None
                changes[f"pantographs.{at}.static_force"] = force
                self.notes.append(
                    f"the mean force of {placement.name}, {placement.mean_force:g} N, is found by"
                    f" whole runs: here its static force stays at {force:.1f} N"
                )
        return scenario.with_(**changes) if changes else scenario


def _coordinates(scenario: Scenario, count: int) -> list[int]:
    """Return where the coordinates of each pantograph but the first begin, among `count`."""
    own = [placement.model.size for placement in scenario.pantographs]
    ends = np.cumsum(own)
    assert ends[-1] == count
    return ends[:-1].tolist()  # type: ignore[no-any-return]
