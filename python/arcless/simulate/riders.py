"""Pantograph → rider of the core: matrices, where forces act, what is given over time."""

from math import inf

import numpy as np
from numpy.typing import NDArray

from arcless.model import Scenario
from arcless.model.pantograph import Pantograph, PantographMass
from arcless.model.roof import RoofMotion
from arcless.model.scenario import PantographPlacement
from arcless.simulate import joints
from arcless.simulate.control import ActuatorData
from arcless.simulate.joints import elongation, unit_vector
from arcless.simulate.motion import Motion

Floats = NDArray[np.float64]
Numbers = list[float]
# Forces as direction and N at every instant; the ground as what goes with it, m, and m/s.
GivenData = tuple[list[tuple[Numbers, Numbers]], tuple[Numbers, Numbers, Numbers] | None]
# Offset behind the reference point and half width, m; lateral places, m, and a vector for each.
StripData = tuple[float, float, Numbers, list[Numbers]]
RiderData = tuple[
    Numbers,
    Numbers,
    Numbers,
    list[StripData],
    Numbers,
    Numbers,
    float,
    GivenData,
    list[joints.StopData],
    list[joints.LawData],
    ActuatorData | None,
]
NOTHING: GivenData = ([], None)


def rider(
    pantograph: Pantograph,
    start_force: float,
    given: GivenData = NOTHING,
    actuator: ActuatorData | None = None,
) -> RiderData:
    """Return a pantograph as the core takes it.

    Parameters
    ----------
    pantograph
        A chain of masses, or matrices.
    start_force
        Contact force at the start in N.
    given
        What is given over time, see `given_motion`.
    actuator
        A force decided on during the run.
    """
    if pantograph.matrices is not None:
        parts = pantograph.matrices
        matrices = [np.array(m) for m in (parts.mass, parts.damping, parts.stiffness)]
        # What is symmetric as written but for rounding is made so; the rest keeps its bits.
        matrices = [(m + m.T) / 2.0 for m in matrices]
        lift = parts.lift or (0.0,) * len(parts.strip)
        strip, vectors = list(parts.strip), (list(parts.preload), list(lift))
    else:
        matrices = _chain(pantograph.masses)
        size = len(pantograph.masses)
        strip = unit_vector(size, size - 1)
        vectors = (
            unit_vector(size, 0),
            [p.aerodynamic for p in pantograph.masses],
        )
    mass, damping, stiffness = (m.ravel().tolist() for m in matrices)
    laws = [law.data for law in joints.laws(pantograph)]
    stops = joints.stops(pantograph)
    strips: list[StripData] = [(0.0, inf, [0.0], [strip])]
    return (mass, damping, stiffness, strips, *vectors, start_force, given, stops, laws, actuator)


def _chain(masses: tuple[PantographMass, ...]) -> list[Floats]:
    """Return M = diag(m), C and K; spring i joins mass i to the one below, the first to the base.

    The preload acts on the first mass, the strip is the last.
    """
    size = len(masses)
    stiffness, damping = np.zeros((size, size)), np.zeros((size, size))
    for i, part in enumerate(masses):
        joint = np.array(elongation(size, i))
        stiffness += (part.stiffness or 0.0) * np.outer(joint, joint)
        damping += (part.damping or 0.0) * np.outer(joint, joint)
    return [np.diag([part.mass for part in masses]), damping, stiffness]


def given_motions(scenario: Scenario, travel: Motion) -> list[GivenData]:
    """Return lift tables and roof motion of each pantograph, at the start and after each step."""
    return [_given(placement, travel) for placement in scenario.pantographs]


def _given(placement: PantographPlacement, travel: Motion) -> GivenData:
    pantograph = placement.model
    tables = [
        (unit_vector(len(pantograph.masses), i), part.lift)
        for i, part in enumerate(pantograph.masses)
        if part.lift is not None
    ]
    if pantograph.matrices is not None:
        tables += [(list(table.on), table) for table in pantograph.matrices.lift_tables]
    forces = [
        (direction, np.interp(travel.speeds, table.speed, table.force).tolist())
        for direction, table in tables
    ]
    if placement.roof_motion is None:
        return forces, None
    rigid = (1.0,) * pantograph.size if pantograph.matrices is None else pantograph.matrices.rigid
    height, rate = roof(placement.roof_motion, travel, placement.distance)
    return forces, (list(rigid), height.tolist(), rate.tolist())


def roof(motion: RoofMotion, travel: Motion, distance: float) -> tuple[Floats, Floats]:
    """Return height in m and its rate in m/s of a roof `distance` m behind the first pantograph.

    Between its points the height is the natural cubic spline, the rate its derivative; over
    position, the slope times the speed.
    """
    from scipy.interpolate import CubicSpline

    spline = CubicSpline(motion.points, motion.displacement, bc_type="natural")
    if motion.position is None:
        times = travel.time_step * np.arange(travel.steps + 1, dtype=np.float64)
        return np.asarray(spline(times)), np.asarray(spline(times, 1))
    places = travel.positions - distance
    return np.asarray(spline(places)), np.asarray(spline(places, 1)) * travel.speeds
