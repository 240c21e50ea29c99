"""Runs of strips along a straight wire of either family: what a force or a kink adds to them.

All is linear while contacts hold, so the run without it is taken away: what is left began at
nothing. Forces are small: the square of the wire's slopes, times EA/T, is what tension adds.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pytest
from scipy.signal import butter, sosfiltfilt

from arcless.equilibrium.equilibrium import Equilibrium
from arcless.model.pantograph.pantograph import Pantograph
from arcless.simulate.setup import pantographs
from arcless.simulate.setup.core_data import Excitation, ForceHistory, LoadData, RecordPlan
from tests.support.families import Family
from tests.support.straight import Floats

KMH = 1.0 / 3.6
SPEEDS = (275.0 * KMH, 320.0 * KMH)  # m/s
# The second one shows the same at another place of the same formulas.
AT_SPEEDS = [SPEEDS[0], pytest.param(SPEEDS[1], marks=pytest.mark.evidence)]
# So does a line in space, which takes cubic elements longer.
CHAIN_FIRST = ["chain", pytest.param("cubic", marks=pytest.mark.evidence)]
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

    def run(
        self, line: Equilibrium, forces: Sequence[Floats], *, loads: Sequence[LoadData] = (),
        nodes: Sequence[int] = (),
    ) -> "Travelled":  # fmt: skip
        """Run, with forces in N on the strips that begin with nothing, and loads on the wire."""
        time = self.time
        scheme, corrected = self.family.scheme, not self.family.is_chain
        model = line.core.prepare(
            lanes=line.mesh.lanes, scheme=scheme, step=STEP, contact_stiffness=self.contact,
            updated=False, period_correction=corrected,
        )  # fmt: skip
        given = [Excitation([ForceHistory([1.0], (f - f[0]).tolist())]) for f in forces]
        raw = model.run(
            pantographs=[
                pantographs.data(strip, PRESSED, own)
                for strip, own in zip(self.strips, given, strict=True)
            ],
            distances=list(self.behind),
            positions=self.start + self.speed * time,
            speeds=[self.speed] * len(time),
            friction=0.0,
            loads=list(loads),
            plan=RecordPlan(
                contact_every=1, line_every=1, links=False, nodes=nodes, supports=[], points=[],
                ledger=False, ledger_every=1,
            ),
            observe=lambda _step: True,
        )  # fmt: skip
        shape = (len(raw["time"]), len(self.strips))
        return Travelled(
            raw["time"], raw["height"].reshape(shape), raw["force"].reshape(shape),
            raw["uplift"].reshape(shape[0], -1),
        )  # fmt: skip


@dataclass(frozen=True)
class Travelled:
    """Times of balance, s; height of the wire at each strip, m; contact forces, N.

    `nodes` is the uplift of those asked for, m.
    """

    time: Floats
    height: Floats
    force: Floats
    nodes: Floats

    def __sub__(self, calm: "Travelled") -> "Travelled":
        """Return the excess of one run over another in which nothing happens."""
        assert min(self.force.min(), calm.force.min()) > 0.0, "a contact is lost"
        return Travelled(
            self.time, self.height - calm.height, self.force - calm.force, self.nodes - calm.nodes
        )


def filtered(values: Floats) -> Floats:
    """Values without what is above 20 Hz, and without delay."""
    sections = butter(SHARP, FILTER, fs=1.0 / STEP, output="sos")
    return np.asarray(sosfiltfilt(sections, values))
