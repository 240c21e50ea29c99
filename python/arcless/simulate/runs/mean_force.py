"""The static force that gives a wanted mean contact force.

The mean differs from the static force by the base spring times the mean uplift, and a little by
what the motion does. The line at rest tells most of it, and with which slope the mean follows the
force: F ← F + (target − mean)/slope. A coarse copy of the run, at a quarter of its price, tells
the rest; then the run itself with that force usually has the mean asked for, and is the result.
Where it has not, or no copy serves, the search continues with whole runs, by the secant rule.
"""

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import low_pass, sample_rate_Hz
from arcless.errors import ArclessError, ContactError
from arcless.simulate.recording.contacts import total_force
from arcless.simulate.runs.first_guess import guess

if TYPE_CHECKING:
    from arcless.simulate.runs.job import Job

Floats = NDArray[np.float64]
Outcome = TypeVar("Outcome")

# A thousandth of the scatter of any measured mean; smaller costs runs and shows nowhere. In N.
TOLERANCE = 0.02
# One run after that of a copy is normal. More than this and the mean does not follow the force.
MOST_RUNS = 12
# A correction of up to this in N is made without trying it: slopes are right within a hundredth.
SURE = 1.0
# More runs of a copy than this cost as much as one of the run itself.
MOST_OF_COPY = 4


@dataclass(frozen=True)
class Search:
    """Outcome of a search: static force of each pantograph in N, and the last run's record.

    The record is None where no run was needed.
    """

    forces: list[float]
    record: dict[str, Any] | None = None


@dataclass(frozen=True)
class Trial:
    """A run that a search asks for.

    Attributes
    ----------
    job
        The run itself, or its coarse copy.
    forces
        Static force of each pantograph in N.
    is_copy
        Whether it is the copy: nobody wants more of it than its means.
    """

    job: "Job"
    forces: list[float]
    is_copy: bool = False

    def run(self, *, full: bool) -> dict[str, Any] | None:
        """Run it; `full` records everything. None where a copy fails: it proves nothing."""
        if not self.is_copy:
            return self.job.step(self.forces, full=full)
        try:
            return self.job.step(self.forces, full=False)
        except ArclessError:
            return None


# Gives runs to make, and is sent their records.
Searching = Generator[Trial, dict[str, Any] | None, Search]


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
    return make_runs(searching(job), lambda trial: trial.run(full=full))


def make_runs(
    asking: Generator[Trial, dict[str, Any] | None, Outcome],
    run: Callable[[Trial], dict[str, Any] | None],
) -> Outcome:
    """Make the runs that are asked for until no more are, and return the outcome."""
    try:
        trial = next(asking)
        while True:
            trial = asking.send(run(trial))
    except StopIteration as end:
        outcome: Outcome = end.value
        return outcome


def searching(job: "Job") -> Searching:
    """Search as `find_forces` does, but leave the runs to the caller."""
    placements = job.scenario.pantographs
    forces = np.array([placement.start_force or 0.0 for placement in placements])
    targets = np.array([np.nan if p.mean_force is None else p.mean_force for p in placements])
    if np.isnan(targets).all():
        return Search([float(force) for force in forces])
    guessed, slopes = guess(job, targets)
    # A guess far off would do harm: what the base spring changes is a part of the force.
    forces = np.where(np.abs(guessed - targets) < 0.5 * targets, guessed, forces)
    rule = _Secant(targets, forces, slopes)
    copy = job.copy()
    if copy is not None:
        rule = yield from _on_copy(job, copy, rule)
    for _ in range(MOST_RUNS):
        tried = rule.given()
        raw = yield rule.trial(job)
        assert raw is not None
        means = _means(job, raw)
        if rule.worst(means) <= TOLERANCE:
            return Search(rule.given(), raw)
        rule.correct(means)
        if np.min(rule.forces) <= 0.0:
            break
    raise _not_reached(job, means, targets, tried)


def _on_copy(
    job: "Job", copy: "Job", rule: "_Secant"
) -> Generator[Trial, dict[str, Any] | None, "_Secant"]:
    """Search on a coarse copy of a run; returns with which forces to begin, and which slopes."""
    begun = rule.anew()
    for _ in range(MOST_OF_COPY):
        raw = yield rule.trial(copy, is_copy=True)
        if raw is None:
            return begun
        means = _means(copy, raw, job)
        worst = rule.worst(means)
        rule.correct(means)
        if not (np.isfinite(worst) and np.min(rule.forces) > 0.0):
            return begun
        if worst <= SURE:
            break
    return rule.anew()


