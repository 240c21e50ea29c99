"""Reward of a sample: scatter of the contact force, mean, losses of contact, and effort.

    r = −T (w_σ σ + w_m |F̄ − F_target| + w_l q + w_u u_rms)

with T the time between samples, σ and F̄ standard deviation and mean of the low-passed contact
force over the last window, q the share of the sample's time steps without contact, u_rms the root
mean square of the force that acted in them. A failure costs `failure` once.

Why not σ alone: it falls with the mean force (AC simple at 320 km/h without control: 0.2 N for each
newton), so a controller rewarded for σ alone learns to press less, which is no control but another
static force. With w_m half of w_σ a law was still learnt that pressed 9 N less; w_m is twice w_σ.

σ is that of what an instrument shows while the train runs, filtered forwards (EN 50317 asks for
20 Hz), so an action is felt in it some 30 ms late and for the length of the window. An assessment
filters the whole record without delay over its whole section: its σ is not the mean of these.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.running import RunningLowPass
from arcless.errors import ModelError

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]


@dataclass(frozen=True)
class Weights:
    """Weights of the reward.

    Attributes
    ----------
    scatter_per_N_s
        Of σ over the window: cost of 1 N during 1 s.
    mean_per_N_s
        Of the difference of the mean to its target: cost of 1 N during 1 s.
    loss_per_s
        Of the share of time without contact: cost of a second without contact.
    effort_per_N_s
        Of the root mean square of the controlled force: cost of 1 N during 1 s.
    failure
        Cost of an episode that fails.
    """

    scatter_per_N_s: float = 1.0  # noqa: N815 - units are spelt as in every result
    mean_per_N_s: float = 2.0  # noqa: N815
    loss_per_s: float = 1000.0
    effort_per_N_s: float = 0.02  # noqa: N815
    failure: float = 1000.0

    def __post_init__(self) -> None:
        """Refuse what is no weight."""
        for name, value in asdict(self).items():
            if not isinstance(value, int | float) or not isfinite(value) or value < 0:
                raise ModelError(
                    "a weight of the reward",
                    where=f"weights.{name}",
                    got=repr(value)[:80],
                    expected="a number of at least 0",
                )

    @classmethod
    def of(cls, given: "Weights | Mapping[str, float] | None") -> "Weights":
        """Return weights as they are given: all, some by name, or none.

        Raises
        ------
        ModelError
            A name that is no weight.
        """
        if isinstance(given, Weights):
            return given
        given = dict(given or {})
        known = [field.name for field in fields(cls)]
        for name in given:
            if name not in known:
                raise ModelError(
                    "unknown weight",
                    where="weights",
                    got=repr(name)[:80],
                    expected=f"one of {', '.join(known)}",
                )
        return cls(**given)


@dataclass(frozen=True)
class Scores:
    """Parts of the reward of a sample, a value for each episode.

    Attributes
    ----------
    std_force_N, mean_force_N
        Standard deviation and mean of the low-passed contact force over the window, N.
    lost
        Share of the time steps without contact.
    effort_N
        Root mean square of the controlled force that acted, N.
    """

    std_force_N: Floats  # noqa: N815
    mean_force_N: Floats  # noqa: N815
    lost: Floats
    effort_N: Floats  # noqa: N815


class Meter:
    """Meter of the contact forces of several episodes, sample by sample.

    Parameters
    ----------
    low_pass_Hz, time_step_s
        Cut-off of the filter in Hz, and length of a time step in s.
    window
        Number of samples of the window.
    count
        Number of episodes.
    """

    def __init__(self, low_pass_Hz: float, time_step_s: float, window: int, count: int) -> None:
        self._filter = RunningLowPass(low_pass_Hz, 1.0 / time_step_s, count)
        self._window = np.zeros((count, window))
        self._place = np.zeros(count, dtype=np.intp)

    def begin(self, rows: Numbers, force_N: Floats) -> None:
        """Begin some episodes, given by their numbers, with contact forces that were constant."""
        self._filter.begin(rows, force_N)
        self._window[rows] = force_N[:, None]
        self._place[rows] = 0

    def take(self, rows: Numbers, contact_force_N: Floats, steps: int) -> None:
        """Take the contact forces of many samples of so many steps, behind those of the start."""
        filtered = self._filter.filtered(rows, contact_force_N)[:, steps - 1 :: steps]
        kept = min(self._window.shape[1], filtered.shape[1])
        self._window[rows, self._window.shape[1] - kept :] = filtered[:, filtered.shape[1] - kept :]

    def read(self, rows: Numbers, contact_force_N: Floats, force_N: Floats) -> Scores:
        """Take the contact forces and controlled forces of a sample, a column for each step."""
        filtered = self._filter.filtered(rows, contact_force_N)
        # One of each sample: what is left below 20 Hz does not change within 5 ms.
        self._window[rows, self._place[rows]] = filtered[:, -1]
        self._place[rows] = (self._place[rows] + 1) % self._window.shape[1]
        window = self._window[rows]
        return Scores(
            std_force_N=window.std(axis=1),
            mean_force_N=window.mean(axis=1),
            lost=(contact_force_N <= 0.0).mean(axis=1),
            effort_N=np.sqrt((force_N**2).mean(axis=1)),
        )


def reward(weights: Weights, scores: Scores, target_force_N: float, sample_time_s: float) -> Floats:
    """Return the reward of a sample by the formula above."""
    cost = (
        weights.scatter_per_N_s * scores.std_force_N
        + weights.mean_per_N_s * np.abs(scores.mean_force_N - target_force_N)
        + weights.loss_per_s * scores.lost
        + weights.effort_per_N_s * scores.effort_N
    )
    return np.asarray(-sample_time_s * cost)
