"""The static force that gives a wanted mean contact force.

The mean differs from the static force by the base spring times the mean uplift, and a little by
what the motion does; both change slowly with the force. So the mean is nearly the force plus a
constant, and F ← F + (target − mean), then the secant rule, settles in a few runs.
"""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arcless.assess.filter import low_pass, sample_rate_Hz
from arcless.errors import ContactError
from arcless.simulate.contacts import total_force

if TYPE_CHECKING:
    from arcless.simulate.job import Job

# A thousandth of the scatter of any measured mean; smaller costs runs and shows nowhere. In N.
TOLERANCE = 0.02
# Two or three runs are normal. More than this and the mean does not follow the force.
MOST_RUNS = 12


def find_forces(job: "Job") -> list[float]:
    """Return the static force of each pantograph in N, found where a mean force is asked for.

    Raises
    ------
    ContactError
        The mean force asked for cannot be reached.
    """
    placements = job.scenario.pantographs
    forces = np.array([placement.start_force or 0.0 for placement in placements])
    targets = np.array([np.nan if p.mean_force is None else p.mean_force for p in placements])
    if np.isnan(targets).all():
        return [float(force) for force in forces]
    slopes = np.ones(len(forces))
    before: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
    for _ in range(MOST_RUNS):
        means = _means(job, forces)
        errors = np.where(np.isnan(targets), 0.0, targets - means)
        if np.max(np.abs(errors)) <= TOLERANCE:
            return [float(force) for force in forces]
        if before is not None:
            slopes = _secant(forces - before[0], means - before[1], slopes)
        before = forces.copy(), means
        forces = forces + errors / slopes
        if np.min(forces) <= 0.0:
            break
    worst = int(np.argmax(np.abs(errors)))
    raise ContactError(
        f"the mean force of pantograph {placements[worst].name} was not reached",
        where=f"pantographs.{worst}.mean_force",
        got=f"{means[worst]:.2f} N",
        expected=f"{targets[worst]:.2f} N within {TOLERANCE:g} N",
        hint="give static_force, or a longer analysis section",
    )


def _secant(
    step: NDArray[np.float64], change: NDArray[np.float64], old: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Slope of mean over force, kept near one: loss of contact or noise must not turn it round."""
    moved = np.abs(step) > TOLERANCE
    slope = np.divide(change, step, out=old.copy(), where=moved)
    return np.clip(slope, 0.5, 2.0)


def _means(job: "Job", forces: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean contact force of each pantograph in its section, as the assessment defines it, in N."""
    raw = job.step([float(force) for force in forces], full=False)
    count = len(forces)
    force = total_force(raw, count)
    position = raw["position"].reshape(-1, count)
    filtered = low_pass(force, sample_rate_Hz(raw["time"]), job.scenario.analysis.low_pass)
    start, end = job.scenario.analysis_range()
    inside = (position >= start) & (position <= end)
    return np.array([filtered[inside[:, j], j].mean() for j in range(count)])
