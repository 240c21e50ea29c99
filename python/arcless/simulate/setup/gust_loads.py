"""Gusts → forces on the line over time, as the core takes them.

Per metre of wire with the diameter d, v the speed across and w the speed upwards:

    f = ½ ρ c_d d √(v² + w²) (v, w)

What differs from the steady wind, under which the line is at rest, goes into the run. Between two
places the force is linear in x, outside of them that of the nearest; between two readings the
speeds are linear in time. The motion of the wire itself is not counted against the wind.
"""

from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium, named
from arcless.mesh import Mesh, diameters
from arcless.model import AsBuilt, Gusts, Scenario
from arcless.simulate.setup.core_data import LoadData
from arcless.simulate.setup.trajectory import Motion

Floats = NDArray[np.float64]


def line_loads(found: Equilibrium, scenario: Scenario, travel: Motion) -> list[LoadData]:
    """Return the loads that gusts put on the line of a scenario; none without gusts."""
    built, gusts = scenario.as_built, scenario.as_built.gusts
    if gusts is None:
        return []
    times = travel.time_step * np.arange(travel.steps + 1, dtype=np.float64)
    across, upwards = np.array(built.wind.force(1.0))
    stations, loads = gusts.stations(), []
    shares = _shares(found.mesh, list(stations))
    thickness = diameters(found.mesh, scenario.line, built)
    for share, rows in zip(shares, stations.values(), strict=True):
        pressures = pressure(gusts, built, rows, times)
        for component, sizes in zip((1, 2), pressures - [[across], [upwards]], strict=True):
            if sizes.any():
                pattern = np.zeros((len(share), 3))
                pattern[:, component] = share * thickness
                with named(found.mesh):
                    forces = found.core.nodal_forces(pattern)
                loads.append(LoadData(forces, sizes.tolist()))
    return loads


def pressure(gusts: Gusts, built: AsBuilt, rows: list[int], times: Floats) -> Floats:
    """Return forces in N per metre of wire and of its diameter: across and upwards, over times."""
    wind = built.wind
    known = np.array(gusts.time)[rows]
    speed = np.interp(times, known, np.array(gusts.speed)[rows])
    if gusts.vertical is None:
        strength = 0.5 * wind.air_density * speed**2 * wind.drag_coefficient
        return np.array([np.sign(speed) * (strength * cos(wind.angle)), strength * sin(wind.angle)])
    rising = np.interp(times, known, np.array(gusts.vertical)[rows])
    strength = 0.5 * wind.air_density * np.hypot(speed, rising) * wind.drag_coefficient
    return np.array([strength * speed, strength * rising])


def _shares(mesh: Mesh, places: list[float]) -> list[Floats]:
    """Return the share of each place in the wind on each element; all shares add up to 1."""
    middles = mesh.positions[mesh.elements["nodes"], 0].mean(axis=1)
    return [np.interp(middles, places, np.eye(len(places))[index]) for index in range(len(places))]
