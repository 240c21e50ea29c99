"""Runs of strips along a straight wire of either family: what a force or a kink adds to them.

All is linear while contacts hold, so the run without it is taken away: what is left began at
nothing. Forces are small: the square of the wire's slopes, times EA/T, is what tension adds.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import butter, sosfiltfilt

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model.pantograph.pantograph import Pantograph
from arcless.simulate.setup import pantographs
from tests.support.families import Family
from tests.support.straight import Floats, Straight
from tests.support.waves import Waves

KMH = 1.0 / 3.6
SPEEDS = (275.0 * KMH, 320.0 * KMH)  # m/s
STEP = 5e-4  # s
PRESSED = 12.0  # N
FILTER, SHARP = 20.0, 3  # Hz, order


@dataclass(frozen=True)
class Travel:
    """Strips that follow each other along a wire.

    Attributes
    ----------
    family, strips, contact : elements, pantographs, and stiffness of the contact in N/m
    start, speed, last : of the first strip, m and m/s; until when, s
    behind : of each strip behind the first, m
    """

    family: Family
    strips: Sequence[Pantograph]
    contact: float
    start: float
    speed: float
    last: float
    behind: Sequence[float] = (0.0,)

    @property
    def time(self) -> Floats:
        """Start and end of each step, s."""
        return STEP * np.arange(round(self.last / STEP) + 1)

    def run(self, line: Equilibrium, forces: Sequence[Floats]) -> "Travelled":
        """Run, with forces in N on the strips that begin with nothing."""
        time = self.time
        scheme, corrected = self.family.scheme, not self.family.is_chain
        prepared = line.core.prepare(line.mesh.lanes, scheme, STEP, self.contact, False, corrected)
        plan = {"contact_every": 1, "line_every": 1, "links": False, "nodes": [], "points": []}
        given = [([([1.0], (f - f[0]).tolist())], None) for f in forces]
        raw = prepared.run(
            [
                pantographs.rider(strip, PRESSED, own)
                for strip, own in zip(self.strips, given, strict=True)
            ],
            list(self.behind),
            (self.start + self.speed * time).tolist(),
            [self.speed] * len(time),
            0.0,
            [],
            {**plan, "ledger": False, "ledger_every": 1},
            lambda _step: True,
        )
        shape = (len(raw["time"]), len(self.strips))
        return Travelled(raw["time"], raw["height"].reshape(shape), raw["force"].reshape(shape))


@dataclass(frozen=True)
class Travelled:
    """Times of balance, s; height of the wire at each strip, m; contact forces, N."""

    time: Floats
    height: Floats
    force: Floats

    def __sub__(self, calm: "Travelled") -> "Travelled":
        """What one run has more than another in which nothing happens."""
        assert min(self.force.min(), calm.force.min()) > 0.0, "a contact is lost"
        return Travelled(self.time, self.height - calm.height, self.force - calm.force)


def filtered(values: Floats) -> Floats:
    """Values without what is above 20 Hz, and without delay."""
    sections = butter(SHARP, FILTER, fs=1.0 / STEP, output="sos")
    return np.asarray(sosfiltfilt(sections, values))


def along(line: Straight, waves: Waves, speed: float) -> tuple[Waves, float]:
    """Return wave and speed along a wire that runs across the track as well."""
    steeper = float(np.hypot(1.0, line.slant or 0.0))
    return Waves(waves.tension * steeper, waves.density, waves.bending), speed * steeper
