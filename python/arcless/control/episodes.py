"""Episodes side by side on one line: begun anywhere, stepped together, a sample at a time."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.control.actuator import Actuators
from arcless.control.reward import Meter, Scores, reward
from arcless.control.signals import Sample, observation
from arcless.control.task import Task
from arcless.errors import ControlError, ModelError
from arcless.simulate.session.shared_line import Advanced, Placed

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]
Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Outcome:
    """Outcome of a sample, a value for each of the episodes that were stepped.

    Attributes
    ----------
    observation
        Signals at the end of the sample, a row for each episode. Of an episode that failed the last
        row that was good.
    reward
        Reward of the sample.
    failures
        Why an episode has failed; None of one that has not.
    finished
        True where the episode has come to its end.
    scores
        Parts of the reward.
    force_N
        Controlled force that acts at the end of the sample, N.
    """

    observation: Floats
    reward: Floats
    failures: list[str | None]
    finished: Flags
    scores: Scores
    force_N: Floats  # noqa: N815 - the unit is spelt as in every result


class Episodes:
    """Episodes of one task; each has its own session, actuator and meter.

    Parameters
    ----------
    task
        Task of all of them.
    count
        Number of episodes.
    workers
        Threads that step; as many as there are processors without it.
    """

    def __init__(self, task: Task, count: int, workers: int | None = None) -> None:
        self.task, self.count, self._workers = task, count, workers
        line = task.line
        cutoff = task.scenario.analysis.low_pass
        self._actuators = Actuators(task.controller, line.time_step_s, count)
        self._meter = Meter(cutoff, line.time_step_s, task.window, count)
        self._sessions: list[Placed | None] = [None] * count
        sizes = [placement.model.size for placement in task.scenario.pantographs]
        first = sum(sizes[: task.pantograph])
        self._own = slice(first, first + sizes[task.pantograph])
        self._before = np.zeros((2, count, sizes[task.pantograph]))
        self._start_force, self._left = np.zeros(count), np.zeros(count, dtype=np.intp)
        self._seen = np.zeros((count, len(task.signals)))
        self._low = np.array([signal.low for signal in task.signals])
        self._high = np.array([signal.high for signal in task.signals])

    def begin(self, rows: Numbers, places_m: Sequence[float]) -> Floats:
        """Begin episodes, given by their numbers, at places in m; returns what is seen then.

        The lead-in is run without a force, so that the waves of the start are gone and the window
        of the reward is full.

        Raises
        ------
        ModelError
            A place from which no episode fits.
        ControlError
            The lead-in failed.
        """
        lengths = []
        for row, place in zip(rows, places_m, strict=True):
            begin = self._count_at(place)
            session = self.task.line.begin(place)
            lead_in, scored = self.task.lengths(begin)
            self._sessions[row], self._left[row] = session, scored
            self._start_force[row] = session.start_force_N[self.task.pantograph]
            lengths.append(lead_in)
        self._actuators.begin(rows)
        self._before[:, rows] = 0.0
        self._meter.begin(rows, self._start_force[rows])
        self._lead_in(rows, np.array(lengths))
        return self._seen[rows].copy()

    def step(self, rows: Numbers, wanted_N: Floats) -> Outcome:
        """Take a sample of episodes, given by their numbers, with the forces wanted in N."""
        self._left[rows] -= 1
        return self._sample(rows, wanted_N)

    def place_m(self, row: int) -> float:
        """Return the place of the first pantograph of an episode, m."""
        session = self._session(row)
        return session.start_m + self.task.line.speed_m_s * (self._step_s * session.steps)

    def time_s(self, row: int) -> float:
        """Return the time since the start of an episode's lead-in, s."""
        return self._session(row).steps * self._step_s

    def static_force_N(self, row: int) -> float:  # noqa: N802 - the unit is part of the name
        """Return the static force of the controlled pantograph in an episode, N."""
        return float(self._session(row).static_force_N[self.task.pantograph])

    @property
    def _step_s(self) -> float:
        return self.task.line.time_step_s

    def _session(self, row: int) -> Placed:
        session = self._sessions[row]
        if session is None:
            raise ControlError("no episode has begun", expected="a call of `reset` before `step`")
        return session

    def _count_at(self, place: Any) -> float:
        low, high = self.task.begin_between
        first, last = (self.task.spans_of_line.place_at(count) for count in (low, high))
        good = isinstance(place, int | float) and first <= place <= last
        if not good:
            raise ModelError(
                "the start of an episode",
                where="start_m",
                got=repr(place)[:80],
                expected=f"a place from {first:g} to {last:g} m: lead-in and episode must fit",
            )
        return self.task.spans_of_line.count_at(place)

    def _lead_in(self, rows: Numbers, samples: Numbers) -> None:
        """Run lead-ins of so many samples, those of one length together, in one piece."""
        steps = self._actuators.steps
        for length in sorted(set(samples.tolist())):
            own = rows[samples == length]
            moved = self._advance(own, np.zeros((len(own), length * steps)))
            failed = next((error for error in moved.failures if error), None)
            if failed is not None:
                raise ControlError("an episode failed before the controller began", got=str(failed))
            pressed = moved.contact_force_N[:, :, self.task.pantograph]
            self._meter.take(own, pressed, steps)
            if length > 1:
                self._before[0, own] = moved.displacement_m[:, -1 - steps, self._own]
                self._before[1, own] = moved.velocity_m_s[:, -1 - steps, self._own]
            self._seen[own] = self._observe(own, moved, np.ones(len(own), dtype=np.bool_))

    def _advance(self, rows: Numbers, acting: Floats) -> Advanced:
        task = self.task
        forces = np.zeros((*acting.shape, len(task.scenario.pantographs)))
        forces[:, :, task.pantograph] = acting
        sessions = [self._session(row) for row in rows.tolist()]
        return task.line.advance(sessions, forces, self._workers)

    def _sample(self, rows: Numbers, wanted: Floats) -> Outcome:
        task = self.task
        acting = self._actuators.ask(rows, wanted)
        moved = self._advance(rows, acting)
        failures = [None if error is None else str(error) for error in moved.failures]
        good = np.array([failure is None for failure in failures])
        pressed = moved.contact_force_N[:, :, task.pantograph]
        # Behind a failure a session leaves no number to filter.
        pressed = np.where(good[:, None], pressed, self._start_force[rows][:, None])
        scores = self._meter.read(rows, pressed, acting)
        seen = self._observe(rows, moved, good)
        beyond = good & ~((seen >= self._low) & (seen <= self._high)).all(axis=1)
        for number in np.flatnonzero(beyond):
            failures[number] = self._beyond(seen[number])
        good &= ~beyond
        self._seen[rows] = np.where(good[:, None], seen, self._seen[rows])
        earned = reward(task.weights, scores, task.target_force_N, task.sample_time_s)
        earned = np.where(good, earned, -task.weights.failure)
        finished, found = self._left[rows] <= 0, self._seen[rows]
        return Outcome(found, earned, failures, finished, scores, acting[:, -1].copy())

    def _observe(self, rows: Numbers, moved: Advanced, good: Flags) -> Floats:
        u, v = moved.displacement_m[:, -1, self._own], moved.velocity_m_s[:, -1, self._own]
        u, v = (np.where(good[:, None], now, 0.0) for now in (u, v))
        places = np.array([self.place_m(row) for row in rows.tolist()])
        places -= self.task.scenario.pantographs[self.task.pantograph].distance
        pressed = moved.contact_force_N[:, -1, self.task.pantograph]
        sample = Sample(
            contact_force_N=np.where(good, pressed, 0.0),
            displacement_m=u,
            velocity_m_s=v,
            displacement_before_m=self._before[0, rows],
            velocity_before_m_s=self._before[1, rows],
            start_force_N=self._start_force[rows],
            asked_force_N=self._actuators.asked_N[rows],
            speed_m_s=self.task.line.speed_m_s,
            span_position=self.task.spans_of_line.within(places),
        )
        self._before[0, rows], self._before[1, rows] = u, v
        return observation(self.task.signals, sample, self.task.reader)

    def _beyond(self, seen: Floats) -> str:
        for signal, value in zip(self.task.signals, seen.tolist(), strict=True):
            if not signal.low <= value <= signal.high:
                return (
                    f"{signal.name} beyond its range: got {value:g} {signal.unit},"
                    f" expected {signal.low:g} to {signal.high:g}"
                )
        return "a signal beyond its range"
