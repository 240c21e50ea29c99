"""Pantograph of the model → data of the core: matrices, where forces act, excitation over time."""

from collections.abc import Sequence
from math import inf

import numpy as np
from numpy.typing import NDArray

from arcless.model import Scenario
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.pantograph.placement import PantographPlacement
from arcless.model.pantograph.roof import RoofMotion
from arcless.pantograph.equation_of_motion import matrices, unit_vector
from arcless.simulate.setup import stops_and_friction
from arcless.simulate.setup.collector_head import add_head
from arcless.simulate.setup.core_data import (
    ActuatorData,
    BaseMotion,
    Excitation,
    ExternalPantograph,
    ForceHistory,
    PantographData,
    StripData,
)
from arcless.simulate.setup.trajectory import Motion

Floats = NDArray[np.float64]
NOTHING = Excitation()


def data(
    pantograph: Pantograph,
    start_force: float,
    excitation: Excitation = NOTHING,
    actuator: ActuatorData | None = None,
    external: ExternalPantograph | None = None,
) -> PantographData:
    """Return a pantograph as the core takes it.

    Parameters
    ----------
    pantograph
        A chain of masses, matrices, or an FMU.
    start_force
        Contact force at the start in N.
    excitation
        Forces and motion of the base over time, see `excitations`.
    actuator
        A force decided on during the run.
    external
        Program that moves the strips of an FMU; None where nothing moves.
    """
    if pantograph.fmu is not None:
        strips = [
            plain(unit_vector(pantograph.size, i), pantograph.half_length, offset)
            for i, offset in enumerate(pantograph.fmu.offsets)
        ]
        return PantographData([], [], [], strips, [], [], start_force, external=external)
    if pantograph.matrices is not None:
        parts = pantograph.matrices
        lift = list(parts.lift or (0.0,) * len(parts.strip))
        strips, preload = [plain(parts.strip, pantograph.half_length)], list(parts.preload)
    else:
        lift, strips = _lift_and_strips(pantograph)
        preload = unit_vector(pantograph.size, 0)
    own = matrices(pantograph)
    return PantographData(
        mass=own.mass.ravel().tolist(),
        damping=own.damping.ravel().tolist(),
        stiffness=own.stiffness.ravel().tolist(),
        strips=strips,
        preload=preload,
        lift=lift,
        start_force=start_force,
        excitation=excitation,
        stops=stops_and_friction.stops(pantograph),
        piecewise_forces=[law.data for law in stops_and_friction.piecewise_forces(pantograph)],
        actuator=actuator,
    )


def plain(vector: Sequence[float], half_length: float | None, offset: float = 0.0) -> StripData:
    """Return a strip that is the same everywhere; without a length it reaches every wire.

    `offset` is how far it stands behind the reference point, m.
    """
    return StripData(
        offset=offset, half_width=half_length or inf, knots=[0.0], vectors=[list(vector)]
    )


def _lift_and_strips(pantograph: Pantograph) -> tuple[list[float], list[StripData]]:
    """Return the aerodynamic coefficients and the strips.

    The strip is the last mass, where no head stands on it.
    """
    masses, size = pantograph.masses, pantograph.size
    lift = np.array([part.aerodynamic for part in masses] + [0.0] * (size - len(masses)))
    if pantograph.head is None:
        strip = plain(unit_vector(size, size - 1), pantograph.half_length)
        return lift.tolist(), [strip]
    head = add_head(pantograph.head, len(masses))
    return (lift + head.lift).tolist(), head.strips


def excitations(scenario: Scenario, travel: Motion) -> list[Excitation]:
    """Return lift tables and roof motion of each pantograph, at the start and after each step."""
    return [_excitation(placement, travel) for placement in scenario.pantographs]


def _excitation(placement: PantographPlacement, travel: Motion) -> Excitation:
    pantograph = placement.model
    if pantograph.fmu is not None:  # the motion of the roof is an input of it
        return NOTHING
    tables = [
        (unit_vector(pantograph.size, i), part.lift)
        for i, part in enumerate(pantograph.masses)
        if part.lift is not None
    ]
    if pantograph.matrices is not None:
        tables += [(list(table.on), table) for table in pantograph.matrices.lift_tables]
    forces = [
        ForceHistory(direction, values=np.interp(travel.speeds, table.speed, table.force).tolist())
        for direction, table in tables
    ]
    if placement.roof_motion is None:
        return Excitation(forces)
    height, rate = roof(placement.roof_motion, travel, placement.distance)
    base = BaseMotion(
        influence=list(pantograph.raised), displacement=height.tolist(), rate=rate.tolist()
    )
    return Excitation(forces, base)


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