@dataclass
class _Secant:
    """Static forces in N and the slope of each mean; corrected towards the targets in N."""

    targets: Floats
    forces: Floats
    slopes: Floats
    before: tuple[Floats, Floats] | None = None

    def given(self) -> list[float]:
        return [float(force) for force in self.forces]

    def trial(self, job: "Job", *, is_copy: bool = False) -> Trial:
        return Trial(job, self.given(), is_copy)

    def worst(self, means: Floats) -> float:
        """Return how far the worst mean is from its target in N."""
        return float(np.max(np.abs(self._errors(means))))

    def correct(self, means: Floats) -> None:
        if self.before is not None:
            earlier, then = self.before
            self.slopes = _secant(self.forces - earlier, means - then, self.slopes)
        self.before = self.forces, means
        self.forces = self.forces + self._errors(means) / self.slopes

    def anew(self) -> "_Secant":
        """Return the corrector for other runs: their means may all be a little off."""
        return _Secant(self.targets, self.forces, self.slopes)

    def _errors(self, means: Floats) -> Floats:
        return np.where(np.isnan(self.targets), 0.0, self.targets - means)


def _secant(step: Floats, change: Floats, old: Floats) -> Floats:
    """Return the slope of mean over force, kept near one: noise must not turn it round."""
    moved = np.abs(step) > TOLERANCE
    slope = np.divide(change, step, out=old.copy(), where=moved)
    return np.clip(slope, 0.5, 2.0)


def _means(job: "Job", raw: dict[str, Any], of: "Job | None" = None) -> Floats:
    """Return the mean contact force of each pantograph in its section in N, as assessed.

    Of a coarse copy at the instants of the run that it is `of`: a sample more or less at the ends
    of a section would change the mean by more than the copy does.
    """
    count = len(job.scenario.pantographs)
    filtered = low_pass(
        total_force(raw, count), sample_rate_Hz(raw["time"]), job.scenario.analysis.low_pass
    )
    position = raw["position"].reshape(-1, count)
    if of is not None:
        filtered, position = _at_instants(job, raw["time"], filtered, of)
    start, end = job.scenario.analysis_range()
    inside = (position >= start) & (position <= end)
    return np.array([filtered[inside[:, j], j].mean() for j in range(count)])


def _at_instants(copy: "Job", times: Floats, forces: Floats, run: "Job") -> tuple[Floats, Floats]:
    """Return forces of a copy in N, and positions in m, at the instants that a run records."""
    travel, placements = run.travel, run.scenario.pantographs
    ends = travel.time_step * np.arange(travel.steps + 1)
    # Schemes balance forces at the same part of each step.
    balanced = times[0] / copy.travel.time_step * travel.time_step
    at = ends[: travel.steps : run.scenario.output.contact_every] + balanced
    first = np.interp(at, ends, travel.positions)
    positions = first[:, None] - [placement.distance for placement in placements]
    found = [np.interp(at, times, forces[:, j]) for j in range(len(placements))]
    return np.column_stack(found), positions


def _not_reached(job: "Job", means: Floats, targets: Floats, tried: list[float]) -> ContactError:
    placements = job.scenario.pantographs
    worst = int(np.nanargmax(np.abs(targets - means)))
    return ContactError(
        f"the mean force of pantograph {placements[worst].name} was not reached",
        where=f"pantographs.{worst}.mean_force",
        got=f"{means[worst]:.2f} N, with a static force of {tried[worst]:.4g} N",
        expected=f"{targets[worst]:.2f} N within {TOLERANCE:g} N",
        hint="lift and base spring give more than that by themselves: give a larger mean_force,"
        " or look at lift and masses.0.stiffness of the pantograph"
        if means[worst] - tried[worst] > targets[worst]
        else "the mean does not follow the static force, mostly where contact is lost for long:"
        " give static_force in place of mean_force and look at the run, lower the speed, or"
        " assess a longer section",
    )
