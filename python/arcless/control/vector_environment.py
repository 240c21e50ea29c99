"""Many environments of Gymnasium in one: episodes on one line, stepped together by the core."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from arcless.control.environment import (
    action_space,
    checked_options,
    drawn,
    forces,
    observation_space,
    prepared,
    told,
)
from arcless.control.episodes import Episodes
from arcless.control.task import Task
from arcless.errors import ControlError, ModelError

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


class PantographVectorEnv(VectorEnv[Floats, Floats, NDArray[Any]]):
    """Pantographs on one prepared line, a sample of all of them by one call of the core.

    Each is, bit for bit, a `PantographEnv` with its seed. After an episode has ended the next step
    begins another one, with the reward 0, and takes no action for it; without `autoreset` it waits
    for a `reset`.

    Parameters
    ----------
    num_envs
        Number of pantographs, each on a line of its own.
    workers
        Threads that step; as many as there are processors without it.
    autoreset
        Whether episodes follow one another by themselves.
    render_mode
        None: there is nothing to see.
    **settings
        See `PantographEnv`.
    """

    metadata: dict[str, Any] = {  # noqa: RUF012 - Gymnasium's own
        "render_modes": [],
        "autoreset_mode": AutoresetMode.NEXT_STEP,
    }

    def __init__(
        self,
        num_envs: int = 1,
        *,
        workers: int | None = None,
        autoreset: bool = True,
        render_mode: str | None = None,
        task: Task | None = None,
        **settings: Any,
    ) -> None:
        for name, value in (("num_envs", num_envs), ("workers", workers)):
            if value is not None and (not isinstance(value, int) or value < 1):
                raise ModelError(
                    name, got=repr(value)[:80], expected="a whole number of at least 1"
                )
        if render_mode is not None:
            raise ModelError("unknown render_mode", got=repr(render_mode)[:80], expected="none")
        self.task = prepared(task, settings)
        self.num_envs, self.render_mode = num_envs, render_mode
        self._autoreset = autoreset
        if not autoreset:
            self.metadata = {**self.metadata, "autoreset_mode": AutoresetMode.DISABLED}
        self.single_action_space = action_space(self.task)
        self.single_observation_space = observation_space(self.task)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._episodes = Episodes(self.task, num_envs, workers)
        self._randoms = [seeding.np_random(None)[0] for _ in range(num_envs)]
        self._seen = np.zeros((num_envs, len(self.task.signals)))
        self._ended: Flags | None = None

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Floats, dict[str, Any]]:
        """Begin all episodes.

        Parameters
        ----------
        seed
            One for each, or one: the others have those that follow it.
        options
            `start_m`: a place in m for each, in place of those that are drawn.

        Raises
        ------
        ModelError
            Seeds or options that do not fit.
        ControlError, ContactError, EquilibriumError
            An episode cannot begin there.
        """
        count = self.num_envs
        seeds = [seed + i for i in range(count)] if isinstance(seed, int) else seed
        starts: Any = checked_options(options)
        for one in (seeds, starts):
            is_list = isinstance(one, Sequence | np.ndarray)
            if one is not None and not (is_list and len(one) == count):
                raise ModelError(
                    "seed and start_m of a reset",
                    got=repr(one)[:80],
                    expected=f"one for each of {count} episodes",
                )
        for number, own in enumerate(seeds or []):
            if own is not None:
                self._randoms[number] = seeding.np_random(own)[0]
        places = self._drawn(np.arange(count)) if starts is None else [float(x) for x in starts]
        self._begin(np.arange(count), places)
        self._ended = np.zeros(count, dtype=np.bool_)
        force = [self._episodes.static_force_N(row) for row in range(count)]
        there = np.ones(count, dtype=np.bool_)
        info = {"start_m": np.array(places), "static_force_N": np.array(force)}
        return self._seen.copy(), {**info, **{f"_{name}": there for name in info}}

    def step(self, actions: Any) -> tuple[Floats, Floats, Flags, Flags, dict[str, Any]]:
        """Take a sample of all episodes, with a force for each; see `PantographEnv.step`.

        Raises
        ------
        ControlError
            Not one finite number for each, no `reset` before, or an episode that cannot begin.
        """
        if self._ended is None:
            raise ControlError("no episode has begun", expected="a call of `reset` before `step`")
        count = self.num_envs
        wanted = forces(self.task, actions, (count, 1))
        stepped, begun = np.flatnonzero(~self._ended), np.flatnonzero(self._ended)
        rewards, flags = np.zeros(count), np.zeros((2, count), dtype=np.bool_)
        info: dict[str, Any] = {}
        if len(stepped):
            outcome = self._episodes.step(stepped, wanted[stepped])
            self._seen[stepped], rewards[stepped] = outcome.observation, outcome.reward
            failed = np.array([failure is not None for failure in outcome.failures])
            flags[0, stepped], flags[1, stepped] = failed, outcome.finished & ~failed
            info = self._spread(stepped, told(outcome))
            if failed.any():
                reasons = np.full(count, None, dtype=object)
                reasons[stepped] = outcome.failures
                info["failure"], info["_failure"] = reasons, flags[0].copy()
        if len(begun) and self._autoreset:
            self._begin(begun, self._drawn(begun))
        self._ended = flags.any(axis=0) | (self._ended & (not self._autoreset))
        return self._seen.copy(), rewards, flags[0], flags[1], info

    def describe(self) -> dict[str, Any]:
        """Return all that defines the task, as plain data with units in the names."""
        return self.task.describe()

    def _drawn(self, rows: NDArray[np.intp]) -> list[float]:
        return [drawn(self.task, self._randoms[row]) for row in rows]

    def _begin(self, rows: NDArray[np.intp], places: list[float]) -> None:
        self._seen[rows] = self._episodes.begin(rows, places)

    def _spread(self, rows: NDArray[np.intp], values: dict[str, Floats]) -> dict[str, Any]:
        """Return values of some episodes as Gymnasium has them: with zeros, and who has one."""
        there = np.zeros(self.num_envs, dtype=np.bool_)
        there[rows] = True
        spread: dict[str, Any] = {}
        for name, own in values.items():
            spread[name] = np.zeros(self.num_envs)
            spread[name][rows] = own
            spread[f"_{name}"] = there
        return spread
