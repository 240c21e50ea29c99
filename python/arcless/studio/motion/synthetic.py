"""Motion whose values are known: a wave that runs along a wire, and a pantograph below it.

u(x, t) = a exp(−((x − x₀ − c t)/b)²), a solution of the wave equation by d'Alembert: it keeps its
form and runs at the wave speed c. It serves tests, and the page where nothing was computed.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from arcless.studio.motion.channels import (
    Channel,
    Moment,
    MotionSource,
    Piece,
    Singles,
    pantograph_channel,
    rows_between,
)


@dataclass
class SyntheticMotion:
    """A wave of height a, width b, in m, at the speed c in m/s on nodes 1 m apart."""

    nodes: int = 1000
    height_m: float = 0.05
    width_m: float = 5.0
    speed_m_s: float = 100.0
    every_s: float = 0.005
    end_s: float = 5.0
    start_s: float = 0.0
    final: bool = True
    later: MotionSource | None = None
    search: int | None = None

    @property
    def estimated_end_s(self) -> float:
        """Time in s of the last row."""
        return self.end_s

    @property
    def channels(self) -> list[Channel]:
        """One wire and one pantograph."""
        return [Channel("wire.0.up", "m", self.nodes), pantograph_channel(0, "wave", [])]

    def uplift(self, time_s: float) -> Singles:
        """Return the uplift u in m of all nodes at a time in s."""
        x = np.arange(self.nodes) - self.speed_m_s * time_s
        found: Singles = (self.height_m * np.exp(-((x / self.width_m) ** 2))).astype(np.float32)
        return found

    def moments(self, from_s: float, to_s: float, every_s: float) -> Iterator[Moment]:
        """Yield moments between two times in s; see `MotionSource`."""
        times = np.arange(self.start_s, self.end_s + self.every_s / 2, self.every_s)
        for row in rows_between(times, from_s, to_s, every_s):
            time_s = float(times[row])
            place = np.array([self.speed_m_s * time_s, 0.0, 0.0, self.height_m], np.float32)
            yield [Piece(0, 0, time_s, self.uplift(time_s)), Piece(1, 0, time_s, place)]
