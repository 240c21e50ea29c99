"""Monitored runs of one batch member: an observer sees them while they step, and may stop them.

A look is an assessment of that part of the analysis section which all pantographs have travelled.
The core delivers the record every 256 steps, regardless of anything else: so the looks of a run are
the same on every machine, and the joined record of a run that is not stopped equals, bit for bit,
that of a run without looks.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from arcless.assess import Assessment, assess
from arcless.dataset.plain_dataset import Plain
from arcless.simulate.recording.record import joined
from arcless.simulate.runs.job import Job
from arcless.simulate.runs.mean_force import Trial
from arcless.simulate.runs.member import dataset
from arcless.simulate.runs.outcome import Stopped

# The record extends so many periods of the split between the bands beyond the section looked at:
# nearer to its end a filter without phase shift makes numbers up.
LAG_PERIODS = 1.0
# A Butterworth filter of order 6 forgets as its slowest pole, e^(−2π f_c sin(π/12) t): in so many
# periods of its cut-off f_c what comes later has faded to 10⁻¹⁴.
SETTLED_PERIODS = 20.0


@dataclass(frozen=True)
class Look:
    """Part of a run that has been recorded at a look.

    Attributes
    ----------
    run, number
        Which run of a search for a static force it is, from 1 and without those of a coarse copy,
        and which look of it, from 0.
    position_m, time_s
        Where the first pantograph is, and the time since the start of the run.
    assessment
        Of the part of the section that is looked at.
    share
        How much of the samples in the whole section has been seen, at least.
    settled
        Assess the part of the section in which filtered forces will not change any more, whatever
        comes; None where there is no such part yet.
    """

    run: int
    number: int
    position_m: float
    time_s: float
    assessment: Assessment
    share: float
    settled: Callable[[], Assessment | None]


class Watching(Protocol):
    """Observer of the runs of a member."""

    @property
    def places(self) -> Sequence[float]:
        """Parts of the analysis section after which to look, rising, below 1."""

    def see(self, look: Look) -> str | None:
        """Return why the run is to be stopped; None to continue."""


class RunStoppedError(Exception):
    """A run was stopped by its observer."""

    def __init__(self, at: Stopped) -> None:
        super().__init__(at.why)
        self.at = at


class MonitoredRuns:
    """Runs of one batch member under an observer that may stop them, and the steps they took.

    Parameters
    ----------
    job
        The member.
    watching
        Their observer; None for none.
    """

    def __init__(self, job: Job, watching: Watching | None) -> None:
        self._job, self._watching = job, watching
        self._run = self.steps = 0
        self._pieces: list[dict[str, Any]] = []
        self._begin, self._end = job.scenario.analysis_range()

    @property
    def of_run(self) -> int:
        """Steps of one run to its end."""
        return self._job.travel.steps

    def run(self, trial: Trial, *, full: bool) -> dict[str, Any] | None:
        """Run a trial, as it does itself; nobody looks at a coarse copy.

        Raises
        ------
        RunStoppedError
            Its observer wants it to be stopped.
        """
        if self._watching is not None and not trial.is_copy:
            return self._looked_at(trial.forces, full=full)
        raw = trial.run(full=full)
        if self._watching is not None and raw is not None:
            self.steps += round(raw["steps"] * self._price(trial.job))
        return raw

    def _price(self, copy: Job) -> float:
        """Return the cost of a step of a coarse copy over one of the run: ratio of the points."""
        return len(copy.found.mesh.positions) / len(self._job.found.mesh.positions)

    def _looked_at(self, forces: list[float], *, full: bool) -> dict[str, Any]:
        self._run += 1
        self._pieces, before, seen = [], self.steps, 0
        began = time.perf_counter()

        def take(piece: dict[str, Any]) -> None:
            nonlocal seen
            self._pieces.append(piece)
            self.steps = before + piece["steps"]
            while self._is_due(seen):
                self._look(seen, forces, time.perf_counter() - began)
                seen += 1

        last = self._job.step(forces, full=full, take=take, piece=1)
        self.steps = before + last["steps"]
        return joined([*self._pieces, last])

    def _place(self, number: int) -> float:
        """Return where the part of the section that a look is for ends, in m."""
        assert self._watching is not None
        return self._begin + self._watching.places[number] * (self._end - self._begin)

    def _is_due(self, number: int) -> bool:
        assert self._watching is not None
        if number >= len(self._watching.places):
            return False
        lag_s = LAG_PERIODS / self._job.scenario.analysis.band_split
        return bool(self._place_before(lag_s) >= self._place(number))

    def _place_before(self, lag_s: float) -> float:
        """Return where the last pantograph was a time in s before the end of what is recorded."""
        timed = [piece for piece in self._pieces if len(piece["time"])]
        for piece in reversed(timed):
            row = int(np.searchsorted(piece["time"], timed[-1]["time"][-1] - lag_s, "right")) - 1
            if row >= 0:
                position = piece["position"].reshape(len(piece["time"]), -1)
                return float(position[row].min())
        return -np.inf

    def _look(self, number: int, forces: list[float], wall_s: float) -> None:
        assert self._watching is not None
        raw = {**joined(self._pieces), "wall_s": wall_s, "setup_s": 0.0}
        data = dataset(self._job, forces, raw)
        part = (self._begin, self._place(number))
        look = Look(
            run=self._run,
            number=number,
            position_m=float(self._job.travel.positions[raw["steps"]]),
            time_s=raw["steps"] * self._job.travel.time_step,
            assessment=assess(data, section=part),
            share=self._share(data["position"].values, part),
            settled=lambda: self._settled(data),
        )
        why = self._watching.see(look)
        if why is not None:
            raise RunStoppedError(Stopped(look.position_m, look.time_s, why))

    def _settled(self, data: Plain) -> Assessment | None:
        lag_s = SETTLED_PERIODS / self._job.scenario.analysis.low_pass
        until = min(self._place_before(lag_s), self._end)
        inside = (data["position"].values >= self._begin) & (data["position"].values <= until)
        if until <= self._begin or not inside.any(axis=0).all():
            return None
        return assess(data, section=(self._begin, until))

    def _share(self, position: NDArray[np.float64], part: tuple[float, float]) -> float:
        """Return samples in a part of the section over the most that the whole can have."""
        job, shares = self._job, []
        # A sample lies between the positions before and after its step.
        ahead = job.travel.positions[1:][:: job.scenario.output.contact_every]
        behind = job.travel.positions[:-1][:: job.scenario.output.contact_every]
        for placement, own in zip(job.scenario.pantographs, position.T, strict=True):
            low, high = self._begin + placement.distance, self._end + placement.distance
            most = np.count_nonzero((ahead >= low) & (behind <= high))
            shares.append(np.count_nonzero((own >= part[0]) & (own <= part[1])) / most)
        return float(min(shares))
