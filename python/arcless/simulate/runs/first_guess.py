"""First guess of the static force for a wanted mean force, from the line at rest.

The base spring K is at rest where the run starts: there the force P = static force + lift has
raised the wire by e₀ P. Under a force that moves, the line behaves like a string on an elastic
foundation, whose rise under the force grows by 1/√(1 − β²) with β = v/c. With the mean e of the
elasticity over the section, and the wire at rest there higher by h on average than at the start,

    F = P − K (h + A e F − e₀ P),   A = 1/√(1 − β²)

    P = (F (1 + K A e) + K h) / (1 + K e₀),      dF/dP = (1 + K e₀) / (1 + K A e)

For the shipped scenarios P is right within 1 N and dF/dP within 0.01 (slack droppers and the other
pantographs of the train have their say), so the second run is the last.

Source: Frýba, Vibration of Solids and Structures under Moving Loads (1999), chapter 13.
"""

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arcless.model import Pantograph

if TYPE_CHECKING:
    from arcless.simulate.runs.job import Job

Floats = NDArray[np.float64]

# Places along the section whose mean stands for all of it.
PLACES = 60
# Near the wave speed a line is no string any more; 0.9 makes 2.3 of a rise.
MOST_SHARE_OF_WAVE_SPEED = 0.9


def guess(job: "Job", targets: Floats) -> tuple[Floats, Floats]:
    """Return static forces in N that may give the mean forces, and the slopes of mean over static.

    Parameters
    ----------
    job
        The run; the travel of each pantograph begins behind the first by its distance.
    targets
        Wanted mean force of each pantograph in N; NaN where none is wanted.
    """
    first, last = job.scenario.analysis_range()
    section = np.linspace(first, last, PLACES)
    speeds, wave_speed = job.travel.speeds, job.scenario.line.wave_speed
    share = 0.0 if wave_speed is None else float(speeds.mean()) / wave_speed
    growth = 1.0 / sqrt(1.0 - min(share, MOST_SHARE_OF_WAVE_SPEED) ** 2)
    placements = job.scenario.pantographs
    bases = [base_stiffness(placement.model) for placement in placements]
    starts = {
        j: np.array([job.travel.positions[0] - placements[j].distance])
        for j in np.flatnonzero(~np.isnan(targets) & np.array(bases, dtype=bool)).tolist()
    }
    forces, slopes = targets.copy(), np.ones(len(targets))
    if not starts:
        return forces, slopes
    # With the middle span, which the record asks for at the end of the run.
    places = [section, *starts.values(), job.found.elasticity_positions()]
    along, *at_starts = job.found.elasticities(places)
    yielding = growth * float(along.mean())
    height = float(job.found.lowest_heights(section).mean())
    for (j, start), at in zip(starts.items(), at_starts, strict=False):
        at_start = 1.0 + bases[j] * float(at[0])
        above = height - float(job.found.lowest_heights(start)[0])
        moving = 1.0 + bases[j] * yielding
        lift = placements[j].model.lift_at(float(speeds[0]))
        forces[j] = (targets[j] * moving + bases[j] * above) / at_start - lift
        slopes[j] = at_start / moving
    return forces, slopes


def base_stiffness(pantograph: Pantograph) -> float:
    """Return the stiffness in N/m against a slow rise; 0 where springs are tables or matrices."""
    springs = [mass.stiffness for mass in pantograph.masses]
    if not springs or not all(springs):
        return 0.0
    return 1.0 / sum(1.0 / spring for spring in springs if spring)
