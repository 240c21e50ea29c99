"""Environment of Gymnasium: one pantograph on one line, its controlled force as the action."""

from collections.abc import Mapping
from typing import Any, cast

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from arcless.control.episodes import Episodes, Outcome
from arcless.control.task import Task, task
from arcless.errors import ControlError, ModelError

Floats = NDArray[np.float64]
ALL = np.array([0], dtype=np.intp)


def action_space(of: Task) -> spaces.Space[Floats]:
    """Return the forces that may be asked for, in the unit of the task."""
    low, high = of.controller.minimum_force, of.controller.maximum_force
    assert low is not None
    assert high is not None
    unit = of.action_unit_N
    return cast("spaces.Space[Floats]", spaces.Box(low / unit, high / unit, (1,), np.float64))


def observation_space(of: Task) -> spaces.Space[Floats]:
    """Return the ranges of the signals that are seen, in their units."""
    low = np.array([signal.low for signal in of.signals])
    high = np.array([signal.high for signal in of.signals])
    return cast("spaces.Space[Floats]", spaces.Box(low, high, dtype=np.float64))


def forces(of: Task, action: Any, shape: tuple[int, ...]) -> Floats:
    """Return an action of a shape as the forces of its episodes, N.

    Raises
    ------
    ControlError
        Not one finite number for each.
    """
    try:
        given = np.asarray(action, dtype=np.float64)
    except (TypeError, ValueError):
        given = np.full(0, np.nan)
    if given.shape != shape:
        raise ControlError(
            "an action of the wrong shape",
            where="action",
            got=f"{' '.join(repr(action).split())[:60]}, of the shape {given.shape}",
            expected=f"forces of the shape {shape}, in units of {of.action_unit_N:g} N",
        )
    if not np.isfinite(given).all():
        raise ControlError(
            "an action that is not finite",
            where="action",
            got=str(given.ravel().tolist())[:80],
            expected=f"forces in units of {of.action_unit_N:g} N",
        )
    return of.action_unit_N * given.reshape(-1)


def checked_options(options: Mapping[str, Any] | None) -> Any:
    """Return the start in m that options of `reset` name; None where they name none.

    Raises
    ------
    ModelError
        An option that is not known.
    """
    for name in options or {}:
        if name != "start_m":
            raise ModelError(
                "unknown option of reset",
                where="options",
                got=repr(name)[:80],
                expected="start_m, where the lead-in begins, in m",
            )
    return (options or {}).get("start_m")


def drawn(of: Task, random: np.random.Generator) -> float:
    """Return the place in m where an episode begins, every part of a span being as likely."""
    return of.spans_of_line.place_at(float(random.uniform(*of.begin_between)))


class PantographEnv(gymnasium.Env[Floats, Floats]):
    """A pantograph on a line, stepped a sample of its controller at a time.

    An episode is a whole number of spans, begun at a place that the seed draws, after a lead-in
    without control. At its end it is truncated. It is terminated where a step fails, the pantograph
    leaves the wire or a signal its range; ``info["failure"]`` says why.

    Parameters
    ----------
    render_mode
        None, or "ansi": `render` returns a line of text.
    **settings
        See `arcless.control.task`; or ``task=``, one that is prepared.
    """

    # Frames of a second at the sample time of `ACTUATOR`.
    metadata: dict[str, Any] = {"render_modes": ["ansi"], "render_fps": 200}  # noqa: RUF012

    def __init__(
        self, *, render_mode: str | None = None, task: Task | None = None, **settings: Any
    ) -> None:
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ModelError(
                "unknown render_mode", got=repr(render_mode)[:80], expected="ansi, or none"
            )
        self.task = prepared(task, settings)
        self.render_mode = render_mode
        self.action_space = action_space(self.task)
        self.observation_space = observation_space(self.task)
        self._episodes = Episodes(self.task, 1, workers=1)
        self._ended, self._last = True, "no episode has begun"

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats, dict[str, Any]]:
        """Begin an episode.

        Parameters
        ----------
        seed
            Seed of the places where this and the following episodes begin.
        options
            `start_m`: the place where the lead-in begins, in m, in place of one that is drawn.

        Returns
        -------
        What is seen, and what is known of the start.

        Raises
        ------
        ModelError
            An option that does not fit.
        ControlError, ContactError, EquilibriumError
            The episode cannot begin there.
        """
        super().reset(seed=seed)
        start = checked_options(options)
        place = drawn(self.task, self.np_random) if start is None else start
        seen = self._episodes.begin(ALL, [place])
        self._ended, self._last = False, f"begun at {place:.2f} m"
        return seen[0], {
            "start_m": place,
            "position_m": self._episodes.place_m(0),
            "static_force_N": self._episodes.static_force_N(0),
        }

    def step(self, action: Any) -> tuple[Floats, float, bool, bool, dict[str, Any]]:
        """Take a sample with a force, in units of ``task.action_unit_N``.

        Beyond the limits of the actuator the force is that of the limit, as in a run;
        ``info["force_N"]`` is the one that acts.

        Raises
        ------
        ControlError
            The action is not one finite number, or the episode has ended.
        """
        if self._ended:
            raise ControlError("the episode has ended", expected="a call of `reset` before `step`")
        outcome = self._episodes.step(ALL, forces(self.task, action, (1,)))
        info = {name: values[0] for name, values in told(outcome).items()}
        info["position_m"] = self._episodes.place_m(0)
        info["time_s"] = self._episodes.time_s(0)
        failure = outcome.failures[0]
        if failure is not None:
            info["failure"] = failure
        terminated = failure is not None
        truncated = bool(outcome.finished[0]) and not terminated
        self._ended = terminated or truncated
        self._last = (
            f"{info['position_m']:.2f} m, {info['force_N']:.1f} N controlled, contact force"
            f" {info['mean_force_N']:.1f} ± {info['std_force_N']:.1f} N"
        )
        return outcome.observation[0], float(outcome.reward[0]), terminated, truncated, info

    def render(self) -> str | None:
        """Return place, force and contact force as a line of text; None without a render mode."""
        return self._last if self.render_mode == "ansi" else None

    def describe(self) -> dict[str, Any]:
        """Return all that defines the task, as plain data with units in the names."""
        return self.task.describe()


def prepared(given: Task | None, settings: Mapping[str, Any]) -> Task:
    """Return a task that is given, or make that of the settings.

    Raises
    ------
    ModelError
        Both are given, or a setting is not known.
    """
    if given is not None and not settings:
        return given
    if given is not None:
        raise ModelError(
            "a task and settings of one", got=", ".join(settings), expected="one of the two"
        )
    try:
        return task(**settings)
    except TypeError as error:
        known = ", ".join(task.__kwdefaults__ or {})
        raise ModelError(
            "settings of an environment",
            got=", ".join(settings),
            expected=f"scenario, {known}",
        ) from error


def told(outcome: Outcome) -> dict[str, Floats]:
    """Return what is told of a sample: parts of the reward, and the force."""
    scores = outcome.scores
    return {
        "std_force_N": scores.std_force_N,
        "mean_force_N": scores.mean_force_N,
        "lost": scores.lost,
        "effort_N": scores.effort_N,
        "force_N": outcome.force_N,
    }
