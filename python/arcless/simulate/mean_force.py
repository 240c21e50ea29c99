"""The static force that gives a wanted mean contact force.

The mean differs from the static force by the base spring times the mean uplift, and a little by
what the motion does. The line at rest tells most of it, and with which slope the mean follows the
force; so the first correction, F ← F + (target − mean)/slope, is usually the last one. Else the
secant rule goes on.
"""

from collections.abc import Generator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.filter import low_pass, sample_rate_Hz
from arcless.errors import ContactError
from arcless.simulate.contacts import total_force
from arcless.simulate.first_guess import guess

if TYPE_CHECKING:
    from arcless.simulate.job import Job

# A thousandth of the scatter of any measured mean; smaller costs runs and shows nowhere. In N.
TOLERANCE = 0.02
# Two runs are normal. More than this and the mean does not follow the force.
MOST_RUNS = 12


@dataclass(frozen=True)
class Search:
    """What a search ends with: the static force of each pantograph in N, and the last run's record.

    The record is None where no run was needed.
    """

    forces: list[float]
    record: dict[str, Any] | None = None


# Gives the forces to run with, and is sent the record of that run.
Searching = Generator[list[float], dict[str, Any], Search]


def find_forces(job: "Job", *, full: bool = False) -> Search:
    """Return the static force of each pantograph in N, found where a mean force is asked for.

    Parameters
    ----------
    job
        The run.
    full
        Record everything, so that the last run of the search need not be run again.

    Raises
    ------
    ContactError
        The mean force asked for cannot be reached.
    """
    search = searching(job)
    try:
        forces = next(search)
        while True:
            forces = search.send(job.step(forces, full=full))
    except StopIteration as end:
        found: Search = end.value
        return found


def searching(job: "Job") -> Searching:
    """Search as `find_forces` does, but leave the runs to whoever asks for the next forces."""
    placements = job.scenario.pantographs
    forces = np.array([placement.start_force or 0.0 for placement in placements])
    targets = np.array([np.nan if p.mean_force is None else p.mean_force for p in placements])
    if np.isnan(targets).all():
        return Search([float(force) for force in forces])
    guessed, slopes = guess(job, targets)
    # A guess far off would do harm: what the base spring changes is a part of the force.
    forces = np.where(np.abs(guessed - targets) < 0.5 * targets, guessed, forces)
    before: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
    for _ in range(MOST_RUNS):
        raw = yield [float(force) for force in forces]
        means = _means(job, raw)
        errors = np.where(np.isnan(targets), 0.0, targets - means)
        if np.max(np.abs(errors)) <= TOLERANCE:
            return Search([float(force) for force in forces], raw)
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


def _means(job: "Job", raw: dict[str, Any]) -> NDArray[np.float64]:
    """Mean contact force of each pantograph in its section, as the assessment defines it, in N."""
    count = len(job.scenario.pantographs)
    force = total_force(raw, count)
    position = raw["position"].reshape(-1, count)
    filtered = low_pass(force, sample_rate_Hz(raw["time"]), job.scenario.analysis.low_pass)
    start, end = job.scenario.analysis_range()
    inside = (position >= start) & (position <= end)
    return np.array([filtered[inside[:, j], j].mean() for j in range(count)])
