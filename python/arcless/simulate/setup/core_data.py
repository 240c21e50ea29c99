"""Data that the core reads by the names of their fields. SI units."""

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

Numbers = Sequence[float]
Floats = NDArray[np.float64]


class StripData(NamedTuple):
    """A collector strip and where a wire touches it."""

    offset: float
    """Behind the reference point of the pantograph, m."""
    half_width: float
    """Half of its length, m."""
    knots: Numbers
    """Lateral places, ascending, m."""
    vectors: Sequence[Numbers]
    """For each of the knots, the height there for a unit of each coordinate."""


class ForceHistory(NamedTuple):
    """A force given over time."""

    direction: Numbers
    """Share of each coordinate."""
    values: Numbers
    """N at the start and after each step."""


class BaseMotion(NamedTuple):
    """Motion of the base of a pantograph, the roof, at the start and after each step."""

    influence: Numbers
    """Displacement of each coordinate for a unit displacement of the base that strains nothing."""
    displacement: Numbers
    """In m."""
    rate: Numbers
    """In m/s."""


class Excitation(NamedTuple):
    """Forces and motion of the base of a pantograph, given over time."""

    forces: Sequence[ForceHistory] = ()
    base: BaseMotion | None = None


class BumpStopData(NamedTuple):
    """A stop between two masses."""

    direction: Numbers
    """Motion that opens it."""
    gap: float
    """In m."""
    stiffness: float
    """In N/m; infinite when it is rigid."""


class PiecewiseForceData(NamedTuple):
    """A spring or damper with a table."""

    direction: Numbers
    """Motion that it looks at."""
    is_damper: bool
    points: Sequence[tuple[float, float]]
    """Elongation in m, or its rate in m/s, and force in N."""


class ActuatorData(NamedTuple):
    """A force decided on during the run."""

    direction: Numbers
    """Share of each coordinate."""
    every: int
    """Steps from sample to sample."""
    delay: int
    """Steps from a sample to its force."""
    controller: Any = None
    """Controller that is asked; None where every step brings its force."""


class ExternalPantograph(Protocol):
    """A program that moves the strips of a pantograph during a run.

    One height for each coordinate that the vectors of its strips combine: of a plain strip, its
    own. Heights are those above the rail, as the contact wire's, in m. An exception ends the run
    and reaches the caller.
    """

    def begin(self, heights: Floats, forces: Floats) -> None:
        """Receive heights in m and contact forces in N of the equilibrium at the start."""

    def predict(
        self, step: int, time: float, position: float, speed: float
    ) -> tuple[Numbers, Sequence[Numbers]]:
        """Return the heights at the end of a step without contact, and the compliance of the step.

        Parameters
        ----------
        step
            Number of the step, from 0.
        time, position, speed
            Those of the pantograph at the start of the step, in s, m, m/s.

        Returns
        -------
        Heights z₀ at the end of the step if no contact force acts in it, m; and rows of the matrix
        S, m/N, by which constant contact forces λ lower them, z₀ − S λ: symmetric, not negative.
        """
        ...

    def advance(self, forces: Floats) -> Numbers:
        """Take the step under contact forces in N; return the heights at its end in m."""
        ...


class PantographData(NamedTuple):
    """A pantograph: matrices by rows, and what acts on its coordinates.

    Of an external one, `strips` and `start_force` count; all other numbers are empty.
    """

    mass: Numbers
    damping: Numbers
    stiffness: Numbers
    strips: Sequence[StripData]
    preload: Numbers
    """Share of the static force on each coordinate."""
    lift: Numbers
    """Aerodynamic coefficients, N·s²/m²."""
    start_force: float
    """Contact force at the start, N."""
    excitation: Excitation = Excitation()
    stops: Sequence[BumpStopData] = ()
    piecewise_forces: Sequence[PiecewiseForceData] = ()
    actuator: ActuatorData | None = None
    external: ExternalPantograph | None = None
    """Program that moves it; None where it is simulated."""


class LoadData(NamedTuple):
    """Forces on the line that keep their pattern."""

    pattern: Sequence[tuple[int, int, float]]
    """Node, component and force in N for the size 1."""
    sizes: Numbers
    """At the start and after each step."""


class Stations(NamedTuple):
    """Parts of a line in the order along the track, of which a row of the record holds some."""

    of: Sequence[int]
    """Their numbers."""
    x: Numbers
    """Their coordinates, ascending, m."""
    in_row: int
    """Number of them in a row."""


class SupportParts(NamedTuple):
    """Parts that hold the wires at a support: rows of the tables of springs and struts."""

    vertical: int | None
    """Vertical spring of the messenger wire, without one of the contact wire or its bridle."""
    lateral: int | None
    """Lateral spring at the same node."""
    arm: int | None
    """Steady arm."""


class RecordingWindow(NamedTuple):
    """Droppers and supports of which only those near the pantographs are recorded."""

    behind: float
    """Distance behind the last pantograph at which a row begins, m."""
    links: Stations
    nodes: Stations


class MotionPlan(NamedTuple):
    """Motion of the wires near the pantographs that a run records."""

    every: int
    """Steps from one row to the next."""
    behind: float
    """Distance behind the last pantograph at which a row begins, m."""
    wires: Sequence["Stations"]
    """Nodes of each wire in the order along it."""
    links: "Stations"
    """Links in the order along the track."""


class RecordPlan(NamedTuple):
    """Series that a run records, and how often."""

    contact_every: int
    """Steps from one row of the contacts to the next."""
    line_every: int
    """Steps from one row of the line to the next."""
    links: bool
    """True when the forces of droppers are recorded."""
    nodes: Sequence[int]
    """Nodes whose uplift is recorded."""
    supports: Sequence[SupportParts]
    """Parts that hold the wires at each of these, or of those in `near`; empty for no forces."""
    points: Numbers
    """Coordinates along the track at which the uplift of the contact wire is recorded, m."""
    ledger: bool
    """True when the energy balance is kept."""
    ledger_every: int
    """Steps between two in which explicit ones measure what wires dissipate."""
    near: RecordingWindow | None = None
    """None for the whole line."""
    motion: MotionPlan | None = None
    """None for no motion of the wires."""


class CollectorData(NamedTuple):
    """A collector that presses with a force given from outside."""

    behind: float
    """Distance behind the position, m."""
    half_width: float
    """In m."""


class SessionStart(NamedTuple):
    """State of motion in which a session begins."""

    position: float
    """In m."""
    speed: float
    """In m/s."""
    friction: float
    """Coefficient between strip and wire."""


class SteppingData(NamedTuple):
    """Choice of the steps of a line."""

    scheme: tuple[str, list[float]]
    """Name and parameters."""
    step: float
    """Length of a step, s."""
    contact_stiffness: float
    """In N/m; infinite when it is rigid."""
    updated: bool
    """True when coordinates and stiffness are formed at every position."""
    period_correction: bool


class DriveData(NamedTuple):
    """Load of an exported line: collectors or pantographs, external ones too."""

    collectors: Sequence[CollectorData] = ()
    forces: Numbers = ()
    """Force of each collector at the start, N."""
    pantographs: Sequence[PantographData] = ()
    distances: Numbers = ()
    """Distance of each pantograph behind the first, m."""


class OnLineData(NamedTuple):
    """A pantograph on an exported line."""

    name: str
    strips: int
    """Number of its strips."""
    heights: Sequence[tuple[int, str]]
    """Coordinates that are heights, with names; empty where it is not simulated."""
