"""Scenario → what the core needs to step: travel, scheme, contact."""

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from arcless.errors import ModelError
from arcless.model import Scenario
from arcless.model.scenario.step_rules import MAX_STEPS
from arcless.model.settings.schemes import (
    GeneralisedAlpha,
    HilberHughesTaylor,
    Newmark,
    Scheme,
    Trapezoidal,
)

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Motion:
    """Position in m of the first pantograph and speed in m/s, at the start and after each step."""

    positions: Floats
    speeds: Floats
    time_step: float

    @property
    def steps(self) -> int:
        """Number of time steps."""
        return len(self.positions) - 1

    @property
    def duration(self) -> float:
        """Simulated time in s."""
        return self.steps * self.time_step


def motion(scenario: Scenario) -> Motion:
    """Lay out the travel of a scenario.

    Between the points of a speed profile the speed is linear, so positions are exact; after its
    last point the run ends.

    Raises
    ------
    ModelError
        The travel takes no step, or more than can be recorded.
    """
    start, end = scenario.travel_range()
    h = scenario.time_step_s
    if scenario.speed_profile is None:
        speed = scenario.speed or 0.0
        count = _bounded((end - start) / speed / h)
        times = h * np.arange(count + 1, dtype=np.float64)
        return Motion(start + speed * times, np.full(count + 1, speed), h)
    profile = scenario.speed_profile
    count = _bounded(profile.time[-1] / h)
    times = h * np.arange(count + 1, dtype=np.float64)
    speeds = np.interp(times, profile.time, profile.speed)
    positions = start + _distance(times, np.array(profile.time), np.array(profile.speed))
    inside = int(np.searchsorted(positions, end, side="right"))
    if inside <= 1:
        raise ModelError(
            "the run takes no step", where="speed_profile", expected="a speed above 0 at the start"
        )
    return Motion(positions[:inside], speeds[:inside], h)


def _bounded(steps: float) -> int:
    # A trifle is added so that a travel of whole steps is not one short by rounding.
    count = int(steps + 1e-9)
    if not 1 <= count <= MAX_STEPS:
        raise ModelError(
            "number of time steps",
            got=f"{steps:.3g}",
            expected=f"1 to {MAX_STEPS}",
            hint="change travel, speed or solver.time_step",
        )
    return count


def _distance(times: Floats, knots: Floats, speeds: Floats) -> Floats:
    """Return the exact integral of the piecewise linear speed from 0 to each time."""
    whole = np.concatenate([[0.0], np.cumsum(np.diff(knots) * (speeds[1:] + speeds[:-1]) / 2.0)])
    piece = np.clip(np.searchsorted(knots, times, side="right") - 1, 0, len(knots) - 2)
    since = times - knots[piece]
    slope = (speeds[piece + 1] - speeds[piece]) / (knots[piece + 1] - knots[piece])
    return np.asarray(whole[piece] + since * (speeds[piece] + 0.5 * slope * since))


def scheme_numbers(scheme: Scheme) -> tuple[str, list[float]]:
    """Return the name and the parameters of a scheme; see the core's `scheme` for the equations."""
    if isinstance(scheme, Newmark):
        return scheme.name, [scheme.beta, scheme.gamma]
    if isinstance(scheme, HilberHughesTaylor):
        # The core counts alpha from 0 to 1/3.
        return scheme.name, [-scheme.alpha]
    if isinstance(scheme, GeneralisedAlpha):
        return scheme.name, [scheme.spectral_radius]
    return scheme.name, []


def time_of_balance(scheme: Scheme) -> float:
    """Return the part of a step after which a scheme balances forces: 1 at its end."""
    if isinstance(scheme, Trapezoidal):
        return 0.5
    if isinstance(scheme, HilberHughesTaylor):
        return 1.0 + scheme.alpha
    if isinstance(scheme, GeneralisedAlpha):
        return 1.0 / (1.0 + scheme.spectral_radius)
    return 1.0


def contact_stiffness(scenario: Scenario) -> float:
    """Return the stiffness of the contact in N/m; infinite when rigid."""
    return inf if scenario.contact.law == "rigid" else scenario.contact.stiffness
