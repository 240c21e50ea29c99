"""Heights of the strips of an FMU within a step: what its contact forces will make of them.

Within a step the line takes the strips as

    z = z₀ − S λ                                                                           (1)

with the heights z at the end of the step, m, and the contact forces λ that are held over it, N.

An FMU holds its inputs over a step, as if they were the force at its middle. The force F of a step
of the line belongs to the time at which its scheme balances forces, θ h after its start: at the end
of explicit steps. The force at the middle is, between that of the step before and this one,

    λ = w F + (1 − w) F₋₁,   w = 3/2 − θ                                                   (2)

without which coupling would be of first order in the step. For the line the strips then are
z = (z₀ − (1 − w) S F₋₁) − w S F.

**An FMU whose state can be saved** is asked: it takes the step without forces, z₀, and once for
each strip with a force P on that one alone, z_j:   S e_j = (z₀ − z_j)/P. P is the force of the step
before: the line (1) then passes through what the FMU does without a force and with that one, which
is near the force to come. A linear FMU has one S for all steps, so it is kept as long as what
the FMU does meets (1); after a step that does not, it is measured again.

**An FMU whose state cannot be saved** goes only forward. A strip of mass m under forces that are
held has, with all other forces R on it,

    z_{n+1} − 2 z_n + z_{n−1} = s (2 R − λ_{n+1} − λ_n),   s = h²/2m

so that, with R as in the step before (its error is of the third order in h),

    z₀ = 2 z_n − z_{n−1} + (z_n − 2 z_{n−1} + z_{n−2}) + s λ_{n−1},   S = s I

Either way the FMU then takes the step with the forces λ that were found, and what it reaches is the
state; the difference to (1) is an error of that one step, and is reported.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from arcless.errors import FmuError

Floats = NDArray[np.float64]
# Returns the heights in m at the end of a step for each of the given forces in N, row by row.
Trial = Callable[[Floats], Floats]

# Share of the rise S λ by which a step may miss (1) before S is measured again. Tighter, rounding
# of heights of some metres would count (1e-15 m of 1e-5 m); looser, σ would feel it.
LINEAR = 1e-6
# Least force in N of a trial: where there was no contact the one before is none.
LEAST_TRIAL = 1.0
# Share of the largest entry of S that may be negative or not symmetric: two forces of a step and
# their heights are known to rounding. More is an FMU that gives energy away.
ROUNDED = 1e-2


@dataclass
class MeasuredHeights:
    """Heights of an FMU that can be evaluated for several forces in one step.

    Attributes
    ----------
    trial
        Asks it.
    measured
        Number of steps in which S was measured.
    """

    trial: Trial
    measured: int = 0
    _compliance: Floats | None = None

    def predict(self, before: Floats) -> tuple[Floats, Floats]:
        """Return z₀ in m and S in m/N of a step, given the forces of the step before in N."""
        count = len(before)
        if self._compliance is not None:
            return self.trial(np.zeros((1, count)))[0], self._compliance
        pushed = np.maximum(before, LEAST_TRIAL)
        found = self.trial(np.vstack([np.zeros(count), np.diag(pushed)]))
        self.measured += 1
        self._compliance = sound((found[0] - found[1:]).T / pushed)
        return found[0], self._compliance

    def reached(self, heights: Floats, expected: Floats, rise: Floats) -> None:
        """Take what a step has reached, what (1) said, and its S λ, all in m."""
        if np.max(np.abs(heights - expected)) > LINEAR * np.max(np.abs(rise), initial=0.0):
            self._compliance = None


@dataclass
class ExtrapolatedHeights:
    """Heights of an FMU that only goes forward, extrapolated from the steps before.

    Attributes
    ----------
    yielding
        s of the equation above, m/N.
    heights
        Heights at the start, m.
    forces
        Forces at the start, N.
    """

    yielding: float
    heights: Floats
    forces: Floats
    measured: int = field(default=0, init=False)
    _past: list[Floats] = field(default_factory=list, init=False)
    _forces: list[Floats] = field(default_factory=list, init=False)

    def __post_init__(self) -> None:
        self._past, self._forces = [self.heights] * 3, [self.forces] * 2

    def predict(self, before: Floats) -> tuple[Floats, Floats]:
        """Return z₀ in m and S in m/N of a step, given the forces of the step before in N."""
        old, last, now = self._past
        self._forces = [self._forces[1], before]
        # In increments: the heights themselves are large.
        free = now + (now - last) + ((now - last) - (last - old))
        return free + self.yielding * self._forces[0], self.yielding * np.eye(len(before))

    def reached(self, heights: Floats, expected: Floats, rise: Floats) -> None:  # noqa: ARG002
        """Take what a step has reached, in m."""
        self._past = [*self._past[1:], heights]


def sound(compliance: Floats) -> Floats:
    """Return a compliance in m/N, symmetric apart from rounding as a symmetric one.

    Raises
    ------
    FmuError
        A contact force raises its strip, or the forces of two strips do not act alike.
    """
    largest = float(np.max(np.abs(compliance)))
    lopsided = float(np.max(np.abs(compliance - compliance.T)))
    symmetric: Floats = (compliance + compliance.T) / 2.0
    least = float(np.linalg.eigvalsh(symmetric)[0])
    if lopsided > ROUNDED * largest:
        raise FmuError(
            "the strips of the FMU do not act on each other alike",
            got=f"a compliance that is {lopsided / largest:.2g} of itself not symmetric",
            expected="the rise of one strip by a force on the other the same both ways",
            hint="look at the order of contact_force and strip_height",
        )
    if least < -ROUNDED * largest:
        raise FmuError(
            "a contact force raises a strip of the FMU",
            got=f"a compliance of {least:.3g} m/N",
            expected="a strip that a positive contact force pushes down",
            hint="contact_force is positive when it pushes down, strip_height upwards",
        )
    # Rounding makes a little less than zero of zero.
    return symmetric + max(0.0, -least) * np.eye(len(symmetric))
